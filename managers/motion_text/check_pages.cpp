// Checks motion pages for errors that could make the robot fall.
#include "managers/motion_text/check_pages.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/conversions.hpp"
#include "core/text/number_text.hpp"
#include "managers/motion/joint_track.hpp"
#include "managers/motion_text/dry_run.hpp"
#include "managers/motion_text/values.hpp"

namespace darwinop::motion {

namespace {

constexpr double kTickSeconds = kTickMs / 1000.0;
// With a register of 4 a leg reaches full duty only at an error of 180 degrees, so it collapses under the robot.
constexpr int kMinLegGain = 8;
constexpr int kJump = 12;  // ticks, 1.05 degrees: minimum for a finding

std::string degrees(int ticks) {
  return text::fixedText((ticks - kTickCentre) * kDegreesPerTick, 2);
}

std::string at(std::size_t page, std::size_t step, std::size_t joint) {
  return "page " + std::to_string(page) + ", step " + std::to_string(step + 1) + ", " +
         std::string{kJointTable.at(joint).name} + ": ";
}

class Check {
 public:
  explicit Check(const PageFile& pages) : pages_{pages} {}

  std::vector<std::string> run() {
    for (std::size_t i = 1; i < pages_.size(); ++i) {
      if (!pages_[i].canPlay()) continue;
      checkLink(i, "next", pages_[i].next);
      checkLink(i, "exit", pages_[i].exit);
      checkLoop(i);
      checkGains(i);
      for (std::size_t step = 0; step < pages_[i].steps; ++step) checkPositions(i, step);
      checkSpeeds(i);
    }
    return std::move(found_);
  }

 private:
  void checkLink(std::size_t page, const std::string& which, std::uint8_t target) {
    if (target != 0 && !pages_[target].canPlay())
      found_.push_back("page " + std::to_string(page) + ": " + which + " is page " + std::to_string(target) +
                       ", which is empty");
  }

  /// Reports each endless chain once, with its lowest page. An exit page does not end it: it is played after a stop
  /// request, which the motion manager never makes.
  void checkLoop(std::size_t page) {
    std::vector<std::size_t> loop;
    for (std::size_t at = page; std::ranges::find(loop, at) == loop.end(); at = pages_[at].next) {
      if (!pages_[at].canPlay() || at < page) return;
      loop.push_back(at);
      if (pages_[at].next == 0) return;
    }
    if (pages_[loop.back()].next != page) return;
    std::string chain;
    for (const std::size_t one : loop) chain += std::to_string(one) + " -> ";
    found_.push_back("page " + std::to_string(page) + ": " + chain + std::to_string(page) + " never ends");
  }

  /// The page's gains apply to every joint, also to those that do not move.
  void checkGains(std::size_t page) {
    for (std::size_t i = 0; i < kJoints; ++i) {
      const int gain = pGainRegister(pages_[page].slopes.at(i + 1));  // by servo id
      const std::string joint = "page " + std::to_string(page) + ", " + std::string{kJointTable.at(i).name} + ": ";
      if (gain == 0)
        found_.push_back(joint + "its P gain is 0; the joint is limp while the page is played");
      else if (gain < kMinLegGain && isLeg(static_cast<Joint>(i)))
        found_.push_back(joint + "with a P gain of " + std::to_string(gain) + " the leg collapses; the minimum is " +
                         std::to_string(kMinLegGain));
    }
  }

  void checkPositions(std::size_t page, std::size_t step) {
    for (std::size_t i = 0; i < kJoints; ++i) {
      const std::uint16_t word = pages_[page].step.at(step).position.at(i + 1);  // by servo id
      if ((word & (kKeep | kTorqueOff)) != 0) continue;
      const JointRow& joint = kJointTable.at(i);
      if (word > kTickMax)
        found_.push_back(at(page, step, i) + angleText(word) + " is neither a position nor 'keep'");
      else if (word < joint.low)
        found_.push_back(at(page, step, i) + degrees(word) + " degrees is below the joint's limit, " +
                         degrees(joint.low));
      else if (word > joint.high)
        found_.push_back(at(page, step, i) + degrees(word) + " degrees is above the joint's limit, " +
                         degrees(joint.high));
    }
  }

  /// Uses the mean speed: if that is too high, no velocity profile can reach the target.
  void checkSpeeds(std::size_t page) {
    for (const Move& move : movesOf(pages_, static_cast<int>(page))) {
      const double seconds = std::max(1, move.ticks) * kTickSeconds;
      const std::string before =
          move.page == static_cast<int>(page) ? "" : ", coming from page " + std::to_string(page);
      checkJump(move, seconds, before);
      for (std::size_t i = 0; i < kJoints; ++i) {
        const double distance = move.distance.at(i) * kDegreesPerTick;
        if (distance * kRadPerDegree / seconds <= kMaxVelocity) continue;
        keep(at(static_cast<std::size_t>(move.page), move.step, i) + text::fixedText(distance, 2) + " degrees in " +
             text::fixedText(seconds, 3) + " s are " + text::fixedText(distance / seconds, 0) +
             " degrees/s; the servo's maximum is " + text::fixedText(kMaxVelocity / kRadPerDegree, 0) + before);
      }
    }
  }
  void checkJump(const Move& move, double seconds, const std::string& before) {
    const auto farthest = std::ranges::max_element(move.distance);
    const int acceleration = pages_.at(static_cast<std::size_t>(move.page)).acceleration;
    if (StepTimes::fitted(move.ticks, acceleration).total > 0 || *farthest < kJump) return;
    keep(
        at(static_cast<std::size_t>(move.page), move.step, static_cast<std::size_t>(farthest - move.distance.begin())) +
        "the goal jumps by " + text::fixedText(*farthest * kDegreesPerTick, 2) +
        " degrees: " + text::fixedText(seconds, 3) + " s are too short for a motion" + before);
  }
  /// Without duplicates: a page that repeats reaches its first step twice.
  void keep(const std::string& finding) {
    if (std::ranges::find(found_, finding) == found_.end()) found_.push_back(finding);
  }

  const PageFile& pages_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> checkPages(const PageFile& pages) {
  return Check{pages}.run();
}

std::vector<std::string> checkBytes(std::span<const std::uint8_t> bytes, PageFile& pages) {
  pages.clear();
  try {
    pages = decodePages(bytes);
    return {};
  } catch (const std::runtime_error& why) {
    if (bytes.size() != kFileBytes) return {why.what()};
  }
  // Decodes each page separately in an empty file, to report every damaged page.
  std::vector<std::string> damages;
  pages.assign(kPages, emptyPage());
  const std::vector<std::uint8_t> empty = encodePages(pages);
  for (std::size_t i = 0; i < kPages; ++i) {
    std::vector<std::uint8_t> alone = empty;
    std::ranges::copy(bytes.subspan(i * kPageBytes, kPageBytes),
                      alone.begin() + static_cast<std::ptrdiff_t>(i * kPageBytes));
    try {
      pages[i] = decodePages(alone)[i];
    } catch (const std::runtime_error& why) {
      damages.emplace_back(why.what());
    }
  }
  return damages;
}

}  // namespace darwinop::motion
