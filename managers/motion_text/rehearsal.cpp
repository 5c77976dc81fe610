// Goes through one page by itself.
#include "managers/motion_text/rehearsal.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/conversions.hpp"

namespace darwinop::motion {

namespace {

/// As the player has it: by time the page's speed scales it, by speed the longest way sets it. Source: docs/motions.md.
int moveTicks(const Page& page, const Step& step, int longest) {
  const int scaled = std::max(1, (step.time * page.speed) >> 5);
  return page.schedule == kTimeBased ? scaled : 40 * longest / (3 * scaled);
}

/// Adds the step to `moves`, and goes to it.
void take(std::vector<Move>& moves, const PageFile& pages, int number, std::size_t at, Pose& pose) {
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
  const Page& asked = pages.at(static_cast<std::size_t>(page));
  if (!asked.canPlay()) return 0;
  PageFile alone(2, emptyPage());
  alone[1] = asked;
  alone[1].repeat = 1;
  alone[1].next = alone[1].exit = 0;
  Player player{alone};
  int ticks = 0;
  player.start(1, firstPose(asked));
  while (player.tick()) ++ticks;
  return ticks * asked.repeat;
}

std::vector<Move> movesOf(const PageFile& pages, int page) {
  std::vector<Move> moves;
  const Page& asked = pages.at(static_cast<std::size_t>(page));
  if (!asked.canPlay()) return moves;
  Pose pose = firstPose(asked);
  for (std::size_t i = 0; i < asked.steps; ++i) take(moves, pages, page, i, pose);
  Pose after = pose;
  if (asked.repeat > 1) take(moves, pages, page, 0, after);
  if (asked.next != 0 && pages.at(asked.next).canPlay()) take(moves, pages, asked.next, 0, pose);
  return moves;
}

Rehearsal rehearse(const PageFile& pages, int page, const Pose& from) {
  constexpr std::size_t kMost = 60'000 / kTickMs;
  PageFile ending = pages;  // a page that follows itself cannot be told from a repetition
  for (std::size_t i = 0; i < ending.size(); ++i)
    if (ending[i].next == i) ending[i].next = 0;
  Rehearsal played;
  played.poses.push_back(from);
  Player player{ending};
  player.start(page, from);
  int step = -1;
  while (player.tick()) {
    const int now = player.page();
    const bool new_page = played.sections.empty() || played.sections.back().page != now;
    const auto seen = [now](const Rehearsal::Section& section) { return section.page == now; };
    played.cut = played.poses.size() > kMost || (new_page && std::ranges::any_of(played.sections, seen));
    if (played.cut) break;
    const std::size_t at = played.poses.size() - 1;  // what was reached before this tick
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
