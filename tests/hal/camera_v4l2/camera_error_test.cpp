// Camera error messages.
#include "hal/camera_v4l2/camera_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <fstream>

#include "support/temporary_folder.hpp"

namespace darwinop::v4l2 {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(CameraErrorTest, IsFoundByErrno) {
  EXPECT_EQ(cameraErrorOf(ENOENT), CameraError::kAbsent);
  EXPECT_EQ(cameraErrorOf(ENODEV), CameraError::kAbsent);
  EXPECT_EQ(cameraErrorOf(EACCES), CameraError::kForbidden);
  EXPECT_EQ(cameraErrorOf(EBUSY), CameraError::kBusy);
  EXPECT_EQ(cameraErrorOf(ENOTTY), CameraError::kNotACamera);
  EXPECT_EQ(cameraErrorOf(ENOSPC), CameraError::kNoBandwidth);
  EXPECT_EQ(cameraErrorOf(ENOMEM), CameraError::kOutOfMemory);
  EXPECT_EQ(cameraErrorOf(EIO), CameraError::kReadErrors);
  EXPECT_EQ(cameraErrorOf(ERANGE), CameraError::kOther);
}

TEST(CameraErrorTest, HasARemedyForEachKind) {
  const struct {
    CameraError kind;
    const char* advice;
  } rows[] = {
      {CameraError::kForbidden, "sudo usermod -aG video"},
      {CameraError::kBusy, "sudo fuser -v /dev/video7"},
      {CameraError::kNoStreaming, "uvcvideo"},
      {CameraError::kOtherFormat, "v4l2-ctl -d /dev/video7 --list-formats-ext"},
      {CameraError::kOtherSize, "restart the controller"},
      {CameraError::kFewBuffers, "two are needed"},
      {CameraError::kNoBandwidth, "choose a smaller size"},
      {CameraError::kUnplugged, "check its USB cable"},
      {CameraError::kSilent, "unplug it, plug it in again"},
      {CameraError::kDamaged, "without a hub"},
      {CameraError::kReadErrors, "dmesg"},
      {CameraError::kOutOfMemory, "end other programs"},
      {CameraError::kOther, "unplug it and plug it in again"},
  };
  for (const auto& row : rows) {
    const std::string sentence = explain(row.kind, "/dev/video7", "detail");
    EXPECT_THAT(sentence, HasSubstr(row.advice));
    EXPECT_THAT(sentence, HasSubstr("/dev/video7"));
  }
}

TEST(CameraErrorTest, ListsTheAvailableCameras) {
  const TemporaryFolder dev;
  EXPECT_THAT(videoDevices(dev / ""), IsEmpty());
  EXPECT_THAT(explain(CameraError::kAbsent, dev / "video0", {}, dev / ""), HasSubstr("no other video device"));
  for (const char* name : {"video10", "video2", "video", "videoX", "tty0"}) std::ofstream{dev / name} << "";
  EXPECT_THAT(videoDevices(dev / ""), ElementsAre(dev / "video2", dev / "video10"));
  const std::string sentence = explain(CameraError::kAbsent, dev / "video10", {}, dev / "");
  EXPECT_THAT(sentence, HasSubstr("available video devices: " + (dev / "video2") + "; `v4l2-ctl --list-devices`"));
}

}  // namespace
}  // namespace darwinop::v4l2
