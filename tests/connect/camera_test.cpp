// Which camera a robot uses, and that it gets the user's settings.
#include "connect/camera.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "connect/messages.hpp"
#include "hil-mocks/camera/frame_painter.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::connect {
namespace {

using testing::HasSubstr;

class NoRobot final : public runtime::RobotLink {
 public:
  explicit NoRobot(bool real_time) : real_time_{real_time} {}
  [[nodiscard]] Nanos period() const override { return Nanos{16'000'000}; }
  [[nodiscard]] Nanos now() const override { return Nanos{0}; }
  [[nodiscard]] bool realTime() const override { return real_time_; }
  void publish(Commands /*commands*/) override {}
  [[nodiscard]] bool waitForCycle(std::uint64_t /*cycle*/, const std::atomic<bool>& /*stop*/) override { return false; }
  [[nodiscard]] Sensors sensors() const override { return {}; }
  [[nodiscard]] std::string whyEnded() const override { return {}; }

 private:
  bool real_time_;
};

/// A virtual camera at /dev/video7, and a robot.ini that names it.
class Seeing : public testing::Test {
 protected:
  Seeing() {
    setenv("DARWINOP_VIRTUAL_CAMERA", painter_.path().c_str(), 1);
    setenv("DARWINOP_VIRTUAL_CAMERA_DEVICE", "/dev/video7", 1);
    setenv("DARWINOP_ROBOT_FILE", (folder_ / "robot.ini").c_str(), 1);
    std::ofstream{folder_ / "robot.ini"} << "[Robot]\ncamera = /dev/video7\n";
  }
  ~Seeing() override {
    for (const char* name : {"DARWINOP_VIRTUAL_CAMERA", "DARWINOP_VIRTUAL_CAMERA_DEVICE", "DARWINOP_ROBOT_FILE"})
      unsetenv(name);
  }
  Seeing(const Seeing&) = delete;
  Seeing& operator=(const Seeing&) = delete;

  /// Until a picture has come.
  static CameraFrame firstFrame(FrameSource& source) {
    for (int tries = 0; tries < 1000; ++tries) {
      if (const CameraFrame frame = source.newest(); frame.sequence > 0) return frame;
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
    return {};
  }
  static int controlOf(std::uint32_t id) {
    const int fd = open("/dev/video7", O_RDWR);
    v4l2_control control{id, -1};
    EXPECT_EQ(ioctl(fd, VIDIOC_G_CTRL, &control), 0);
    close(fd);
    return control.value;
  }

  TemporaryFolder folder_;
  hil::FramePainter painter_{folder_ / "frames"};
  NoRobot robot_{true};
};

TEST_F(Seeing, IsThroughTheCameraThatTheRobotsFileNames) {
  const auto camera = openCamera(robot_, {.width = 640, .height = 480});
  const CameraFrame frame = firstFrame(*camera);
  EXPECT_EQ(frame.width, 640);
  EXPECT_EQ(frame.height, 480);
  EXPECT_TRUE(camera->health().seeing);
}

TEST_F(Seeing, GivesTheCameraTheUsersSettings) {
  CameraRequest request;
  request.settings.brightness = 17;
  request.settings.gain = 33;
  request.settings.exposure = 444;
  request.settings.auto_white_balance = true;
  const auto camera = openCamera(robot_, request);
  ASSERT_GT(firstFrame(*camera).sequence, 0U);
  EXPECT_EQ(controlOf(V4L2_CID_BRIGHTNESS), 17);
  EXPECT_EQ(controlOf(V4L2_CID_GAIN), 33);
  EXPECT_EQ(controlOf(V4L2_CID_EXPOSURE_ABSOLUTE), 444);
  EXPECT_EQ(controlOf(V4L2_CID_AUTO_WHITE_BALANCE), 1);
}

TEST_F(Seeing, ACameraThatIsNotThereIsReported) {
  std::ofstream{folder_ / "robot.ini"} << "[Robot]\ncamera = /dev/video_of_nobody\n";
  std::atomic<int> said{0};
  std::string sentence;
  CameraRequest request;
  request.log = [&](const std::string& what) {
    if (said == 0) sentence = what;
    ++said;
  };
  const auto camera = openCamera(robot_, request);
  for (int tries = 0; tries < 1000 && said == 0; ++tries) std::this_thread::sleep_for(std::chrono::milliseconds{10});
  EXPECT_THAT(sentence, HasSubstr("/dev/video_of_nobody"));
  EXPECT_EQ(camera->newest().sequence, 0U);
}

TEST_F(Seeing, GoesOnWhenObserversGetNoPictures) {
  CameraRequest request;
  request.observers.emplace(folder_ / "runtime");
  std::ofstream{request.observers->exchange};
  std::filesystem::create_directory(request.observers->pictures);  // where a file should be
  std::vector<std::string> said;
  request.log = [&](const std::string& what) { said.push_back(what); };
  auto camera = openLocalCamera(request);
  EXPECT_GT(firstFrame(*camera).sequence, 0U);
  camera.reset();  // nothing is logged after it
  EXPECT_THAT(said, testing::ElementsAre(testing::StartsWith(messages::kNoPicturesForObservers)));
}

TEST_F(Seeing, ARobotInSimulatedTimeHasNoCameraOfThisComputer) {
  NoRobot simulated{false};
  EXPECT_THAT([&] { (void)openCamera(simulated, {}); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("--robot twin")));
}

TEST_F(Seeing, AWrongRobotFileIsAnErrorWithItsLine) {
  std::ofstream{folder_ / "robot.ini"} << "[Robot]\ncamera =\n";
  EXPECT_THAT([&] { (void)openCamera(robot_, {}); }, testing::ThrowsMessage<std::runtime_error>(HasSubstr("line 2")));
}

}  // namespace
}  // namespace darwinop::connect
