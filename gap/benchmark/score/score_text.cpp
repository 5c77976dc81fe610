// A score for people and for programs.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text/formatted.hpp"
#include "gap/benchmark/score/score.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;

std::string targetText(double at_least, double at_most) {
  if (std::isnan(at_least) && std::isnan(at_most)) return "";
  if (std::isnan(at_least)) return text::formatted("at most %.0f %%", 100 * at_most);
  if (std::isnan(at_most)) return text::formatted("at least %.0f %%", 100 * at_least);
  return text::formatted("%.0f to %.0f %%", 100 * at_least, 100 * at_most);
}

std::string lineOf(const ShareFigure& figure) {
  if (figure.of == 0) return text::formatted("%-48s no case\n", figure.what.c_str());
  const auto [low, high] = wilson(figure.right, figure.of);
  return text::formatted("%-48s %4zu of %-4zu %5.1f %%  %5.1f to %5.1f %%  %-14s %s\n", figure.what.c_str(),
                         figure.right, figure.of, 100 * figure.share(), 100 * low, 100 * high,
                         targetText(figure.at_least, figure.at_most).c_str(), figure.reached() ? "" : "MISSED");
}

std::string lineOf(const SpreadFigure& figure) {
  if (figure.values.empty()) return text::formatted("%-48s no case\n", figure.what.c_str());
  std::string target = text::formatted("at most %g", figure.median_at_most);
  if (!std::isnan(figure.upper_at_most)) target += text::formatted(" / %g", figure.upper_at_most);
  return text::formatted("%-48s %9.3g / %-9.3g %-2s of %-5zu    %-18s %s\n", figure.what.c_str(), figure.quantile(0.5),
                         figure.quantile(figure.upper_quantile), figure.unit.c_str(), figure.values.size(),
                         target.c_str(), figure.reached() ? "" : "MISSED");
}

std::string headingOf(CaseClass kind) {
  switch (kind) {
    case CaseClass::kSingle:
      return "one effect hidden";
    case CaseClass::kEffectFree:
      return "nothing hidden";
    case CaseClass::kDouble:
      return "two effects hidden";
    case CaseClass::kOutside:
      return "an effect outside the catalogue hidden";
  }
  return "";
}

std::string listOf(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

json orNull(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}

json jsonOf(const ShareFigure& figure) {
  const auto [low, high] = wilson(figure.right, figure.of);
  return {{"figure", figure.what},
          {"right", figure.right},
          {"of", figure.of},
          {"share", orNull(figure.of == 0 ? std::nan("") : figure.share())},
          {"low", low},
          {"high", high},
          {"at_least", orNull(figure.at_least)},
          {"at_most", orNull(figure.at_most)},
          {"reached", figure.reached()}};
}

}  // namespace

std::string asText(const Score& score) {
  const auto [low, high] = wilson(score.fair.right, score.fair.of);
  std::string text = text::formatted("%zu cases, %zu fair answers: %.1f to %.1f %%. ", score.cases, score.fair.right,
                                     100 * low, 100 * high);
  text += "Shares with their 95 %\nconfidence interval\n\n";
  for (const ShareFigure& figure : score.shares) text += lineOf(figure);
  if (!score.details.empty()) text += "\nin detail\n\n";
  for (const ShareFigure& figure : score.details) text += lineOf(figure);
  text += "\nmedian / 90 % of the cases (time: / worst)\n\n";
  for (const SpreadFigure& figure : score.spreads) text += lineOf(figure);
  for (std::size_t i = 0; i < score.confusions.size(); ++i) {
    const Confusion& confusion = score.confusions[i];
    if (i == 0 || score.confusions[i - 1].kind != confusion.kind)
      text += "\n" + headingOf(confusion.kind) + ", and the answers that are wrong\n\n";
    text += text::formatted("%4zu  ", confusion.cases.size()) + confusion.truth + " -> " + confusion.answered + "  (" +
            listOf(confusion.cases) + ")\n";
  }
  if (!score.unanswered.empty()) text += "\nno answer in time: " + listOf(score.unanswered) + "\n";
  if (!score.without_key.empty()) text += "\nnot in the key: " + listOf(score.without_key) + "\n";
  return text;
}

json asJson(const Score& score) {
  json shares = json::array(), details = json::array(), spreads = json::array(), confusions = json::array();
  for (const ShareFigure& figure : score.shares) shares.push_back(jsonOf(figure));
  for (const ShareFigure& figure : score.details) details.push_back(jsonOf(figure));
  for (const SpreadFigure& figure : score.spreads)
    spreads.push_back({{"figure", figure.what},
                       {"unit", figure.unit},
                       {"count", figure.values.size()},
                       {"median", orNull(figure.quantile(0.5))},
                       {"upper_quantile", figure.upper_quantile},
                       {"upper", orNull(figure.quantile(figure.upper_quantile))},
                       {"median_at_most", orNull(figure.median_at_most)},
                       {"upper_at_most", orNull(figure.upper_at_most)},
                       {"reached", figure.reached()}});
  for (const Confusion& confusion : score.confusions)
    confusions.push_back({{"hidden", confusion.truth}, {"answered", confusion.answered}, {"cases", confusion.cases}});
  return {{"cases", score.cases},
          {"fair", jsonOf(score.fair)},
          {"shares", shares},
          {"details", details},
          {"spreads", spreads},
          {"confusions", confusions},
          {"unanswered", score.unanswered},
          {"without_key", score.without_key}};
}

}  // namespace darwinop::gap
