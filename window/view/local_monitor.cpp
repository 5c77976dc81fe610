// Monitor of a robot on this computer, with camera or rendered pictures.
#include "window/view/local_monitor.hpp"

#include <utility>

#include "connect/camera.hpp"
#include "hil-mocks/camera/painted_pictures.hpp"
#include "remote/jpeg/live_pictures.hpp"
#include "remote/robot/observer_pictures.hpp"
#include "runtime/clock.hpp"

namespace darwinop::window {
namespace {

Nanos monotonicTime() {
  return runtime::MonotonicClock{}.now();
}

/// Pictures that the virtual robot renders to a file. A second reader of the same file reports why there are none.
class RenderedPictures final : public remote::PictureSource {
 public:
  RenderedPictures(const std::string& file, bool set_size, remote::FrameCallback on_frame)
      : status_{file, set_size},
        pictures_{std::make_unique<hil::PaintedPictures>(file, false),
                  {.now = monotonicTime, .log = {}, .on_frame = std::move(on_frame)}} {}

  remote::JpegPicture newest() override { return pictures_.newest(); }
  [[nodiscard]] std::string error() const override {
    const std::string why = status_.error();
    return why.empty() ? why : "the virtual robot cannot render camera pictures: " + why;
  }

 private:
  hil::PaintedPictures status_;
  remote::LivePictures pictures_;
};

}  // namespace

std::unique_ptr<monitor::Monitor> makeLocalMonitor(const runtime::RuntimeFiles& files, const std::string& rendered,
                                                   const std::shared_ptr<monitor::ColourSearch>& search,
                                                   const std::function<void(const std::string&)>& log) {
  const remote::FrameCallback find = [search](const CameraFrame& frame) { search->process(frame); };
  monitor::CameraSource::Open camera = [find, log] {
    return remote::openPicturesOfCamera(connect::openLocalCamera({.form = PictureForm::kYuyv, .log = log}), find, log);
  };
  monitor::CameraSource::Open share = [files, find, log] { return remote::openPicturesOfDriver(files, find, log); };
  if (!rendered.empty()) {
    camera = [rendered, find] { return std::make_unique<RenderedPictures>(rendered, true, find); };
    share = [rendered, find] { return std::make_unique<RenderedPictures>(rendered, false, find); };
  }
  auto monitor = std::make_unique<monitor::Monitor>(files, monotonicTime, std::move(camera), std::move(share), search);
  monitor->keepCameraForObservers();  // the page drives without the camera
  return monitor;
}

}  // namespace darwinop::window
