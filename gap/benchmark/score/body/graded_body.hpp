// One case of the whole robot with its answer, compared with the answer key.
#pragma once

#include <cstdint>
#include <string>

#include "gap/benchmark/score/body/body_answers.hpp"

namespace darwinop::gap {

/// Rows of the exam.
enum class BodyKind : std::uint8_t {
  kSensor,
  kMass,
  kContact,
  kOneJoint,
  kManyJoints,
  kBus,
  kTwo,
  kExact,
  kWrong,
  kOutside
};

/// Effects of a catalogue that are one thing.
bool isSameEffect(const BodyKeyEffect& hidden, const PlacedName& name);
bool isSamePlace(const BodyKeyEffect& hidden, const PlacedName& name);

struct GradedBody {
  const BodyKey& key;
  const BodyAnswer* answer;  // null: none that counts

  [[nodiscard]] BodyKind kind() const;
  /// The answer names this effect, and in its place.
  [[nodiscard]] bool names(const BodyKeyEffect& hidden) const;
  [[nodiscard]] bool namesInPlace(const BodyKeyEffect& hidden) const;
  /// Or has it in an ambiguity of at most three.
  [[nodiscard]] bool namesOrDoubts(const BodyKeyEffect& hidden) const;
  [[nodiscard]] bool placeRight(const BodyKeyEffect& hidden) const;
  /// All numbers of the key that the answer has are within this share of what is hidden, for a scale its distance from
  /// 1, or within `absolute` of their unit.
  [[nodiscard]] bool numbersWithin(const BodyKeyEffect& hidden, double share, double absolute) const;
  /// The first name of the answer is hidden, and in its place.
  [[nodiscard]] bool firstRight() const;
  [[nodiscard]] bool alarm() const;
  /// Outside of the catalogue: a signal of the place is open.
  [[nodiscard]] bool whereRight() const;
  /// All names and nothing else; silence where nothing is hidden; no name where no catalogue has one.
  [[nodiscard]] bool right() const;

  [[nodiscard]] std::string truth() const;
  [[nodiscard]] std::string answered() const;
};

}  // namespace darwinop::gap
