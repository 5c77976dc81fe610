// Camera pictures for observers.
#include "remote/robot/observer_pictures.hpp"

#include <sys/stat.h>

#include <stdexcept>
#include <utility>

#include "hal/shared_picture/reader.hpp"
#include "remote/jpeg/live_pictures.hpp"
#include "runtime/clock.hpp"

namespace darwinop::remote {
namespace {

LivePictures::Options observerOptions(const FrameCallback& on_frame, const LogCallback& log) {
  return {.now = [] { return runtime::MonotonicClock{}.now(); }, .log = log, .on_frame = on_frame};
}

}  // namespace

std::unique_ptr<PictureSource> openPicturesOfCamera(std::unique_ptr<FrameSource> camera, const FrameCallback& on_frame,
                                                    const LogCallback& log) {
  return std::make_unique<LivePictures>(std::move(camera), observerOptions(on_frame, log));
}

std::unique_ptr<PictureSource> openPicturesOfDriver(const runtime::RuntimeFiles& files, const FrameCallback& on_frame,
                                                    const LogCallback& log) {
  struct stat exchange {};
  if (stat(files.exchange.c_str(), &exchange) != 0) throw std::runtime_error("no runtime is running");
  return std::make_unique<LivePictures>(std::make_unique<shared_picture::Reader>(shared_picture::Reader::Options{
                                            .files = {files.pictures, files.pictures_asked},
                                            .group = exchange.st_gid,
                                            .now = [] { return runtime::MonotonicClock{}.now(); },
                                            .log = log}),
                                        observerOptions(on_frame, log));
}

}  // namespace darwinop::remote
