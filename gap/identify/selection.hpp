// Forward selection of effects: one at a time, with pruning after each, until the residual is noise or no effect
// explains it.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "gap/identify/assessment.hpp"
#include "gap/identify/screen.hpp"

namespace darwinop::gap {

class Selection {
 public:
  /// Fits the baseline alone. `study` and `options` must outlive this.
  Selection(const Study& study, const IdentifyOptions& options, Nuisance nuisance);

  /// Adds, prunes and replaces effects until the residual is explained or no candidate passes. Where the first effect
  /// explained little, again from the best pair of basic effects.
  void run();
  /// Takes the effects of another selection over, or only these of them, refitted with this one's nuisance mode.
  /// Does not search for others.
  void adopt(const Selection& other);
  void adopt(const Selection& other, const Effects& effects);

  /// The misfit is below its threshold. (The floor of a model that is far off may be as large as its gap; its misfit is
  /// large.)
  [[nodiscard]] bool leavesNoise() const;
  /// The residual is noise, or the difference between two implementations of the same effect.
  [[nodiscard]] bool explainsAll() const;
  /// explainsAll(), and no number left its prior.
  [[nodiscard]] bool isConsistent() const;
  /// Two effects, and still a large share of the gap.
  [[nodiscard]] bool leavesMostOfTheGap() const;
  [[nodiscard]] const FittedModel& model() const { return model_; }
  /// Effects that came close to one that was added.
  [[nodiscard]] const std::vector<const twin::EffectInfo*>& runnersUp() const { return runners_up_; }
  [[nodiscard]] Identification result() const;

 private:
  /// A candidate that passed all tests.
  struct Choice {
    const FittedModel* model = nullptr;  // null: none passed
    double gain = 0, needed = 0;
    std::vector<FittedModel> present;      // the present effects under the noise of each candidate that was tested
    std::vector<RejectedEffect> rejected;  // that gain more than chance
  };

  // screen, refine
  void search();
  void assess(const Screen* screen);
  [[nodiscard]] bool isExplained(const Screen& screen) const;
  [[nodiscard]] bool mayAdd() const;
  bool addOne(const Screen& screen);
  [[nodiscard]] std::vector<const twin::EffectInfo*> aliasesInConflict() const;
  // select, cross-validate
  bool addFrom(const std::vector<FittedModel>& candidates);
  [[nodiscard]] Choice choose(const std::vector<FittedModel>& candidates) const;
  [[nodiscard]] bool passes(const FittedModel& candidate, double gain, double needed) const;
  [[nodiscard]] bool staysInsideItsPrior(const FittedModel& candidate, const twin::EffectInfo& effect) const;
  [[nodiscard]] bool predictsBetter(const FittedModel& candidate, const FittedModel& present, double gain) const;
  [[nodiscard]] double neededFor(const twin::EffectInfo& effect) const;
  void add(const FittedModel& best, double gain, double needed, const std::vector<FittedModel>& candidates);
  bool improveFrom(const FittedModel& same);
  bool improvePastAStuckLog();
  // prune
  void prune();
  void freeSecondaryParameters();
  void dropNeedless();
  bool simplifyOne();
  void replace(std::size_t i, const FittedModel& simpler, double gain);
  [[nodiscard]] bool maySwap() const;
  [[nodiscard]] bool isFull() const;
  bool swapOne();
  /// Cost that effect `i` removes, in the presence of the others.
  [[nodiscard]] double gainOf(std::size_t i) const;
  [[nodiscard]] double leastGainOf(const twin::EffectInfo& effect) const;
  // pairs
  [[nodiscard]] bool beganAtASaddle() const;
  [[nodiscard]] bool isSound(const FittedModel& pair) const;
  bool takeBetterPair();
  // verdict
  [[nodiscard]] bool isNearlyExact() const;
  template <class... Values>
  void report(const char* format, Values... values) const {
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    options_.progress(text);
  }

  const Study& study_;
  const IdentifyOptions& options_;
  std::vector<const twin::EffectInfo*> candidates_;  // of the catalogue
  FittedModel bare_, model_;                         // without effects; with what was added so far
  std::vector<double> gains_;                        // one for each effect of model_
  std::vector<Rival> rivals_;
  std::vector<const twin::EffectInfo*> runners_up_;
  std::vector<RejectedEffect> rejected_;                 // of the last round
  double first_share_ = 0;                               // of the cost beyond noise, that the first effect removed
  double threshold_ = 0, misfit_ = 0, excess_cost_ = 0;  // of model_: chance gain, misfit, cost beyond noise
};

}  // namespace darwinop::gap
