// One case with its answer, and what is right or wrong about it.
#pragma once

#include <string>

#include "gap/benchmark/make/answer_key.hpp"
#include "gap/benchmark/score/answers.hpp"

namespace darwinop::gap {

struct GradedCase {
  const Key& key;
  const Answer* answer;  // null: none that counts

  [[nodiscard]] bool said(std::string_view verdict) const;
  /// An effect of the case.
  [[nodiscard]] bool hides(const std::string& id) const;
  /// The effect that the answer found first is one of the case, whatever the verdict.
  [[nodiscard]] bool firstRight() const;
  [[nodiscard]] bool namedFirst() const;
  /// All effects, and nothing else.
  [[nodiscard]] bool namedAll() const;
  /// Named, or in an ambiguity that is small enough to help.
  [[nodiscard]] bool honest() const;
  /// Something was made of nothing; no answer counts as that, too.
  [[nodiscard]] bool alarm() const;
  /// One of the first places is one where the stranger shows; true where the key does not tell.
  [[nodiscard]] bool rightPlace() const;
  /// A hidden effect acts in this block of the loop; what no catalogue has acts in the plant.
  [[nodiscard]] bool acts(std::string_view block) const;
  [[nodiscard]] bool rightBlock() const;
  /// The block that opens before any fit is one of them.
  [[nodiscard]] bool firstOpenBlockRight() const;
  /// Nothing at all is wrong with the verdict.
  [[nodiscard]] bool right() const;

  /// The answer is fair: named, in a small ambiguity, `none`, or `unknown`, as the case requires.
  [[nodiscard]] bool fair() const;

  /// "coulomb + backlash", for a list of confusions.
  [[nodiscard]] std::string truth() const;
  [[nodiscard]] std::string answered() const;
};

}  // namespace darwinop::gap
