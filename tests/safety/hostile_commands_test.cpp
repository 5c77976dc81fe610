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
  for (int cycle = 0; cycle < 600; ++cycle) {
    const Commands image = randomImage(random);
    if (random() % 2 == 0) commands.joint = image.joint;
    if (random() % 8 == 0) commands.led = image.led;
    if (random() % 20 == 0) commands = image;
    if (random() % 50 == 0) ++commands.session;
    if (random() % 10 != 0) commands.end_of_session = commands.hold = false;
    ++commands.sequence;
    const SafeCommands safe = guard.vet(commands, robot.seen);
    const std::string wrong = invariants.check(safe, robot.seen);
    if (!wrong.empty()) RC_FAIL("cycle " + std::to_string(cycle) + ": " + wrong);
    robot.cycle(safe);
  }
}

}  // namespace
}  // namespace darwinop::safety
