// The friction that every servo has may be the simple form of a richer law. Beside the simple one the richer hardly
// gains anything, and a fit that starts elsewhere may not come back to where the two are equal.
#include <algorithm>
#include <optional>
#include <utility>

#include "gap/identify/assessment.hpp"
#include "gap/identify/rough_selection.hpp"

namespace darwinop::gap {
namespace {

/// Confused with `simple`, in the same block, with more parameters.
bool mayGeneralize(const twin::EffectInfo& richer, const twin::EffectInfo& simple) {
  return richer.part == simple.part && unknownsOf(richer).size() > unknownsOf(simple).size() &&
         std::ranges::find(richer.confused_with, simple.id) != richer.confused_with.end();
}

/// `x` with each parameter of `richer` that has the unit of the simple form's at the value of that.
Eigen::VectorXd asSimple(const Problem& problem, const twin::EffectInfo& richer, const twin::EffectInfo& simple,
                         double value, Eigen::VectorXd x) {
  for (std::size_t i = 0; i < problem.unknowns().size(); ++i) {
    const Unknown& unknown = problem.unknowns()[i];
    const auto* const own = std::get_if<EffectParameter>(&unknown.what);
    if (own != nullptr && own->info == &richer && richer.parameters[own->index].unit == simple.parameters[0].unit)
      x[static_cast<Eigen::Index>(i)] = unknown.toSearch(value);
  }
  return problem.inBounds(std::move(x));
}

/// The model with `richer` in place of effect `i`, fitted from where both say the same; nothing if they never do.
std::optional<FittedModel> formOf(const FittedModel& model, std::size_t i, const twin::EffectInfo& richer) {
  const twin::EffectInfo& simple = *model.effects[i].info;
  Effects effects = without(model.effects, i);
  effects.push_back({&richer});
  Problem problem = problemWith(*model.study, *model.evidence, effects, model.nuisance);
  const double value = model.hypothesis().find(simple.id)->values[0];
  const Eigen::VectorXd start =
      asSimple(problem, richer, simple, value, startFrom(problem, model.problem, model.fit.x));
  if (problem.cost(start) > model.fit.cost + thresholds::kCommonEffectGain) return std::nullopt;
  Fit fit = solve(problem, start, {.refine = false});
  FittedModel plain{model.study, effects, model.nuisance, model.evidence, std::move(problem), std::move(fit), 0};
  effects.back().refined = true;
  FittedModel finer = refitUnderNoiseOf(effects, model.nuisance, plain.problem, plain.fit, model);
  if (plain.fit.cost - finer.fit.cost < thresholds::kRareEffectGain) return plain;
  return finer;
}

}  // namespace

std::vector<FittedModel> RoughSelection::richerForms() const {
  std::vector<FittedModel> forms;
  for (std::size_t i = 0; i < model_.effects.size(); ++i)
    for (const twin::EffectInfo* const richer : candidates_) {
      if (!mayGeneralize(*richer, *model_.effects[i].info) || has(model_.effects, *richer)) continue;
      std::optional<FittedModel> form = formOf(model_, i, *richer);
      if (form && model_.fit.cost - form->fit.cost >= thresholds::kRareEffectGain) forms.push_back(*std::move(form));
    }
  return forms;
}

}  // namespace darwinop::gap
