// Sources of the live comparison: a runtime's memory, and the messages of a monitor.
#include <gmock/gmock.h>
#include <unistd.h>

#include "monitor/messages.hpp"
#include "runtime/file_lock.hpp"
#include "support/temporary_folder.hpp"
#include "window/live/live_cycles.hpp"
#include "window/live/monitor_source.hpp"
#include "window/live/runtime_source.hpp"

namespace darwinop::window {
namespace {

TEST(MonitorSource, AStateMessageIsTheCycleItWasMadeFrom) {
  Sensors sent = test::resting(700).sensors;
  sent.joint[2].motion.age = 100;  // silent
  sent.joint[3].driven = false;
  sent.safety.state = State::kKneeling;
  sent.joint[4].torque_limit = NewtonMeter{1.5};
  sent.joint[4].polled.received();
  const auto got = sensorsOfState(monitor::stateText(sent), 0.016);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->cycle, 700);
  EXPECT_EQ(got->time_ns, sent.time_ns);
  EXPECT_EQ(got->period_ns, 16'000'000);
  EXPECT_NEAR(got->joint[0].position.value, sent.joint[0].position.value, 1e-5);
  EXPECT_NEAR(got->joint[0].commanded.value, sent.joint[0].commanded.value, 1e-5);
  EXPECT_TRUE(got->joint[0].motion.fresh());
  EXPECT_TRUE(got->joint[0].driven);
  EXPECT_TRUE(std::isnan(got->joint[2].position.value));
  EXPECT_EQ(got->joint[2].motion.age, 100);
  EXPECT_FALSE(got->joint[3].driven);
  EXPECT_EQ(got->safety.state, State::kKneeling);
  EXPECT_EQ(got->joint[4].torque_limit.value, 1.5);
  EXPECT_NEAR(got->board.gyro[1].value, 0.1, 1e-5);
  EXPECT_NEAR(got->board.accelerometer[2].value, kGravity, 1e-5);
  EXPECT_EQ(got->board.voltage.value, 11.8);
  EXPECT_TRUE(std::isnan(got->joint[0].speed_limit.value)) << "the message does not have it";
}

TEST(MonitorSource, ARobotWithoutABoardIsOneWithoutABoard) {
  Sensors sent = test::resting(700).sensors;
  EXPECT_FALSE(sensorsOfState(monitor::stateText(sent), 0.016)->board.absent);
  sent.board = {};
  sent.board.absent = true;
  EXPECT_TRUE(sensorsOfState(monitor::stateText(sent), 0.016)->board.absent);
}

TEST(MonitorSource, OtherMessagesAreIgnored) {
  for (const char* text : {"", "[]", "{}", R"({"type":"state"})", R"({"type":"gone","reason":"x"})",
                           R"({"type":"state","cycle":-1,"time":0,"joints":{},"board":{}})",
                           R"({"type":"state","cycle":1,"time":1e300,"joints":{},"board":{}})"})
    EXPECT_FALSE(sensorsOfState(text, 0.016)) << text;
  const auto empty = sensorsOfState(R"({"type":"state","cycle":1,"time":0,"joints":{"age":["x"]},"board":{}})", 0.016);
  ASSERT_TRUE(empty);
  EXPECT_FALSE(empty->joint[0].motion.ever());
  EXPECT_FALSE(empty->board.motion.ever());
}

TEST(MonitorSource, APeriodThatNoLoopHasIsIgnored) {
  EXPECT_EQ(periodOfHello(R"({"type":"hello","period":0.016})"), 0.016);
  for (const char* text :
       {"", "[]", R"({"type":"state","period":0.016})", R"({"type":"hello"})", R"({"type":"hello","period":1e-7})",
        R"({"type":"hello","period":2})", R"({"type":"hello","period":"0.016"})"})
    EXPECT_FALSE(periodOfHello(text)) << text;
}

TEST(RuntimeSource, ReadsEachCycleOnceWithTheGainsThatAreAskedFor) {
  const TemporaryFolder folder;
  const runtime::RuntimeFiles files{folder / "runtime"};
  RuntimeSource source{files};
  std::vector<gap::live::LiveCycle> got;
  Nanos now{0};
  const auto poll = [&] {
    now += Nanos{1'000'000'000};
    source.poll(now, [&](const gap::live::LiveCycle& cycle) { got.push_back(cycle); });
  };
  poll();
  EXPECT_TRUE(got.empty());
  EXPECT_FALSE(source.reason().empty()) << "no runtime";

  runtime::Exchange loop = runtime::Exchange::create(files.exchange);
  loop.ownBlock().info.pid = getpid();
  const auto lock = runtime::FileLock::tryTake(files.loop_lock);
  Commands asked;
  asked.joint[5].setPGain(2.5);
  asked.joint[6].setPGain(1e9);
  loop.commands().commands.publish(asked);
  loop.ownBlock().sensors.publish(test::resting(3).sensors);
  poll();
  poll();
  ASSERT_EQ(got.size(), 1) << source.reason();
  EXPECT_EQ(got[0].sensors.cycle, 3);
  EXPECT_EQ(got[0].p_gain[0], 4);
  EXPECT_EQ(got[0].p_gain[5], 2.5);
  EXPECT_TRUE(std::isnan(got[0].p_gain[6])) << "no gain of a servo";
  EXPECT_TRUE(source.reason().empty());
}

}  // namespace
}  // namespace darwinop::window
