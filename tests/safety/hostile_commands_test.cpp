// Images of commands whose every byte is random: what a program can leave in shared memory.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>

#include "safety/fake_robot.hpp"
#include "safety/guard.hpp"
#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

Commands randomImage(std::mt19937& random) {
  std::array<unsigned char, sizeof(Commands)> bytes;
  std::ranges::generate(bytes, [&] { return static_cast<unsigned char>(random()); });
  Commands commands;
  std::memcpy(static_cast<void*>(&commands), bytes.data(), bytes.size());
  return commands;
}

TEST(Flag, EveryByteIsATruthValue) {
  for (int byte = 0; byte < 256; ++byte) {
    Flag flag;
    std::memset(static_cast<void*>(&flag), byte, sizeof flag);
    EXPECT_EQ(static_cast<bool>(flag), byte != 0);
    EXPECT_EQ(!flag, byte == 0);
  }
}

/// Under the preset asan-ubsan this also judges that no byte is read as what it cannot be.
RC_GTEST_PROP(GuardProperty, RandomBytesInPlaceOfCommandsStayWithinTheLimits, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  std::mt19937 random{seed};
  const Config config;
  Guard guard{config};
  Invariants invariants{config};
  FakeRobot robot;
  Commands commands;
  bool all_random = false;  // from the first image of which every field is random
  int driven = 0;           // cycles after it in which a joint is driven
  for (int cycle = 0; cycle < 600; ++cycle) {
    Commands image = randomImage(random);
    // The loop's own: an operator who releases the robot ends every case.
    image.operator_resets = image.operator_releases = 0;
    if (random() % 2 == 0) image.unattended = false;  // else no session clears a fault
    if (random() % 2 == 0) commands.joint = image.joint;
    if (random() % 8 == 0) commands.led = image.led;
    if (random() % 20 == 0) commands = image, all_random = true;
    if (random() % 50 == 0) ++commands.session;
    if (random() % 10 != 0) commands.end_of_session = commands.hold = false;
    ++commands.sequence;
    const SafeCommands safe = guard.vet(commands, robot.seen);
    const std::string wrong = invariants.check(safe, robot.seen);
    if (!wrong.empty()) RC_FAIL("cycle " + std::to_string(cycle) + ": " + wrong);
    driven += all_random && safe.driven().any() ? 1 : 0;
    robot.cycle(safe);
  }
  RC_ASSERT(driven > 0);
}

}  // namespace
}  // namespace darwinop::safety
