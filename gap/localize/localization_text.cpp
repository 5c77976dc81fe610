#include <algorithm>
#include <cmath>

#include "core/text/formatted.hpp"
#include "core/text/number_text.hpp"
#include "gap/localize/localization.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kPlacesShown = 5, kRegionsShown = 3;

template <class... Values>
std::string line(const char* format, Values... values) {
  std::string out = text::formatted(format, values...);
  while (!out.empty() && out.back() == ' ') out.pop_back();
  return out + "\n";
}

std::string floorText(const Localization& where) {
  RmsSum sum;
  for (const LogFloor& one : where.floor.logs) sum.add(one.positions);
  std::string how =
      where.floor.repeats_rad >= 0 ? "assumed: no fitted log was repeated" : "assumed: no log was repeated";
  if (!where.floor.assumed)
    how = "repeats differ by " + text::fixedText(1e3 * where.floor.repeats_rad, 2) + " mrad, " +
          text::fixedText(where.floor.factor, 2) + " times as much as noise would make them";
  std::string text = line("Floor %.2f mrad (%s)", 1e3 * sum.rms(), how.c_str());
  for (std::size_t i = 0; i < where.floor.logs.size(); ++i)
    if (where.floor.logs[i].bifurcates)
      text +=
          line("      repeats of %s come to rest in different places, which counts as noise", where.files[i].c_str());
  return text;
}

std::string blockText(const BlockFinding& block) {
  const std::string verdict{name(block.verdict)}, which{name(block.block)};
  if (std::isnan(block.rms)) return line("  %-10s %-7s %s", which.c_str(), verdict.c_str(), block.detail.c_str());
  // Of several open blocks.
  const std::string share = block.verdict == BlockVerdict::kOpen && block.share < 1
                                ? text::formatted(", %.0f %% of the gap", 100 * block.share)
                                : "";
  return line("  %-10s %-7s %9.3g %-5s (%.3g expected, %+.0f sigma%s) %s", which.c_str(), verdict.c_str(), block.rms,
              block.unit.c_str(), block.expected_rms, block.significance, share.c_str(), block.detail.c_str());
}

std::string placeText(const GapInterval& place) {
  return line("  %-12s %6.2f to %5.2f s  %-8s %8.3g %-4s %-11s %s", place.file.c_str(), place.t0_s, place.t1_s,
              place.signal.c_str(), place.size, place.unit.c_str(), place.happens.c_str(),
              place.block ? std::string{name(*place.block)}.c_str() : "");
}

std::string regionText(const Region& region) {
  return line("  %-19s %.2f bits; %.1f times the mean at %.3g to %.3g %s", region.variable.c_str(), region.information,
              region.lift, region.low, region.high, region.unit.c_str());
}

}  // namespace

std::string asText(const Localization& where) {
  std::string text = floorText(where);
  text +=
      line("Gap   %.2f mrad, %.1f floors, over %zu logs", 1e3 * where.rms_rad(), where.floors(), where.files.size());
  const auto worst = std::ranges::max_element(where.residuals, {}, &LogResidual::floors);
  if (worst != where.residuals.end())
    text += line("      %.2f mrad, %.1f floors in the worst, %s", 1e3 * worst->rms_rad, worst->floors,
                 where.files[static_cast<std::size_t>(worst - where.residuals.begin())].c_str());
  text += where.blocks.first ? line("Loop: look at the %s first", std::string{name(*where.blocks.first)}.c_str())
                             : line("%s", "Loop: all that could be cut is closed");
  for (const BlockFinding& block : where.blocks.all) text += blockText(block);
  if (where.places.empty()) return text + "Places: none beyond noise and priors\n";
  text += "Places, strongest first\n";
  for (std::size_t i = 0; i < std::min(kPlacesShown, where.places.size()); ++i) text += placeText(where.places[i]);
  const Dependence& on = where.dependence;
  text += line("Depends on %s (%s: state %.0f %%, clock %.0f %% of the variance)", std::string{name(on.on)}.c_str(),
               on.of.c_str(), 100 * on.by_state, 100 * on.by_clock);
  for (std::size_t i = 0; i < std::min(kRegionsShown, on.regions.size()); ++i) text += regionText(on.regions[i]);
  return text;
}

}  // namespace darwinop::gap
