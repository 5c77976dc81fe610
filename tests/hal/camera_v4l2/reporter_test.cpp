// Camera messages are reported once.
#include "hal/camera_v4l2/reporter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace darwinop::v4l2 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct ReporterTest : testing::Test {
  std::vector<std::string> lines;
  Reporter reporter{[this](const std::string& sentence) { lines.push_back(sentence); }};
};

TEST_F(ReporterTest, ReportsEachKindOfErrorOnceUntilRecovery) {
  reporter.report(CameraError::kBusy, "busy");
  reporter.report(CameraError::kBusy, "still busy");
  reporter.report(CameraError::kSilent, "silent");
  reporter.back("back");
  reporter.back("second return");
  reporter.report(CameraError::kBusy, "busy again");
  EXPECT_THAT(lines, ElementsAre("busy", "silent", "back", "busy again"));
}

TEST_F(ReporterTest, DoesNotReportRecoveryWithoutAnError) {
  reporter.back("back");
  EXPECT_FALSE(reporter.hasError());
  EXPECT_THAT(lines, IsEmpty());
}

TEST_F(ReporterTest, DoesNotReportAnUnpluggedCameraAsAbsent) {
  reporter.report(CameraError::kUnplugged, "gone");
  reporter.report(CameraError::kAbsent, "there is none");
  EXPECT_THAT(lines, ElementsAre("gone"));
}

TEST_F(ReporterTest, ReportsARemarkOnce) {
  reporter.remark("this");
  reporter.remark("that");
  reporter.remark("this");
  EXPECT_THAT(lines, ElementsAre("this", "that"));
}

TEST_F(ReporterTest, IsSilentWhenMuted) {
  reporter.mute();
  reporter.report(CameraError::kBusy, "busy");
  EXPECT_THAT(lines, IsEmpty());
}

TEST(Reporter, SurvivesAThrowingOrMissingReceiver) {
  Reporter angry{[](const std::string&) { throw std::runtime_error("not now"); }};
  EXPECT_NO_THROW(angry.report(CameraError::kBusy, "busy"));
  Reporter lonely{nullptr};
  EXPECT_NO_THROW(lonely.remark("hello"));
}

}  // namespace
}  // namespace darwinop::v4l2
