// A controller for tests of `darwinop run`: twenty cycles on a fake robot, then it does as requested.
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "runtime/threaded_link.hpp"
#include "simulated_robot.hpp"

namespace {
std::atomic<bool>* stop_flag = nullptr;

/// Drives a robot in real time and calls `end`. If that returns, the robot is brought to rest.
void drive(void (*end)(darwinop::runtime::FakeRobot&)) {
  using namespace darwinop;
  runtime::LoopConfig config;
  config.safety.stall_ms = 100;
  config.safety.gone_s = 0.5;
  config.period = std::chrono::milliseconds{2};
  const auto robot = std::make_shared<runtime::FakeRobot>();
  runtime::ThreadedLink link{config, std::make_unique<runtime::FakeBus>(robot)};
  const std::atomic<bool> stop{false};
  Commands commands;
  commands.start_where_it_is = true;
  while (link.sensors().safety.state != State::kDriven) {
    link.publish(commands);
    (void)link.waitForCycle(link.sensors().cycle + 1, stop);
  }
  end(*robot);
}

/// The terminal of both is closed; it goes on.
void hang(darwinop::runtime::FakeRobot&) {
  std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGINT, SIG_IGN);
  kill(getppid(), SIGHUP);
  for (;;) pause();
}
}  // namespace

int main(int count, char** arguments) {
  using namespace darwinop::runtime;
  const std::string_view end = count > 1 ? arguments[1] : "";
  if (end == "away") return 3;  // never makes a robot here
  if (end == "crash") drive([](FakeRobot&) { std::raise(SIGKILL); });
  if (end == "leave") drive([](FakeRobot&) { _exit(0); });
  if (end == "rest") return drive([](FakeRobot&) {}), 0;
  if (end == "unplug Neck") return drive([](FakeRobot& robot) { robot.dead[index(darwinop::Joint::kNeck)] = true; }), 0;
  if (end == "hang") drive(hang);
  SimulatedRobot sim;
  stop_flag = &sim.stop;
  sim.step({}, 20);
  std::cout << "robot=" << std::getenv("DARWINOP_ROBOT") << " period=" << std::getenv("DARWINOP_PERIOD_MS")
            << std::endl;
  if (end == "die") std::raise(SIGKILL);
  if (end == "wait") {
    std::signal(SIGTERM, [](int) { *stop_flag = true; });
    kill(getppid(), SIGTERM);  // it must come back to us
    while (!sim.stop) usleep(1000);
    return 5;
  }
  sim.link.reset();
  return 7;
}
