// Holds what happens at the motors of the virtual servos against what the safety layer promises. It believes the
// servos' registers and the body's true positions; of our own side it takes only what that side claims.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "campaign/leniencies.hpp"
#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "hil-mocks/memory_line.hpp"
#include "hil-mocks/servo_observer.hpp"
#include "safety/config.hpp"

namespace darwinop {

/// What has to hold at each servo, whatever happens. In the order of kPromiseNames.
enum class Promise : std::uint8_t {
  kGoalAtJoint,
  kGentleStart,
  kSpeedLimit,
  kStep,
  kRelease,
  kLimp,
  kPatience,
  kTrip,
  kCount
};
inline constexpr std::size_t kPromises = static_cast<std::size_t>(Promise::kCount);
inline constexpr std::array<std::string_view, kPromises> kPromiseNames{
    "torque comes on only with the goal where the joint is",
    "torque comes on only at the gentle speed",
    "no servo is under torque without a speed limit",
    "a goal under torque moves one step a cycle",
    "after a person released the robot no torque comes on by itself",
    "a robot that is called limp is limp",
    "five lost answers of the board are ridden through",
    "an overload shutdown is believed before the second one",
};

class ServoJudge final : public hil::ServoObserver, public hil::WireObserver {
 public:
  /// Takes the board's observer for itself. `robot` and `config` have to outlive it.
  ServoJudge(hil::VirtualRobot& robot, const safety::Config& config);

  /// Before the cycle: what the controller asks for in it.
  void beginCycle(const Commands& asked);
  /// After the cycle: what our side says of it.
  void endCycle(const Sensors& seen);

  void request(const Frame& frame, Nanos at) noexcept override;
  void reply(Bytes /*bytes*/, Nanos /*at*/) noexcept override {}
  void written(Joint joint, std::uint8_t address, Bytes data, const hil::ServoState& before,
               const hil::ServoState& after) noexcept override;
  void changed(Joint joint, hil::ServoEvent event, const hil::ServoState& before,
               const hil::ServoState& after) noexcept override;

  /// The first broken promise; empty: none.
  [[nodiscard]] const std::string& failure() const { return failure_; }

  struct Tally {
    long edges = 0;       // torque came on at a servo, judged
    long steps = 0;       // a goal moved under torque, judged
    long trips = 0;       // servos that shut themselves off
    long releases = 0;    // by a person: MODE, RESET, or beside the controller
    long outages = 0;     // offline was reported
    long limp_looks = 0;  // joints held against a state limp
    long late = 0;        // writes that a stalled board carried out long after they were sent; judged as such
    long blind = 0;       // shutdowns undone by a write that left before any answer could report them
    long damaged = 0;     // writes that nobody sent: damaged, and their checksum right by chance
    std::array<long, kPromises> broken{};
    Tolerated tolerated;
    Tally& operator+=(const Tally& other);
  };
  [[nodiscard]] const Tally& tally() const { return tally_; }

 private:
  /// A write to one servo, as it left the PC.
  struct Sent {
    long cycle = 0;
    std::uint32_t goals = 0;  // goals sent to this servo up to and with this one
    std::uint8_t address = 0, size = 0;
    std::array<std::uint8_t, 8> data{};
    bool at_joint = false;  // its goal was where the joint was when it was sent
  };
  static constexpr std::uint32_t kSentRoom = 256;  // a board that stalls executes seconds of requests at once
  static constexpr auto kPositionWindow = boundAs<std::size_t>(Leniency::kRecentPosition);

  /// For the report of a broken promise.
  struct Happening {
    long cycle = 0;
    const char* what = "";
    hil::ServoState state{};
    double position = 0;  // ticks
  };
  static constexpr std::size_t kHistory = 24;

  struct Servo {
    std::array<Happening, kHistory> history{};
    std::size_t happened = 0;
    std::array<Sent, kSentRoom> sent{};
    std::uint32_t sent_count = 0, arrived = 0;  // arrived: number of the last write that came through
    std::uint32_t goals_sent = 0, goals_arrived = 0;
    std::array<double, kPositionWindow> position{};  // ticks, at the ends of the last cycles
    long untrusted_until = 0;                        // cycle; after a damaged write or a second device with its id
    int trips = 0;                                   // since our side last believed one, or was asked to try again
    int early_trips = 0;                             // the same, soon after it was taken over: not counted in trips
    int silent = 0, answered = 0;                    // cycles in a row
    int late_goals = 0;                              // carried out late since its last answer
    int unlimited_for = 0;                           // cycles under torque without a speed limit, all answered
    long goal_at = 0;                                // cycle in which the last goal came through
    long powered_at = 0;                             // cycle
    long limit_sent_at = -1000;                      // cycle
    std::uint32_t waits = 0;                         // limits sent without a goal since the last goal
    long tripped_at = -1000;                         // cycle
    long pulls_since = 0, driven_since = 0;          // cycle
    long torque_on_at = 0;                           // cycle in which torque on was last written to it
    long lost_at = -1000;                            // cycle in which it lost its power under torque
    int lost_goal = 0;                               // ticks
    long unlimited_until = 0;                        // cycle; until then a missing speed limit cannot have been seen
    bool driven = false;
  };

  void judgeEdge(Joint joint, const hil::ServoState& after, std::uint32_t goals);
  [[nodiscard]] bool judgeShortOutage(Joint joint, const hil::ServoState& after, std::uint32_t goals);
  [[nodiscard]] bool undoesUnseenTrip(Joint joint);
  void noteErasedTrip(Joint joint);
  void judgeLate(Joint joint, const Sent& sent, const hil::ServoState& before, const hil::ServoState& after,
                 std::uint32_t goals);
  void judgeStep(Joint joint, const hil::ServoState& before, const hil::ServoState& after, std::uint32_t goals);
  void judgeOutage(const Sensors& seen);
  void judgeLimp(const Sensors& seen);
  void judgeSpeedLimits(const Sensors& seen);
  void notePerson(const Sensors& seen);
  void release();
  void personActs();
  [[nodiscard]] const Sent* findSent(Servo& servo, std::uint8_t address, Bytes data) const;
  [[nodiscard]] bool nearJoint(Joint joint, int goal) const;
  [[nodiscard]] bool acceptsGoal(Joint joint, int goal);
  void tolerate(Leniency leniency, long times = 1) { tally_.tolerated.note(leniency, times); }
  [[nodiscard]] double truth(Joint joint) const;
  void note(Joint joint, const char* what);
  [[nodiscard]] std::string historyOf(Joint joint) const;
  void blame(Promise promise, const std::string& what);
  void blame(Promise promise, Joint joint, const std::string& what);

  hil::VirtualRobot& robot_;
  const safety::Config& config_;
  double max_step_;  // ticks a cycle
  std::array<Servo, kJoints> servo_{};
  Tally tally_;
  std::string failure_;
  long cycle_ = 0;

  std::uint32_t session_ = 0, resets_ = 0, operator_resets_ = 0, operator_releases_ = 0;
  int mode_held_ = 0, start_held_ = 0, power_off_seen_ = 0;  // answers in a row that say so
  bool lost_under_torque_ = false;
  bool released_ = false;  // by a person, and no person has acted since
  int bulk_reads_ = 0, missed_answers_ = 0, limp_for_ = 0;
  bool port_closed_ = false;
  std::uint32_t replugs_ = 0;
  long port_lost_at_ = -1000;  // cycle
  State state_ = State::kOffline;
};

}  // namespace darwinop
