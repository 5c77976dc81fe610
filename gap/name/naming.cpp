// Two searches: one believes every number of the baseline, one lets them move as far as their priors do. The simpler
// explanation wins, by its evidence.
#include "gap/name/naming.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "gap/name/rough.hpp"
#include "gap/name/search.hpp"
#include "gap/name/unseen.hpp"
#include "gap/sim/freed.hpp"

namespace darwinop::gap {
namespace {

constexpr std::array<std::string_view, 6> kNames{"none", "named", "ambiguous", "unknown", "cannot_tell", "bad_input"};
constexpr std::array<int, 6> kCodes{0, 10, 11, 12, 13, 2};

/// What explains more than a search with exact numbers did, by no more effects and numbers that move; nothing does.
std::optional<Search> withMovedNumbers(const Search& exact, const Search& moved) {
  std::optional<Search> best;
  double most = evidenceFor(exact.present());
  const auto look = [&](const Effects& effects) {
    Search one = moved;
    one.take(exact, effects);
    if (!one.reachedNoise()) return;
    const double evidence = evidenceFor(onNoiseOf(one.present(), exact.present(), true));  // of the same samples
    if (evidence <= most) return;
    most = evidence;
    best.emplace(one);
  };
  look({});
  look(exact.present().effects);
  if (exact.present().effects.size() < 2) return best;
  for (const Chosen& effect : exact.present().effects) look({effect});
  for (const auto* second : exact.seconds())
    if (!has(exact.present().effects, *second)) look({{second}});
  return best;
}

/// Several effects, one of which means a number of the baseline: it may stand for many numbers, each a little off.
bool leansOnANumber(const Case& given, const Effects& effects) {
  return effects.size() > 1 &&
         std::ranges::any_of(effects, [&](const Chosen& effect) { return freesAPrior(given, *effect.info); });
}

/// What the loads and goals alone show: no number of the mechanics can stand in for it.
Effects inTheFirmware(const Effects& effects) {
  Effects proven;
  for (const Chosen& effect : effects)
    if (effect.info->place == twin::Place::kCommand || effect.info->place == twin::Place::kController)
      proven.push_back({effect.info});
  return proven;
}

Naming nameOnRoughNumbers(const Case& given, const NameOptions& options) {
  options.tell("nobody has measured this motor: its numbers move within their priors");
  NameOptions few = options;
  few.most_effects = 2;
  Search moved{given, few, Numbers::kFree};
  moved.run();
  if (moved.leavesNoise() || moved.present().effects.empty()) return moved.told();
  options.tell("what is left is no noise: looking for what foretells best");
  RoughSearch rough{given, options, inTheFirmware(moved.present().effects), moved.present()};
  rough.run();
  return rough.told();
}

}  // namespace

std::string_view nameOf(Verdict verdict) {
  return kNames[static_cast<std::size_t>(verdict)];
}

int exitCodeOf(Verdict verdict) {
  return kCodes[static_cast<std::size_t>(verdict)];
}

Naming nameEffects(const Case& given, const NameOptions& options) {
  if (isRoughlyKnown(given)) return nameOnRoughNumbers(given, options);
  options.tell("comparing with the baseline as it is");
  Search exact{given, options, Numbers::kHeld};
  exact.run();
  if (exact.reachedNoise() && exact.present().effects.empty()) return exact.told();

  options.tell("letting the numbers of the baseline move within their priors");
  Search moved{given, options, Numbers::kFree};
  if (exact.reachedNoise() && !leansOnANumber(given, exact.present().effects)) {
    const std::optional<Search> other = withMovedNumbers(exact, moved);
    return other ? other->told() : exact.told();
  }
  moved.run();
  if (moved.reachedNoise() && !moved.present().effects.empty()) {
    options.tell("the same effects, with every number as it was given");
    exact.take(moved);
  }
  if (exact.reachedNoise() && evidenceFor(exact.present()) > evidenceFor(moved.present())) return exact.told();
  // Numbers that were pulled about for nothing explain nothing, and do harm elsewhere.
  if (moved.explainsAll()) return moved.told();
  if (moved.present().effects.empty() || moved.isHopeless()) return exact.told();
  const Foretold told = foretold(exact.present(), moved.present());
  return told.mean > told.error ? moved.told() : exact.told();
}

}  // namespace darwinop::gap
