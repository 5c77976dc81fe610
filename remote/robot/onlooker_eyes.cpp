#include "remote/robot/onlooker_eyes.hpp"

#include <sys/stat.h>

#include <stdexcept>
#include <utility>

#include "hal/shared_picture/reader.hpp"
#include "remote/jpeg/live_pictures.hpp"
#include "runtime/clock.hpp"

namespace darwinop::remote {
namespace {

LivePictures::Options onlookerOptions(const FrameLooker& look_at, const Teller& say) {
  return {.now = [] { return runtime::MonotonicClock{}.now(); }, .say = say, .look_at = look_at};
}

}  // namespace

std::unique_ptr<PictureSource> openPicturesOfCamera(std::unique_ptr<FrameSource> camera, const FrameLooker& look_at,
                                                    const Teller& say) {
  return std::make_unique<LivePictures>(std::move(camera), onlookerOptions(look_at, say));
}

std::unique_ptr<PictureSource> openPicturesOfDriver(const runtime::RuntimeFiles& files, const FrameLooker& look_at,
                                                    const Teller& say) {
  struct stat exchange {};
  if (stat(files.exchange.c_str(), &exchange) != 0) throw std::runtime_error("there is no runtime");
  return std::make_unique<LivePictures>(std::make_unique<shared_picture::Reader>(shared_picture::Reader::Options{
                                            .files = {files.pictures, files.pictures_asked},
                                            .group = exchange.st_gid,
                                            .now = [] { return runtime::MonotonicClock{}.now(); },
                                            .say = say}),
                                        onlookerOptions(look_at, say));
}

}  // namespace darwinop::remote
