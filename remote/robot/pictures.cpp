// Camera pictures of the robot for a client that drives.
#include "remote/jpeg/live_pictures.hpp"
#include "remote/jpeg/lockstep_pictures.hpp"
#include "remote/robot/link_port.hpp"

namespace darwinop::remote {

std::unique_ptr<PictureSource> LinkPort::openPictures(ImageSize size, const OpenFrames& open_frames,
                                                      const std::function<void(const std::string&)>& log) {
  runtime::RobotLink* const link = &session_->link();
  const bool live = link->realTime();
  std::unique_ptr<FrameSource> frames = open_frames(*link, live ? PictureForm::kYuyv : PictureForm::kBgra);
  if (!live)
    return std::make_unique<LockstepPictures>(std::move(frames), size, qualityOf(size), [link] { return link->now(); });
  return std::make_unique<LivePictures>(
      std::move(frames),
      LivePictures::Options{
          .size = size, .quality = qualityOf(size), .now = [] { return runtime::MonotonicClock{}.now(); }, .log = log});
}

}  // namespace darwinop::remote
