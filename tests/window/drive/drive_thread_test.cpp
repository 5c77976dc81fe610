// Drive thread on a link that runs a cycle when it is waited for.
#include "window/drive/drive_thread.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <stdexcept>

#include "window/drive/fake_robot_link.hpp"
#include "window/messages.hpp"

namespace darwinop::window {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

struct WindowDriveThread : testing::Test {
  [[nodiscard]] bool reaches(DriveState state) {
    for (int i = 0; i < 20'000 && drive.report().state != state; ++i) std::this_thread::sleep_for(1ms);
    return drive.report().state == state;
  }
  template <class Value>
  Value robotHas(Value FakeRobot::*member) {
    const std::scoped_lock lock{robot.mutex};
    return robot.*member;
  }
  void change(const std::function<void(FakeRobot&)>& how) {
    const std::scoped_lock lock{robot.mutex};
    how(robot);
  }
  void requestNeck(double rad) {
    DriveRequests requests;
    requests.goals[index(Joint::kNeck)] = Rad{rad};
    drive.request(requests);
  }
  [[nodiscard]] double neckGoal() { return robotHas(&FakeRobot::published).joint[index(Joint::kNeck)].goal.value; }

  FakeRobot robot;
  motion::PageFile pages;
  DriveThread drive{[this] { return std::make_unique<FakeRobotLink>(robot); }, pages};
};

TEST_F(WindowDriveThread, TakesTheRobotWhereItIsAndExecutesRequests) {
  drive.start();
  ASSERT_TRUE(reaches(DriveState::kDriving));
  EXPECT_TRUE(robotHas(&FakeRobot::leased));
  EXPECT_TRUE(robotHas(&FakeRobot::published).start_where_it_is);
  for (int i = 0; i < 20'000 && neckGoal() != 0.25; ++i) {
    requestNeck(0.25);
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(neckGoal(), 0.25);
}

TEST_F(WindowDriveThread, HoldsAndGivesTheLeaseBackOnRequestAndStartsAgain) {
  for (const auto end : {&DriveThread::finish, &DriveThread::stop}) {
    change([](FakeRobot& its) { its.left_holding = false; });
    drive.start();
    ASSERT_TRUE(reaches(DriveState::kDriving));
    (drive.*end)();
    ASSERT_TRUE(reaches(DriveState::kFree));
    EXPECT_EQ(drive.report().why, "");
    EXPECT_TRUE(robotHas(&FakeRobot::left_holding));
    EXPECT_FALSE(robotHas(&FakeRobot::leased));
  }
}

TEST_F(WindowDriveThread, HoldsAJointOnItsWayAtItsPosition) {
  drive.start();
  ASSERT_TRUE(reaches(DriveState::kDriving));
  change([](FakeRobot& its) {
    JointSensors& neck = its.image.joint[index(Joint::kNeck)];
    neck.motion.received();
    neck.position = Rad{0.3};
    neck.commanded = Rad{1.0};
  });
  drive.stop();
  ASSERT_TRUE(reaches(DriveState::kFree));
  EXPECT_EQ(neckGoal(), 0.3);
}

TEST_F(WindowDriveThread, ExecutesNoRequestThatComesAfterAStop) {
  drive.start();
  ASSERT_TRUE(reaches(DriveState::kDriving));
  drive.stop();
  requestNeck(0.9);
  ASSERT_TRUE(reaches(DriveState::kFree));
  EXPECT_NE(neckGoal(), 0.9);
}

TEST_F(WindowDriveThread, ExecutesAPageOnce) {
  drive.start();
  ASSERT_TRUE(reaches(DriveState::kDriving));
  DriveRequests page, torque;
  page.page = 99;
  torque.torque[0] = true;
  drive.request(page);
  for (int i = 0; i < 20'000 && drive.report().status.refused.empty(); ++i) std::this_thread::sleep_for(1ms);
  EXPECT_NE(drive.report().status.refused, "");
  drive.request(torque);
  for (int i = 0; i < 500 && !drive.report().status.refused.empty(); ++i) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(drive.report().status.refused, "") << "it was refused again";
}

TEST_F(WindowDriveThread, EndsItsSessionWhenItIsDestroyed) {
  const auto connect = [this] { return std::make_unique<FakeRobotLink>(robot); };
  auto other = std::make_unique<DriveThread>(connect, pages);
  other->start();
  while (other->report().state != DriveState::kDriving) std::this_thread::sleep_for(1ms);
  const std::uint64_t before = robotHas(&FakeRobot::image).cycle;
  other.reset();
  EXPECT_TRUE(robotHas(&FakeRobot::left_holding));
  EXPECT_LT(robotHas(&FakeRobot::image).cycle, before + 1500) << "it has waited for requests";
}

TEST_F(WindowDriveThread, GoesOnWhileRequestsCome) {
  drive.start();
  ASSERT_TRUE(reaches(DriveState::kDriving));
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < DriveThread::kRequestTimeout + 400ms) {
    drive.request({});
    std::this_thread::sleep_for(20ms);
  }
  EXPECT_EQ(drive.report().state, DriveState::kDriving);
}

TEST_F(WindowDriveThread, EndsWithoutRequests) {
  drive.start();
  ASSERT_TRUE(reaches(DriveState::kDriving));
  const auto driving = std::chrono::steady_clock::now();
  ASSERT_TRUE(reaches(DriveState::kFree));
  const auto lasted = std::chrono::steady_clock::now() - driving;
  EXPECT_GT(lasted, DriveThread::kRequestTimeout - 100ms);
  EXPECT_LT(lasted, 2 * DriveThread::kRequestTimeout);
  EXPECT_EQ(drive.report().why, window::messages::kNoRequests);
  EXPECT_TRUE(robotHas(&FakeRobot::left_holding));
}

TEST_F(WindowDriveThread, ReportsWhyItCouldNotStart) {
  DriveThread refused{[]() -> std::unique_ptr<runtime::RobotLink> { throw std::runtime_error("another drives"); },
                      pages};
  refused.start();
  for (int i = 0; i < 20'000 && refused.report().state != DriveState::kFree; ++i) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(refused.report().why, "another drives");

  change([](FakeRobot& its) { its.torque_works = false; });
  drive.start();
  ASSERT_TRUE(reaches(DriveState::kFree));
  EXPECT_EQ(drive.report().why, window::messages::kNoTorque);
}

/// Over a bad network connecting takes seconds, in which a person may have walked up to the limp robot.
TEST_F(WindowDriveThread, AStopBeforeTorqueLeavesTheRobotLimp) {
  for (const auto end : {&DriveThread::finish, &DriveThread::stop}) {
    std::promise<void> connects, may_connect;
    DriveThread slow{[&, ready = may_connect.get_future().share()]() -> std::unique_ptr<runtime::RobotLink> {
                       connects.set_value();
                       ready.wait();
                       return std::make_unique<FakeRobotLink>(robot);
                     },
                     pages};
    slow.start();
    connects.get_future().wait();
    (slow.*end)();
    may_connect.set_value();
    for (int i = 0; i < 20'000 && slow.report().state != DriveState::kFree; ++i) std::this_thread::sleep_for(1ms);
    EXPECT_FALSE(robotHas(&FakeRobot::published).start_where_it_is) << "nothing was published";
    EXPECT_FALSE(robotHas(&FakeRobot::left_holding));
  }
  change([](FakeRobot& its) { its.torque_works = false; });
  drive.start();
  for (int i = 0; i < 20'000 && !robotHas(&FakeRobot::published).start_where_it_is; ++i)
    std::this_thread::sleep_for(1ms);
  drive.stop();
  ASSERT_TRUE(reaches(DriveState::kFree));
  EXPECT_TRUE(robotHas(&FakeRobot::published).hold);
}

TEST_F(WindowDriveThread, StartsWithoutTheRequestsAndTheReasonOfBefore) {
  drive.start();
  ASSERT_TRUE(reaches(DriveState::kDriving));
  change([](FakeRobot& its) { its.loop_runs = false; });
  ASSERT_TRUE(reaches(DriveState::kFree));
  requestNeck(0.7);
  change([](FakeRobot& its) { its.loop_runs = true; });
  drive.start();
  ASSERT_TRUE(reaches(DriveState::kDriving));
  EXPECT_EQ(drive.report().why, "");
  drive.stop();
  ASSERT_TRUE(reaches(DriveState::kFree));
  EXPECT_NE(neckGoal(), 0.7);
}

TEST_F(WindowDriveThread, ReportsWhyTheRobotEndedTheSession) {
  drive.start();
  ASSERT_TRUE(reaches(DriveState::kDriving));
  change([](FakeRobot& its) { its.loop_runs = false; });
  ASSERT_TRUE(reaches(DriveState::kFree));
  EXPECT_EQ(drive.report().why, "loop stopped");

  change([](FakeRobot& its) { its.loop_runs = true; });
  drive.start();
  ASSERT_TRUE(reaches(DriveState::kDriving));
  change([](FakeRobot& its) {
    its.loop_runs = false;
    its.image.safety.controller_must_end = true;
    its.image.safety.worst = Fault::kBatteryEmpty;
  });
  ASSERT_TRUE(reaches(DriveState::kFree));
  EXPECT_THAT(drive.report().why, HasSubstr(std::string{row(Fault::kBatteryEmpty).meaning}))
      << "a fault explains more than the end of the loop";
}

}  // namespace
}  // namespace darwinop::window
