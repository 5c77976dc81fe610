// Servos alone on an adapter, on a pty, from robot.ini to a controller's commands.
#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <bitset>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <string>

#include "connect/connect.hpp"
#include "connect/robot_file.hpp"
#include "connect/robot_set_up.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"
#include "hal/cm730/not_ready.hpp"
#include "runtime/environment.hpp"
#include "safety/fault_book.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::connect {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;

SerialRobot permitted(SerialRobot serial) {
  serial.permitted = parseRobotFile("[Robot]\nboard = none\n", "robot.ini").permitted;
  return serial;
}

TEST(ServosAlone, AreRefusedWithTheKeyThatPermitsThem) {
  const RobotSetUp robot{{"none"}};
  for (const auto purpose : {cm730::Purpose::kDrive, cm730::Purpose::kRescue}) {
    try {
      static_cast<void>(openSerialBus(robot.serial(), purpose));
      ADD_FAILURE() << "opened";
    } catch (const cm730::NotReady& refused) {
      EXPECT_THAT(refused.what(), AllOf(HasSubstr("servos do (20)"), HasSubstr("[Robot] board = none")));
    }
  }
}

TEST(ServosAlone, AreOpenedWithTheKey) {
  const RobotSetUp robot{{"none"}};
  for (const auto purpose : {cm730::Purpose::kDrive, cm730::Purpose::kRescue}) {
    const OpenedBus opened = openSerialBus(permitted(robot.serial()), purpose);
    EXPECT_THAT(opened.description, HasSubstr("(no board, 20 servos)"));
    EXPECT_TRUE(opened.safety.left_out.none());
  }
}

TEST(ServosAlone, ABoardThatAnswersAllTheSameIsRefused) {
  RobotSetUp robot{{"cm-730"}};
  try {
    static_cast<void>(openSerialBus(permitted(robot.serial())));
    ADD_FAILURE() << "opened";
  } catch (const cm730::NotReady& waited_for) {
    ADD_FAILURE() << waited_for.what();
  } catch (const std::runtime_error& refused) {
    EXPECT_THAT(refused.what(), AllOf(HasSubstr("CM-730 answers"), HasSubstr("remove [Robot] board = none")));
  }
  EXPECT_EQ(robot.host.withRobot([](hil::VirtualRobot& r) { return r.board().device().servoPower(); }), false)
      << "nothing was written";
}

TEST(ServosAlone, WithoutSupplyAreWaitedFor) {
  RobotSetUp robot{{"none"}};
  robot.host.withRobot([](hil::VirtualRobot& r) {
    for (std::size_t i = 0; i < kJoints; ++i) r.board().setServoDead(static_cast<Joint>(i), true);
  });
  try {
    static_cast<void>(openSerialBus(permitted(robot.serial())));
    ADD_FAILURE() << "opened";
  } catch (const cm730::NotReady& waited_for) {
    EXPECT_THAT(waited_for.what(), HasSubstr(cm730::kHowToSupply));
  }
}

struct DrivenAlone : ::testing::Test {
  TemporaryFolder folder;
  hil::VirtualRobot robot{RobotSetUp::options({"none"})};
  hil::PtyHost host{robot, {.link = folder / "port"}};
  runtime::Environment file{"DARWINOP_ROBOT_FILE", folder / "robot.ini"};
  runtime::Environment real_time{"DARWINOP_REALTIME", "if-allowed"};
  const std::atomic<bool> never{false};
  std::unique_ptr<runtime::RobotLink> link;
  Commands asked;
  std::uint64_t cycle = 0;

  void SetUp() override {
    std::ofstream{folder / "robot.ini"} << "[Robot]\nboard = none\n";
    ConnectRequest request;
    request.setting = folder / "port";
    request.warn = [](const std::string&) {};
    link = connect(request);
    asked.start_where_it_is = true;
    ASSERT_TRUE(reach([this] { return seen().safety.state == State::kDriven; }));
  }
  [[nodiscard]] Sensors seen() const { return link->sensors(); }
  bool reach(const std::function<bool()>& done) {
    for (int i = 0; i < 1500; ++i) {
      link->publish(asked);
      if (!link->waitForCycle(++cycle, never)) return false;
      cycle = std::max(cycle, seen().cycle);
      if (done()) return true;
    }
    return false;
  }
  void fault(hil::FaultKind kind, Nanos lasts, std::bitset<kJoints> joints = {}) {
    host.withRobot([&](hil::VirtualRobot& r) {
      hil::InjectedFault fault;
      fault.kind = kind;
      fault.at = r.now();
      fault.lasts = lasts;
      fault.joints = joints;
      r.faults().add(fault);
    });
  }
  std::size_t stiff() {
    return host.withRobot([](hil::VirtualRobot& r) {
      std::size_t count = 0;
      for (std::size_t i = 0; i < kJoints; ++i) {
        const hil::VirtualServo& servo = r.board().servo(static_cast<Joint>(i));
        count += servo.listens(r.now()) && servo.table().byte(servo::kTorqueEnable) != 0 ? 1 : 0;
      }
      return count;
    });
  }
  [[nodiscard]] bool active(Fault fault) const { return seen().safety.active[safety::rowIndex(fault)]; }
};

TEST_F(DrivenAlone, AJointMovesASilentServoIsReportedAndTheEndIsLimp) {
  asked.joint[index(Joint::kNeck)].setGoal(Rad{0.3});
  EXPECT_TRUE(reach([this] { return std::abs(seen().joint[index(Joint::kNeck)].position.value - 0.3) < 0.02; }));
  EXPECT_TRUE(seen().board.absent);
  EXPECT_FALSE(seen().board.motion.ever());
  EXPECT_EQ(stiff(), kJoints);

  fault(hil::FaultKind::kDead, 3600s, std::bitset<kJoints>{}.set(index(Joint::kShoulderR)));
  EXPECT_TRUE(reach([this] { return active(Fault::kServoSilent); }));
  EXPECT_EQ(seen().safety.state, State::kDriven);
  EXPECT_EQ(stiff(), kJoints - 1);

  asked.joint[index(Joint::kNeck)].setGoal(Rad{-0.2});
  EXPECT_TRUE(reach([this] { return std::abs(seen().joint[index(Joint::kNeck)].position.value + 0.2) < 0.02; }));

  link.reset();  // kneels, then limp
  EXPECT_EQ(stiff(), 0U);
}

TEST_F(DrivenAlone, AnUnpluggedAdapterEndsSendingAndIsDrivenAgainOnceItIsBack) {
  fault(hil::FaultKind::kUnplug, 1s);
  EXPECT_TRUE(reach([this] { return seen().safety.state == State::kOffline; }));
  EXPECT_TRUE(active(Fault::kBusSilent));
  EXPECT_TRUE(reach([this] { return seen().safety.state == State::kDriven; }));
  EXPECT_FALSE(active(Fault::kBoardReset));
}

TEST_F(DrivenAlone, AnInterruptedSupplyReleasesTheRobot) {
  fault(hil::FaultKind::kDead, 500ms, std::bitset<kJoints>{}.set());
  EXPECT_TRUE(reach([this] { return active(Fault::kBoardReset); }));
  EXPECT_TRUE(reach([this] { return seen().safety.state == State::kLimp; }));
  EXPECT_EQ(stiff(), 0U);
}

}  // namespace
}  // namespace darwinop::connect
