// Camera controls as written to the driver.
#include <linux/videodev2.h>

#include <cerrno>
#include <cstring>
#include <map>
#include <utility>

#include "hal/camera_v4l2/bench.hpp"
#include "hal/camera_v4l2/quirks.hpp"

namespace darwinop::v4l2 {
namespace {

using testing::HasSubstr;
using Written = std::vector<std::pair<std::uint32_t, int>>;

bool isExposureMode(unsigned long request, const void* argument) {
  return (request == VIDIOC_QUERYMENU && static_cast<const v4l2_querymenu*>(argument)->id == V4L2_CID_EXPOSURE_AUTO) ||
         (request == VIDIOC_QUERYCTRL && static_cast<const v4l2_queryctrl*>(argument)->id == V4L2_CID_EXPOSURE_AUTO) ||
         ((request == VIDIOC_G_CTRL || request == VIDIOC_S_CTRL) &&
          static_cast<const v4l2_control*>(argument)->id == V4L2_CID_EXPOSURE_AUTO);
}

/// A camera whose exposure is manual, or fully automatic (mode 0).
int answerFullyAutomatic(unsigned long request, void* argument) {
  if (request == VIDIOC_QUERYCTRL) {
    static_cast<v4l2_queryctrl*>(argument)->minimum = V4L2_EXPOSURE_AUTO;
    static_cast<v4l2_queryctrl*>(argument)->maximum = V4L2_EXPOSURE_MANUAL;
  }
  if (request == VIDIOC_G_CTRL) static_cast<v4l2_control*>(argument)->value = V4L2_EXPOSURE_MANUAL;
  const bool is_missing =
      request == VIDIOC_QUERYMENU && static_cast<v4l2_querymenu*>(argument)->index > V4L2_EXPOSURE_MANUAL;
  if (is_missing) errno = EINVAL;
  return is_missing ? -1 : 0;
}

/// Records writes; some controls may be disabled or fail.
struct Notes final : Quirk {
  int call(int fd, unsigned long request, void* argument) override {
    if (request == VIDIOC_S_CTRL) {
      const auto& control = *static_cast<const v4l2_control*>(argument);
      const std::lock_guard lock{mutex};
      written.emplace_back(control.id, control.value);
      if (control.id == refuses) {
        errno = EIO;
        return -1;
      }
    }
    if (only_fully_automatic && isExposureMode(request, argument)) return answerFullyAutomatic(request, argument);
    const int result = next(fd, request, argument);
    if (request == VIDIOC_QUERYCTRL && result == 0) {
      auto& about = *static_cast<v4l2_queryctrl*>(argument);
      if (about.id == disabled) about.flags |= V4L2_CTRL_FLAG_DISABLED;
      if (about.id == unknown) {
        errno = EINVAL;
        return -1;
      }
    }
    return result;
  }
  Written take() {
    const std::lock_guard lock{mutex};
    return std::exchange(written, {});
  }

  std::atomic<std::uint32_t> disabled{0}, unknown{0}, refuses{0};
  std::atomic<bool> only_fully_automatic{false};  // the exposure's menu has no aperture priority
  std::mutex mutex;
  Written written;
  const InForce in_force{*this};  // last member: destroyed first
};

/// The virtual camera keeps written values for the lifetime of the process.
void resetControls() {
  const V4l2Device device{"/dev/video0"};
  v4l2_control manual{V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL};  // exposure is writable in manual mode only
  ASSERT_EQ(request(device.fd(), VIDIOC_S_CTRL, manual), 0);
  for (const std::uint32_t id :
       {V4L2_CID_EXPOSURE_ABSOLUTE, V4L2_CID_EXPOSURE_AUTO, V4L2_CID_AUTO_WHITE_BALANCE, V4L2_CID_AUTOGAIN,
        V4L2_CID_HUE_AUTO, V4L2_CID_BRIGHTNESS, V4L2_CID_CONTRAST, V4L2_CID_SATURATION, V4L2_CID_GAIN}) {
    v4l2_queryctrl about{};
    about.id = id;
    ASSERT_EQ(request(device.fd(), VIDIOC_QUERYCTRL, about), 0);
    v4l2_control control{about.id, about.default_value};
    ASSERT_EQ(request(device.fd(), VIDIOC_S_CTRL, control), 0);
  }
}

struct SettingsTest : testing::Test {
  SettingsTest() {
    resetControls();
    notes.take();
  }
  Written writtenFor(const CameraSettings& settings) {
    CameraOptions options = fastOptions(log);
    options.settings = settings;
    Camera camera{options};
    waitForPicture(camera);
    return notes.take();
  }
  VirtualCamera device;
  LogCapture log;
  Notes notes;
};

TEST_F(SettingsTest, DisableAutomaticModesFirstAndThenSetWhatDiffers) {
  const Written expected{{V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL},
                         {V4L2_CID_AUTO_WHITE_BALANCE, 0},
                         {V4L2_CID_AUTOGAIN, 0},
                         {V4L2_CID_HUE_AUTO, 0},
                         {V4L2_CID_GAIN, 255},
                         {V4L2_CID_EXPOSURE_ABSOLUTE, 1000}};
  EXPECT_EQ(writtenFor({}), expected);
  EXPECT_EQ(writtenFor({}), Written{}) << "all values are already set";

  CameraSettings other;
  other.brightness = 130;
  other.auto_gain = true;
  other.gain = 200;
  const Written brighter{{V4L2_CID_AUTOGAIN, 1}, {V4L2_CID_BRIGHTNESS, 130}};
  EXPECT_EQ(writtenFor(other), brighter) << "automatic gain is not written";

  const Written back{{V4L2_CID_AUTOGAIN, 0}, {V4L2_CID_BRIGHTNESS, 128}};
  EXPECT_EQ(writtenFor({}), back) << "-1 is the driver's default";
  EXPECT_THAT(log.lines(), testing::IsEmpty());
}

TEST_F(SettingsTest, AutomaticExposureIsTheModeThatTheCameraOffers) {
  using testing::Contains;
  using testing::Pair;
  CameraSettings automatic;
  automatic.auto_exposure = true;
  writtenFor({});
  EXPECT_THAT(writtenFor(automatic), Contains(Pair(V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_APERTURE_PRIORITY)));
  notes.only_fully_automatic = true;
  EXPECT_THAT(writtenFor(automatic), Contains(Pair(V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_AUTO)));
  EXPECT_THAT(log.lines(), testing::IsEmpty());
}

TEST_F(SettingsTest, SkipDisabledAndMissingControls) {
  notes.disabled = V4L2_CID_BRIGHTNESS;
  notes.unknown = V4L2_CID_CONTRAST;
  CameraSettings settings;
  settings.brightness = settings.contrast = settings.saturation = 77;
  const Written written = writtenFor(settings);
  EXPECT_THAT(written, testing::Contains(testing::Pair(V4L2_CID_SATURATION, 77)));
  EXPECT_THAT(written, testing::Not(testing::Contains(testing::Pair(V4L2_CID_BRIGHTNESS, testing::_))));
  EXPECT_THAT(written, testing::Not(testing::Contains(testing::Pair(V4L2_CID_CONTRAST, testing::_))));
  EXPECT_THAT(log.lines(), testing::IsEmpty());
}

TEST_F(SettingsTest, ReportRejectedControlsOnce) {
  notes.refuses = V4L2_CID_CONTRAST;
  CameraOptions options = fastOptions(log);
  options.settings.exposure = 5000;  // the camera's range ends at 2047
  options.settings.contrast = 99;
  Camera camera{options};
  waitForPicture(camera);
  device.fault(CameraFault::kGone);
  ASSERT_TRUE(log.receives(messageOf(CameraError::kUnplugged)));
  device.fault(CameraFault::kNone);
  ASSERT_TRUE(log.receives(messageOfReturn()));
  const std::vector<std::string> lines = log.lines();
  EXPECT_EQ(lines.size(), 4u) << testing::PrintToString(lines);
  EXPECT_THAT(lines, testing::Contains(
                         testing::AllOf(HasSubstr("/dev/video0"), HasSubstr("exposure 5000"), HasSubstr("3 to 2047"))));
  EXPECT_THAT(lines, testing::Contains(testing::AllOf(HasSubstr("/dev/video0"), HasSubstr("contrast 99"),
                                                      HasSubstr(std::strerror(EIO)))));
  EXPECT_THAT(notes.take(), testing::Not(testing::Contains(testing::Pair(V4L2_CID_EXPOSURE_ABSOLUTE, testing::_))));
}

}  // namespace
}  // namespace darwinop::v4l2
