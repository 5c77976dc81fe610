// A model from a manual, and logs of a servo that nobody has measured: no search comes near the noise. Which effects
// help all the same, and go on helping on logs that they have not seen? docs/gap/verdicts.md
#pragma once

#include <vector>

#include "gap/name/naming.hpp"
#include "gap/name/settled.hpp"

namespace darwinop::gap {

/// What nothing explains is borne as noise (gap/fit/unexplained.hpp). The effects that every servo has some of are
/// fitted together, since each alone stands in for the others; then rarer ones, one by one, which have to foretell.
class RoughSearch {
 public:
  /// Begins with these effects of `from`. `given` and `options` have to outlive this.
  RoughSearch(const Case& given, const NameOptions& options, const Effects& effects, const Settled& from);

  void run();
  [[nodiscard]] Naming told() const;

 private:
  void takeTheUsual();
  [[nodiscard]] bool takeNext();
  void dropTheNeedless();
  /// The fit without its effect `i`, on the noise of the fit with it.
  [[nodiscard]] Settled less(std::size_t i) const;
  [[nodiscard]] Verdict verdictOnRemains(const Naming& naming) const;
  [[nodiscard]] bool found(const std::vector<std::string>& effects) const;

  const Case& given_;
  const NameOptions& options_;
  std::vector<const twin::EffectInfo*> suspects_;
  Settled present_;
  std::vector<Rival> rivals_;
  std::vector<Doubted> doubted_;
};

}  // namespace darwinop::gap
