// The eye of the robot that a client drives, as JPEG.
#include "connect/eyes.hpp"
#include "remote/jpeg/live_pictures.hpp"
#include "remote/jpeg/lockstep_pictures.hpp"
#include "remote/robot/link_port.hpp"

namespace darwinop::remote {

std::unique_ptr<PictureSource> LinkPort::openPictures(ImageSize size, const v4l2::CameraSettings& settings,
                                                      const std::function<void(const std::string&)>& say) {
  const bool live = link_->realTime();
  std::unique_ptr<FrameSource> eye = connect::openEyes(*link_, {.width = kWholeImage.width,
                                                             .height = kWholeImage.height,
                                                             .settings = settings,
                                                             .form = live ? PictureForm::kYuyv : PictureForm::kBgra,
                                                             .say = say});
  runtime::RobotLink* const link = link_.get();
  if (!live)
    return std::make_unique<LockstepPictures>(std::move(eye), size, qualityOf(size), [link] { return link->now(); });
  return std::make_unique<LivePictures>(
      std::move(eye),
      LivePictures::Options{
          .size = size, .quality = qualityOf(size), .now = [] { return runtime::MonotonicClock{}.now(); }, .say = say});
}

}  // namespace darwinop::remote
