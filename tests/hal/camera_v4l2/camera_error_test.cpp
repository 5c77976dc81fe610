// Camera error messages.
#include "hal/camera_v4l2/camera_error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <fstream>
#include <set>

#include "support/temporary_folder.hpp"

namespace darwinop::v4l2 {
namespace {

using testing::ContainsRegex;
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

/// "SENTENCE: remedy" or "SENTENCE; remedy", for each kind a different one.
TEST(CameraErrorTest, NamesTheDeviceAndARemedyForEachKind) {
  const TemporaryFolder dev;
  std::set<std::string> sentences;
  for (std::size_t i = 0; i < static_cast<std::size_t>(CameraError::kCount); ++i) {
    const std::string sentence = explain(static_cast<CameraError>(i), "/dev/video7", "detail", dev / "");
    EXPECT_THAT(sentence, ContainsRegex("/dev/video7.*[:;] [a-z`]+ .+"));
    sentences.insert(sentence);
  }
  EXPECT_EQ(sentences.size(), static_cast<std::size_t>(CameraError::kCount));
}

TEST(CameraErrorTest, NamesTheToolThatHelps) {
  const struct {
    CameraError kind;
    const char* tool;
  } rows[] = {
      {CameraError::kForbidden, "usermod -aG video $USER"},
      {CameraError::kBusy, "fuser -v /dev/video7"},
      {CameraError::kNoStreaming, "uvcvideo"},
      {CameraError::kOtherFormat, "v4l2-ctl -d /dev/video7 --list-formats-ext"},
      {CameraError::kUnplugged, "USB"},
      {CameraError::kSilent, "dmesg"},
      {CameraError::kDamaged, "USB"},
      {CameraError::kReadErrors, "dmesg"},
  };
  for (const auto& row : rows) EXPECT_THAT(explain(row.kind, "/dev/video7", "detail"), HasSubstr(row.tool));
}

TEST(CameraErrorTest, ListsTheAvailableCameras) {
  const TemporaryFolder dev;
  EXPECT_THAT(videoDevices(dev / ""), IsEmpty());
  EXPECT_THAT(explain(CameraError::kAbsent, dev / "video0", {}, dev / ""), HasSubstr("lsusb"));
  for (const char* name : {"video10", "video2", "video", "videoX", "tty0"}) std::ofstream{dev / name} << "";
  EXPECT_THAT(videoDevices(dev / ""), ElementsAre(dev / "video2", dev / "video10"));
  const std::string sentence = explain(CameraError::kAbsent, dev / "video10", {}, dev / "");
  EXPECT_THAT(sentence, HasSubstr(": " + (dev / "video2") + "; `v4l2-ctl --list-devices`"));
}

}  // namespace
}  // namespace darwinop::v4l2
