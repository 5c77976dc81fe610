// Sentences that say what to do.
#include "hal/camera_v4l2/trouble.hpp"

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

TEST(CameraTrouble, IsFoundByErrno) {
  EXPECT_EQ(troubleOf(ENOENT), Trouble::kAbsent);
  EXPECT_EQ(troubleOf(ENODEV), Trouble::kAbsent);
  EXPECT_EQ(troubleOf(EACCES), Trouble::kForbidden);
  EXPECT_EQ(troubleOf(EBUSY), Trouble::kBusy);
  EXPECT_EQ(troubleOf(ENOTTY), Trouble::kNotACamera);
  EXPECT_EQ(troubleOf(ENOSPC), Trouble::kNoBandwidth);
  EXPECT_EQ(troubleOf(ENOMEM), Trouble::kOutOfMemory);
  EXPECT_EQ(troubleOf(EIO), Trouble::kReadErrors);
  EXPECT_EQ(troubleOf(ERANGE), Trouble::kOther);
}

TEST(CameraTrouble, HasAnAdviceForEachKind) {
  const struct {
    Trouble trouble;
    const char* advice;
  } rows[] = {
      {Trouble::kForbidden, "sudo usermod -aG video"},
      {Trouble::kBusy, "sudo fuser -v /dev/video7"},
      {Trouble::kNoStreaming, "uvcvideo"},
      {Trouble::kOtherFormat, "v4l2-ctl -d /dev/video7 --list-formats-ext"},
      {Trouble::kOtherSize, "restart the controller"},
      {Trouble::kFewBuffers, "two are needed"},
      {Trouble::kNoBandwidth, "choose a smaller size"},
      {Trouble::kUnplugged, "check its USB cable"},
      {Trouble::kSilent, "unplug it and plug it in again"},
      {Trouble::kDamaged, "without a hub"},
      {Trouble::kReadErrors, "dmesg"},
      {Trouble::kOutOfMemory, "end other programs"},
      {Trouble::kOther, "unplug it and plug it in again"},
  };
  for (const auto& row : rows) {
    const std::string sentence = explain(row.trouble, "/dev/video7", "detail");
    EXPECT_THAT(sentence, HasSubstr(row.advice));
    EXPECT_THAT(sentence, HasSubstr("/dev/video7"));
  }
}

TEST(CameraTrouble, NamesTheCamerasThatAreThere) {
  const TemporaryFolder dev;
  EXPECT_THAT(videoDevices(dev / ""), IsEmpty());
  EXPECT_THAT(explain(Trouble::kAbsent, dev / "video0", {}, dev / ""), HasSubstr("no other video device"));
  for (const char* name : {"video10", "video2", "video", "videoX", "tty0"}) std::ofstream{dev / name} << "";
  EXPECT_THAT(videoDevices(dev / ""), ElementsAre(dev / "video2", dev / "video10"));
  const std::string sentence = explain(Trouble::kAbsent, dev / "video10", {}, dev / "");
  EXPECT_THAT(sentence, HasSubstr("that are there: " + (dev / "video2") + "; `v4l2-ctl --list-devices`"));
}

}  // namespace
}  // namespace darwinop::v4l2
