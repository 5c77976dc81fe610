// One case with its result, compared with the answer key.
#pragma once

#include <string>

#include "gap/benchmark/make/answer_key.hpp"
#include "gap/benchmark/score/answers.hpp"

namespace darwinop::gap {

struct GradedCase {
  const Key& key;
  const CaseAnswer* answer;  // null: none that counts

  [[nodiscard]] bool hasVerdict(std::string_view verdict) const;
  /// An effect of the case.
  [[nodiscard]] bool hides(const std::string& id) const;
  /// The effect that the answer found first is one of the case, whatever the verdict.
  [[nodiscard]] bool firstRight() const;
  [[nodiscard]] bool namedFirst() const;
  /// All effects, and nothing else.
  [[nodiscard]] bool namedAll() const;
  /// Named, or in an ambiguity that is small enough to help.
  [[nodiscard]] bool honest() const;
  /// Every named effect is hidden, or in the ambiguity.
  [[nodiscard]] bool namesNothingFalse() const;
  /// False alarm: an effect-free case with a finding, or without a result.
  [[nodiscard]] bool alarm() const;
  /// One of the first places is one where the effect outside the catalogue shows; true where the key has no places.
  [[nodiscard]] bool rightPlace() const;
  /// A hidden effect acts in this block of the loop; effects outside the catalogue act in the plant.
  [[nodiscard]] bool acts(std::string_view block) const;
  [[nodiscard]] bool rightBlock() const;
  /// The first open block before any fit is one of them.
  [[nodiscard]] bool firstOpenBlockRight() const;
  /// The verdict and all effects are right.
  [[nodiscard]] bool right() const;

  /// The answer is fair: named, in a small ambiguity, `none`, or `unknown`, as the case requires.
  [[nodiscard]] bool fair() const;

  /// "coulomb + backlash", for a list of confusions.
  [[nodiscard]] std::string truth() const;
  [[nodiscard]] std::string answered() const;
};

}  // namespace darwinop::gap
