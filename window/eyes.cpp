#include "window/eyes.hpp"

#include <utility>

#include "connect/eyes.hpp"
#include "hil-mocks/camera/painted_pictures.hpp"
#include "remote/jpeg/live_pictures.hpp"
#include "remote/robot/onlooker_eyes.hpp"
#include "runtime/clock.hpp"

namespace darwinop::window {
namespace {

Nanos monotonicTime() {
  return runtime::MonotonicClock{}.now();
}

/// Knows why there are no pictures: `painted` and the thread that encodes look into the same file.
class PaintedEyes final : public remote::PictureSource {
 public:
  PaintedEyes(const std::string& file, bool set_size, remote::FrameLooker look_at)
      : trouble_{file, set_size},
        pictures_{std::make_unique<hil::PaintedPictures>(file, false),
                  {.now = monotonicTime, .say = {}, .look_at = std::move(look_at)}} {}

  remote::JpegPicture newest() override { return pictures_.newest(); }
  [[nodiscard]] std::string trouble() const override {
    const std::string why = trouble_.trouble();
    return why.empty() ? why : "the virtual robot cannot draw what it sees: " + why;
  }

 private:
  hil::PaintedPictures trouble_;
  remote::LivePictures pictures_;
};

}  // namespace

std::unique_ptr<monitor::Monitor> monitorWithEyes(const runtime::RuntimeFiles& files, const std::string& painted,
                                                  const std::shared_ptr<monitor::ColourSearch>& search,
                                                  const std::function<void(const std::string&)>& say) {
  const remote::FrameLooker find = [search](const CameraFrame& frame) { search->look(frame); };
  monitor::Eye::Open camera = [find, say] {
    return remote::openPicturesOfCamera(connect::openCamera({.form = PictureForm::kYuyv, .say = say}), find, say);
  };
  monitor::Eye::Open share = [files, find, say] { return remote::openPicturesOfDriver(files, find, say); };
  if (!painted.empty()) {
    camera = [painted, find] { return std::make_unique<PaintedEyes>(painted, true, find); };
    share = [painted, find] { return std::make_unique<PaintedEyes>(painted, false, find); };
  }
  auto monitor = std::make_unique<monitor::Monitor>(files, monotonicTime, std::move(camera), std::move(share), search);
  monitor->leaveCameraHere();  // the page drives without one
  return monitor;
}

}  // namespace darwinop::window
