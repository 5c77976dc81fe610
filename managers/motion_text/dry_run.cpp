// Simulates pages without a robot.
#include "managers/motion_text/dry_run.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/conversions.hpp"

namespace darwinop::motion {

namespace {

/// Duration as in the player: by time, scaled by the page's speed; by speed, from the longest distance.
/// docs/motions.md.
int moveTicks(const Page& page, const Step& step, int longest) {
  const int scaled = std::max(1, (step.time * page.speed) >> 5);
  return page.schedule == kTimeBased ? scaled : 40 * longest / (3 * scaled);
}

/// Appends the step to `moves` and sets `pose` to its target.
void addMove(std::vector<Move>& moves, const PageFile& pages, int number, std::size_t at, Pose& pose) {
  const Page& page = pages.at(static_cast<std::size_t>(number));
  const Step& step = page.step.at(at);
  Move move{number, at, 0, {}};
  for (std::size_t i = 0; i < kJoints; ++i) {
    const std::uint16_t word = step.position.at(i + 1);  // by servo id
    const int target = (word & (kKeep | kTorqueOff)) != 0 ? pose[i] : std::min<int>(word, kTickMax);
    move.distance[i] = std::abs(target - pose[i]);
    pose[i] = target;
  }
  move.ticks = moveTicks(page, step, *std::ranges::max_element(move.distance));
  moves.push_back(move);
}

}  // namespace

Pose firstPose(const Page& page) {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    pose[i] = kJointTable[i].start;
    for (std::size_t step = 0; step < page.steps; ++step) {
      const std::uint16_t word = page.step.at(step).position.at(i + 1);  // by servo id
      if ((word & (kKeep | kTorqueOff)) != 0) continue;
      pose[i] = std::min<int>(word, kTickMax);
      break;
    }
  }
  return pose;
}

int ticksOf(const PageFile& pages, int page) {
  const Page& requested = pages.at(static_cast<std::size_t>(page));
  if (!requested.canPlay()) return 0;
  PageFile alone(2, emptyPage());
  alone[1] = requested;
  alone[1].repeat = 1;
  alone[1].next = alone[1].exit = 0;
  Player player{alone};
  int ticks = 0;
  player.start(1, firstPose(requested));
  while (player.tick()) ++ticks;
  return ticks * requested.repeat;
}

std::vector<Move> movesOf(const PageFile& pages, int page) {
  std::vector<Move> moves;
  const Page& requested = pages.at(static_cast<std::size_t>(page));
  if (!requested.canPlay()) return moves;
  Pose pose = firstPose(requested);
  for (std::size_t i = 0; i < requested.steps; ++i) addMove(moves, pages, page, i, pose);
  Pose after = pose;
  if (requested.repeat > 1) addMove(moves, pages, page, 0, after);
  if (requested.next != 0 && pages.at(requested.next).canPlay()) addMove(moves, pages, requested.next, 0, pose);
  return moves;
}

DryRun dryRun(const PageFile& pages, int page, const Pose& from) {
  constexpr std::size_t kMaxTicks = 60'000 / kTickMs;
  PageFile ending = pages;  // without self-links, which are indistinguishable from repetitions
  for (std::size_t i = 0; i < ending.size(); ++i)
    if (ending[i].next == i) ending[i].next = 0;
  DryRun played;
  played.poses.push_back(from);
  Player player{ending};
  player.start(page, from);
  int step = -1;
  while (player.tick()) {
    const int now = player.page();
    const bool new_page = played.sections.empty() || played.sections.back().page != now;
    const auto is_repeated = [now](const DryRun::Section& section) { return section.page == now; };
    played.cut = played.poses.size() > kMaxTicks || (new_page && std::ranges::any_of(played.sections, is_repeated));
    if (played.cut) break;
    const std::size_t at = played.poses.size() - 1;  // pose before this tick
    if (new_page) played.sections.push_back({now, at, {}});
    if (new_page || player.step() != step) played.sections.back().steps.push_back(at);
    step = player.step();
    played.poses.push_back(player.pose());
  }
  const auto last = static_cast<std::size_t>(played.sections.back().page);
  played.cut = played.cut || pages[last].next == last;
  return played;
}

}  // namespace darwinop::motion
