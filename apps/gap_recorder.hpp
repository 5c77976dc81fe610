// Makes the recordings of a case of the whole robot, one after the other, and looks at each at once.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "gap/plant/body/resting_imu.hpp"
#include "gap/record/recordings.hpp"
#include "gap_commands.hpp"

namespace darwinop::gap {

namespace messages {
inline constexpr const char* kKept = "kept";  // with --resume
inline constexpr const char* kIncomplete = ": incomplete, see above";
inline constexpr const char* kEndedBySignal = " was ended by signal ";          // then its number
inline constexpr const char* kNotAsAsked = " did not end as asked, see above";  // after the experiment
inline constexpr const char* kNeedsTurning =
    "the robot has to be turned between these recordings, for which --yes leaves no time; leave --yes out";
inline constexpr const char* kUnusable = " cannot be used; find the cause and record it again";
inline constexpr const char* kTakeItsRobot = "; give that one with --robot";
}  // namespace messages

/// A recording was begun and is of no use; --resume makes it again.
class RecordingFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A recording has a name of its own until it is found good, or kept by the user: what has the name of the plan is to
/// be used.
class BodyRecorder {
 public:
  /// `twin`: connect::twinInHead(); empty: a physical robot. `model`: name or file of the model that the robot is
  /// compared with. `end_signal`: the signal that asks for the end; 0: none. All must outlive the recorder.
  BodyRecorder(const Arguments& given, std::string twin, std::string model, const std::atomic<int>& end_signal);

  /// Takes over the recordings of a former run. Throws BadInput if one cannot be used.
  void keep(const std::vector<PlannedRecording>& plans);
  /// For one more recording of the same session and robot. Throws BadInput if it is another one.
  void goOn(const BodyCase& so_far);
  /// Makes the others. Without questions, a physical robot keeps its place, and its recordings have to be good. False:
  /// stopped by the user. Throws RecordingFailed, or another std::runtime_error before the robot moves.
  [[nodiscard]] bool record(const std::vector<PlannedRecording>& plans);
  /// In the order of their plans.
  [[nodiscard]] std::vector<MadeRecording> made(const std::vector<PlannedRecording>& plans) const;

 private:
  [[nodiscard]] bool isSimulated() const { return !twin_.empty(); }
  [[nodiscard]] bool asks() const { return !given_.yes && !isSimulated(); }
  [[nodiscard]] bool isEnded() const { return end_signal_ != 0; }
  /// A person has to turn the robot between the recordings that are not there yet.
  [[nodiscard]] bool isTurnedBetween(const std::vector<PlannedRecording>& plans) const;
  [[nodiscard]] std::string fileOf(const PlannedRecording& plan) const;
  [[nodiscard]] const MadeRecording* find(const PlannedRecording& plan) const;
  [[nodiscard]] bool record(const PlannedRecording& plan);
  /// Exit code of the experiment, which records into `file`.
  [[nodiscard]] int run(const PlannedRecording& plan, const std::string& file) const;
  /// What is wrong with it; a usable one is then the last of made().
  [[nodiscard]] std::vector<std::string> look(const PlannedRecording& plan, const std::string& file, double session_s);
  [[nodiscard]] std::vector<std::string> problems(int status, const PlannedRecording& plan, const std::string& file,
                                                  double session_s);
  [[nodiscard]] double sessionSeconds() const;
  /// The session began then, and its last recording; s since 1970. Throws BadInput if the clock was set back.
  void continueSession(double first_s, double last_s);

  const Arguments& given_;
  std::string twin_, model_;
  const std::atomic<int>& end_signal_;
  RestingImu imu_;
  std::vector<MadeRecording> made_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  double earlier_s_ = 0;  // of the session, before this program began
  std::string robot_;     // "model" in the head of the first recording; empty: there is none yet
};

}  // namespace darwinop::gap
