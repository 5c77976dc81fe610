// A finding of the start-up check: severity, description and remedy.
#pragma once

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/joints.hpp"
#include "hal/cm730/diagnosis/start_policy.hpp"

namespace darwinop::cm730 {

enum class Level : std::uint8_t {
  kOk,
  kWarning,  // the robot can be driven; a fix is recommended
  kError,    // the robot cannot be driven: a loop does not start, or sits it down at once
};

constexpr Level levelOf(Kind kind) {
  return policyOf(kind) <= Policy::kNoWrites ? Level::kWarning : Level::kError;
}

struct Finding {
  Level level = Level::kOk;
  std::string what;
  std::string remedy;            // a sentence or a command; may be empty
  Kinds kinds{};                 // empty: ok
  std::optional<Joint> joint{};  // set in a servo's row

  static Finding ok(std::string what) { return {Level::kOk, std::move(what), {}, {}, {}}; }
  /// The severity comes from the table in start_policy.hpp.
  static Finding of(Kind kind, std::string what, std::string remedy) {
    Finding finding{levelOf(kind), std::move(what), std::move(remedy), {}, {}};
    finding.kinds.set(static_cast<std::size_t>(kind));
    return finding;
  }
  [[nodiscard]] bool is(Kind kind) const { return kinds[static_cast<std::size_t>(kind)]; }
};
using Findings = std::vector<Finding>;

inline Level worst(std::span<const Finding> findings) {
  Level level = Level::kOk;
  for (const Finding& finding : findings) level = std::max(level, finding.level);
  return level;
}

/// The start-up policy for all findings together.
inline Policy decide(std::span<const Finding> findings, Purpose purpose) {
  Policy policy = Policy::kDrive;
  for (const Finding& finding : findings) policy = std::max(policy, policyOf(finding.kinds, purpose));
  return policy;
}

/// Joints with a finding of that policy.
inline std::bitset<kJoints> jointsWith(Policy policy, std::span<const Finding> findings, Purpose purpose) {
  std::bitset<kJoints> joints;
  for (const Finding& finding : findings)
    for (std::size_t i = 0; i < kKinds; ++i)
      if (finding.joint && finding.kinds[i] && policyOf(static_cast<Kind>(i), purpose) == policy)
        joints.set(index(*finding.joint));
  return joints;
}

/// Joints to which nothing is written.
inline std::bitset<kJoints> noWrites(std::span<const Finding> findings, Purpose purpose) {
  return jointsWith(Policy::kNoWrites, findings, purpose);
}

/// Joints that are not driven.
inline std::bitset<kJoints> leftOut(std::span<const Finding> findings, Purpose purpose) {
  return jointsWith(Policy::kLeaveOut, findings, purpose) | noWrites(findings, purpose);
}

/// "warn  what" and, if there is one, a line "      -> remedy".
inline std::string toText(const Finding& finding) {
  static constexpr const char* kMarks[] = {"ok    ", "warn  ", "FAIL  "};
  std::string text = kMarks[static_cast<std::size_t>(finding.level)] + finding.what + "\n";
  if (!finding.remedy.empty()) text += "      -> " + finding.remedy + "\n";
  return text;
}

}  // namespace darwinop::cm730
