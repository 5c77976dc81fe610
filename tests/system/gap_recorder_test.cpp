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

TEST(TwinInHead, BeginsAsRecordingsOfATwinAreRecognized) {
  EXPECT_TRUE(connect::twinInHead("mine.ini").starts_with(kTwinInHead));
}

}  // namespace
}  // namespace darwinop::gap
