// Forward, one effect at a time; after each, whoever is no longer needed goes; at the end, whoever stands in for
// another is replaced. With the numbers of the baseline as they were given, or with the freedom that their priors
// leave.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "gap/name/judge.hpp"
#include "gap/name/naming.hpp"
#include "gap/name/replicas.hpp"
#include "gap/name/screen.hpp"
#include "gap/name/settled.hpp"

namespace darwinop::gap {

class Search {
 public:
  /// Settles the baseline alone. `given` and `options` have to outlive this.
  Search(const Case& given, const NameOptions& options, Numbers numbers);

  void run();
  /// What another search found, with this one's numbers.
  void take(const Search& other);
  /// Another search's effects, but only these; nothing else is looked for.
  void take(const Search& other, const Effects& effects);

  /// What is left is noise. The floor of a model that is far off may be as large as its gap, but its misfit is not
  /// small.
  [[nodiscard]] bool leavesNoise() const;
  /// What is left is noise, or what two ways to write the same effect differ by.
  [[nodiscard]] bool explainsAll() const;
  /// And no number had to leave its prior.
  [[nodiscard]] bool reachedNoise() const;
  /// Two effects, and still half of the gap.
  [[nodiscard]] bool isHopeless() const;
  [[nodiscard]] const Settled& present() const { return present_; }
  /// Effects that came close to one that was taken.
  [[nodiscard]] const std::vector<const twin::EffectInfo*>& seconds() const { return seconds_; }
  [[nodiscard]] Naming told() const;

 private:
  void judge(const Screen* screen);
  bool accept(const Screen& screen);
  bool acceptOneOf(const std::vector<Settled>& candidates);
  /// `less`: without the effect, on the same noise.
  [[nodiscard]] bool isProven(const Settled& best, const Settled& less, double gain) const;
  void take(const Settled& best, double gain, const std::vector<Settled>& candidates, double needed);
  bool improve(const Settled& same);
  /// What effect `i` takes away, the others being there.
  [[nodiscard]] double gainOf(std::size_t i) const;
  [[nodiscard]] double leastGainOf(const twin::EffectInfo& effect) const {
    return leastGain(given_, present_.hypothesis(), effect, threshold_);
  }
  void refine();
  void dropTheNeedless();
  bool simplifyOne();
  /// Effect `i` by the last one of `plain`.
  void replace(std::size_t i, const Settled& plain, double gain);
  bool replaceOne();
  [[nodiscard]] bool isPractically() const;
  [[nodiscard]] double neededFor(const twin::EffectInfo& effect) const;
  template <class... Values>
  void say(const char* format, Values... values) const {
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    options_.tell(text);
  }

  const Case& given_;
  const NameOptions& options_;
  std::vector<const twin::EffectInfo*> suspects_;
  Settled present_;
  std::vector<double> gains_;  // one an effect
  std::vector<Rival> rivals_;
  std::vector<const twin::EffectInfo*> seconds_;
  double threshold_ = 0, misfit_ = 0, excess_cost_ = 0;
};

}  // namespace darwinop::gap
