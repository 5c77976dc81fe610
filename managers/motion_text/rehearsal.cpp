// Plays one page by itself, as the robot's engine does.
#include "managers/motion_text/rehearsal.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/conversions.hpp"

namespace darwinop::motion {

Pose firstPose(const Page& page) {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    pose[i] = kJointTable[i].start;
    for (std::size_t step = 0; step < page.steps; ++step) {
      const std::uint16_t word = page.step.at(step).position.at(i + 1);  // by servo id
      if (word > kTickMax) continue;
      pose[i] = word;
      break;
    }
  }
  return pose;
}

namespace {

constexpr int kLongestStep = 70'000;  // ticks: at speed 1 across the whole range, and the longest pause

int ticksOnce(const Page& asked) {
  PageFile alone(2, emptyPage());
  alone[1] = asked;
  alone[1].repeat = 1;
  alone[1].next = alone[1].exit = 0;
  Player player{alone};
  int ticks = 0;
  player.start(1, firstPose(asked));
  while (player.tick()) ++ticks;
  return ticks;
}

}  // namespace

int ticksOf(const PageFile& pages, int page) {
  const Page& asked = pages.at(static_cast<std::size_t>(page));
  return asked.canPlay() ? ticksOnce(asked) * asked.repeat : 0;
}

std::vector<StepSpeeds> rehearse(const PageFile& pages, int page) {
  std::vector<StepSpeeds> steps;
  const Page& asked = pages.at(static_cast<std::size_t>(page));
  Player player{pages};
  Pose before = firstPose(asked);
  player.start(page, before);
  const std::size_t wanted = asked.steps + 1U;  // and the first step of what comes next
  // A page of one step that repeats looks the same each time: twice is enough.
  for (int left = asked.canPlay() ? 2 * ticksOnce(asked) + kLongestStep : 0; left > 0 && player.tick(); --left) {
    const auto step = static_cast<std::size_t>(player.step());
    const bool new_step = steps.empty() || steps.back().page != player.page() || steps.back().step != step;
    if (new_step && steps.size() == wanted) break;
    if (new_step) steps.push_back({player.page(), step, {}});
    for (std::size_t i = 0; i < kJoints; ++i) {
      steps.back().most[i] = std::max(steps.back().most[i], std::abs(player.pose()[i] - before[i]));
    }
    before = player.pose();
  }
  return steps;
}

}  // namespace darwinop::motion
