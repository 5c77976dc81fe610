// A daemon with a fake robot in a process of its own.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "child.hpp"
#include "fake_bus.hpp"
#include "runtime/daemon.hpp"
#include "runtime/daemon_link.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::runtime {

inline std::atomic<bool> end_requested{false};

// Exit codes of the child.
inline constexpr int kLostAtRest = 3, kLeftStiff = 4;

struct Cables {
  bool power, unplugged;
  double volt = 11.8;
  std::chrono::milliseconds first_cycle{0};  // duration
};

/// Its first cycle takes longer.
class LateBus final : public ServoBus {
 public:
  LateBus(std::unique_ptr<ServoBus> bus, std::chrono::milliseconds first) : bus_{std::move(bus)}, first_{first} {}
  void write(const SafeCommands& commands) noexcept override {
    std::this_thread::sleep_for(std::exchange(first_, std::chrono::milliseconds{0}));
    bus_->write(commands);
  }
  void read(BusReadings& readings) noexcept override { bus_->read(readings); }

 private:
  std::unique_ptr<ServoBus> bus_;
  std::chrono::milliseconds first_;
};

/// A daemon with a fake robot, 4 ms, in a child process.
class DaemonTest : public testing::Test {
 protected:
  static void serve(const RuntimeFiles& files, std::unique_ptr<Daemon>& daemon, Cables cables = {true, false}) {
    LoopConfig config;
    config.period = std::chrono::milliseconds{4};
    config.port = "a fake";
    const auto robot = std::make_shared<FakeRobot>();
    robot->power = cables.power;
    robot->unplugged = cables.unplugged;
    robot->volt = cables.volt;
    daemon = std::make_unique<Daemon>(config, files, claimRuntime(files, getgid()), getgid(),
                                      std::make_unique<LateBus>(std::make_unique<FakeBus>(robot), cables.first_cycle));
    std::signal(SIGTERM, [](int) { end_requested = true; });
    std::thread{[&daemon, robot] {
      int status = 0;
      try {
        (void)daemon->run(end_requested);
      } catch (const std::runtime_error& error) {
        std::cerr << error.what() << std::endl;
        status = kLostAtRest;
      }
      daemon.reset();
      if (std::ranges::find(robot->torque, true) != robot->torque.end()) status = kLeftStiff;
      _exit(status);
    }}.detach();
  }

  static Commands neckTo(double angle) {
    Commands commands;
    commands.start_where_it_is = true;
    commands.joint[index(Joint::kNeck)].setGoal(Rad{angle});
    return commands;
  }

  /// Drives until the robot obeys and the neck is there.
  static void drive(DaemonLink& link, double neck, const std::atomic<bool>& stop) {
    for (int i = 0; i < 2000; ++i) {
      link.publish(neckTo(neck));
      ASSERT_TRUE(link.waitForCycle(link.sensors().cycle + 1, stop)) << link.whyEnded();
      if (std::abs(link.sensors().joint[index(Joint::kNeck)].position.value - neck) < 1e-6) return;
    }
    FAIL() << "the neck did not get there";
  }

  std::string refusal() const {
    try {
      const DaemonLink link{files_};
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  }

  /// The daemon records what it sees within a moment.
  static bool recorded(const std::string& marker, bool set) {
    for (int i = 0; i < 500; ++i, std::this_thread::sleep_for(std::chrono::milliseconds{10}))
      if (textOf(marker) == (set ? "1\n" : "0\n")) return true;
    return false;
  }

  TemporaryFolder folder_;
  RuntimeFiles files_{folder_ / "runtime"};
  std::unique_ptr<Daemon> daemon_;  // lives in the child
  Child child_{[this] { serve(files_, daemon_); }};
  std::atomic<bool> stop_{false};
};

}  // namespace darwinop::runtime
