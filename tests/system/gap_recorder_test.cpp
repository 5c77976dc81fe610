// What `darwinop gap record` decides between two experiments, where no robot moves.
#include "gap_recorder.hpp"

#include <gmock/gmock.h>
#include <signal.h>

#include "connect/twin_library.hpp"
#include "gap/record/kept_recording.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::gap {
namespace {

class Recorder : public testing::Test {
 protected:
  Recorder() { given_.out = folder_ / ""; }

  TemporaryFolder folder_;
  Arguments given_;
  std::atomic<int> end_signal_{0};
  std::vector<PlannedRecording> plans_ = plannedRecordings(false);
};

// As Ctrl-C while the recordings of a former run are read.
TEST_F(Recorder, ASignalWhileNoExperimentRunsStartsNone) {
  BodyRecorder recorder{given_, connect::twinInHead(""), "darwin-op", end_signal_};
  end_signal_ = SIGINT;
  testing::internal::CaptureStdout();
  EXPECT_FALSE(recorder.record(plans_));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST_F(Recorder, NobodyIsAskedToTurnAPhysicalRobot) {
  given_.yes = true;
  BodyRecorder recorder{given_, "", "darwin-op", end_signal_};
  end_signal_ = SIGINT;  // nothing would move
  EXPECT_THROW((void)recorder.record(plans_), std::runtime_error);
  EXPECT_FALSE(recorder.record({plans_[0], plans_[1]})) << "in one place";
}

TEST(TwinInHead, BeginsAsRecordingsOfATwinAreRecognized) {
  EXPECT_TRUE(connect::twinInHead("mine.ini").starts_with(kTwinInHead));
}

}  // namespace
}  // namespace darwinop::gap
