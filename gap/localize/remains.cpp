#include <algorithm>
#include <cmath>

#include "core/text/formatted.hpp"
#include "gap/localize/localization.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Share of the energy of all positions that lies in the strongest place.
double shareOf(const GapInterval& place, const Localization& where) {
  double all = 0;
  for (const LogResidual& log : where.residuals) all += log.z.squaredNorm();
  return all > 0 ? place.chi2 / all : 0;
}

std::string whereText(const Localization& where) {
  const GapInterval& place = where.places.front();
  std::string text = text::formatted(" It is greatest in %s from %.2f to %.2f s, during %s: %.3g %s of %s.",
                                     place.file.c_str(), place.t0_s, place.t1_s, place.happens.c_str(), place.size,
                                     place.unit.c_str(), place.signal.c_str());
  if (shareOf(place, where) > thresholds::kEventShare)
    text += " Nearly all of it lies there: something happened once, a push or a snag; repeat the log.";
  return text;
}

std::string stateText(const Localization& where) {
  const Dependence& on = where.dependence;
  std::string text;
  const auto clock = [&](Depends depends) {
    if (depends == Depends::kClock) return " It follows the session's clock, not the state: wear, heat or a jolt.";
    if (depends == Depends::kBoth) return " It follows both the state and the session's clock.";
    if (depends == Depends::kState && where.dependence.is_clock_known)
      return " It is the same at any time of the session: a law, not wear.";
    return "";
  };
  if (on.regions.empty() || on.regions.front().information < thresholds::kInformativeBits)
    return std::string{clock(on.on)} + " No state of the joint predicts it: perhaps a hidden state.";
  const Region& first = on.regions.front();
  text += text::formatted(" Of all states the %s is most informative", first.variable.c_str());
  if (first.lift > thresholds::kLiftedBin)
    text += text::formatted(": between %.3g and %.3g %s it is %.1f times the mean", first.low, first.high,
                            first.unit.c_str(), std::sqrt(first.lift));
  return text + "." + clock(on.on);
}

}  // namespace

std::string describeRemainder(const Localization& where) {
  if (where.places.empty()) return "Nothing remains above the noise.";
  std::string text =
      text::formatted("%.2f mrad remain, %.1f times the noise floor.", 1e3 * where.rms_rad(), where.floors());
  if (where.blocks.first)
    text += text::formatted(" Of the loop the %s does not close.", std::string{name(*where.blocks.first)}.c_str());
  return text + whereText(where) + stateText(where);
}

}  // namespace darwinop::gap
