// From a camera device to the picture in a reply.
#include <thread>

#include "hal/camera_v4l2/bench.hpp"
#include "remote/jpeg/live_pictures.hpp"
#include "remote/jpeg/scenes.hpp"

namespace darwinop::remote {
namespace {

using namespace std::chrono_literals;

TEST(LivePicturesOfACamera, EncodeItsFrames) {
  const Scene scene = room();
  const TemporaryFolder folder;
  hil::FramePainter painter{folder / "camera"};
  ::setenv("DARWINOP_VIRTUAL_CAMERA", painter.path().c_str(), 1);
  painter.paintYuyv({kWholeImage.width, kWholeImage.height}, scene.yuyv);

  v4l2::LogCapture log;
  v4l2::CameraOptions options = v4l2::fastOptions(log);
  options.form = PictureForm::kYuyv;
  const ImageSize size{160, 120};
  LivePictures pictures{
      std::make_unique<v4l2::Camera>(options),
      {size, qualityOf(size), [] { return std::chrono::steady_clock::now().time_since_epoch(); }, {}}};
  JpegPicture picture;
  ASSERT_TRUE(v4l2::waitFor([&] { return (picture = pictures.newest()).sequence != 0; }));
  EXPECT_GT(picture.age, 0ns);
  EXPECT_LT(picture.age, 20s);
  EXPECT_GT(psnr(scene, decoded({picture.jpeg.begin(), picture.jpeg.end()}, size), size), 28);
}

}  // namespace
}  // namespace darwinop::remote
