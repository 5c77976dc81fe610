// The cycle with the real bus allocates nothing, whatever happens on the line.
#include <gtest/gtest.h>

#include "campaign/wild_controller.hpp"
#include "hal/cm730/bus.hpp"
#include "hil-mocks/memory_line.hpp"
#include "runtime/cycle.hpp"
#include "safety/guard.hpp"
#include "support/allocation_probe.hpp"

namespace darwinop {
namespace {

constexpr Nanos kPeriod{16'000'000};

TEST(Cycle, AllocatesNothingInTenThousandCyclesUnderFaults) {
  hil::VirtualRobot robot;
  hil::InjectedFault faults;
  faults.kind = hil::FaultKind::kRandom;
  faults.amount = 2.0;  // a second
  robot.faults().add(faults);
  hil::MemoryLine line{robot};
  cm730::Cm730Bus bus{line, cm730::BusConfig::forPeriod(kPeriod)};
  safety::Guard guard{safety::Config{}};
  runtime::Cycle cycle{bus, guard, kPeriod};
  WildController controller{1};
  Nanos release{0};
  const long before = allocationsOfThisThread();
  for (int i = 0; i < 10'000; ++i) {
    release += kPeriod;
    line.advanceTo(release);
    cycle.run(controller.next(), {.release = release});
  }
  EXPECT_EQ(allocationsOfThisThread(), before);
  EXPECT_GT(robot.faults().begun(), 100U);
}

}  // namespace
}  // namespace darwinop
