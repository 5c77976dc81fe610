// What is missing and where it shows: the parts of the page that need a search.
#include <cmath>

#include "core/text/joined.hpp"
#include "core/text/number_text.hpp"
#include "gap/report/html.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/model_text.hpp"
#include "gap/report/page_sections.hpp"
#include "gap/report/rival_text.hpp"
#include "gap/report/sentences.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using html::element;
using html::wrap;

std::string estimateRow(const Estimate& estimate) {
  const bool known = estimate.seen && std::isfinite(estimate.low) && std::isfinite(estimate.high);
  return "<tr><th scope=\"row\">" + html::text(estimate.name) + "</th><td>" +
         html::number(estimate.value, withUnit(estimate.value, estimate.unit)) + "</td><td>" +
         (known ? html::number(estimate.low, withUnit(estimate.low, "")) + " to " +
                      html::number(estimate.high, withUnit(estimate.high, estimate.unit))
                : std::string{messages::kNotIdentifiable}) +
         "</td></tr>\n";
}

std::string foundText(const IdentifiedEffect& found) {
  std::string rows;
  for (const Estimate& estimate : found.estimates) rows += estimateRow(estimate);
  const std::string title{found.effect->title};
  return wrap("article",
              wrap("h3", html::text(title) + " " + wrap("code", html::text(found.effect->id))) +
                  wrap("p", wrap("code", html::text(found.effect->equation))) + element("p", found.effect->signature) +
                  "<div class=\"wide\"><table><thead><tr><th>parameter</th><th>value</th><th>90 % interval</th></tr>"
                  "</thead><tbody>\n" +
                  rows + "</tbody></table></div>" +
                  wrap("p", "Without it the fit is worse by " +
                                html::number(found.gain, text::fixedText(found.gain, 0)) + ".")) +
         "\n";
}

std::string behindText(const Rival& rival, const Identification& identification) {
  if (identification.isSelectedByPrediction()) return predictionOf(rival, identification);
  return "the fit is worse by " + html::number(rival.behind, text::fixedText(rival.behind, 0)) +
         (rival.isClose() ? ", <strong>too little to decide</strong>" : "");
}

std::string rivalsText(const Identification& identification) {
  if (identification.rivals.empty()) return "";
  std::string items;
  for (const Rival& rival : identification.rivals)
    items += wrap("li", wrap("code", html::text(text::joined(rival.effects, " + "))) +
                            " instead: " + behindText(rival, identification)) +
             "\n";
  if (identification.isSelectedByPrediction()) return "<h3>Rivals</h3>" + wrap("ul", items);
  std::string chance;
  if (std::isfinite(identification.threshold))
    chance = "A gain of " + html::number(identification.threshold, text::fixedText(identification.threshold, 0)) +
             " is exceeded by chance in " + chanceShare(identification) + " of cases. ";
  return "<h3>Rivals</h3>" + wrap("ul", items) +
         wrap("p", chance + "Rivals less than " + text::fixedText(thresholds::kRivalEvidence, 0) +
                       " behind are not excluded by the data; less than " +
                       text::fixedText(thresholds::kLargerRivalEvidence, 0) + ", if they have more free parameters.");
}

/// How to distinguish the effects from each other.
std::string experimentText(const Identification& identification) {
  if (identification.verdict != Verdict::kAmbiguous) return "";
  std::string text;
  for (const twin::EffectInfo* const effect : undecidedEffects(identification))
    text += element("p", std::string{effect->title} + ": " + std::string{effect->separated_by});
  return text.empty() ? "" : "<h3>Experiment that would decide</h3>" + text;
}

std::string conflictsText(const Identification& identification) {
  std::string items;
  for (const PriorConflict& one : identification.prior_conflicts)
    items +=
        wrap("li", wrap("code", html::text(one.number)) + " has to be " +
                       html::number(one.factor, text::fixedText(one.factor, 3)) + " times what was given, " +
                       html::number(one.sigmas, text::fixedText(std::abs(one.sigmas), 1)) + " sigma of its prior") +
        "\n";
  if (items.empty()) return "";
  return "<h3>Prior conflicts</h3>" + wrap("ul", items) +
         element("p",
                 "Measure these again: a number that has to go so far stands for something that is not in the "
                 "model, or was noted down wrongly.");
}

/// Numbers that a model file does not contain.
std::string benchText(const Report& report) {
  const Hypothesis& model = report.outcome->identification.model;
  const double length = model.pendulum.length_m / report.given->pendulum.length_m;
  const std::string write_time = writeTimeSentence(*report.given, report.outcome->identification);
  const std::string host = write_time.empty() ? "" : element("p", write_time);
  if (model.payload_scale == 1 && length == 1) return host;
  return host + wrap("p", "The fit also moved the arm of case.json, within its priors: payload times " +
                              html::number(model.payload_scale, text::fixedText(model.payload_scale, 4)) +
                              ", length times " + html::number(length, text::fixedText(length, 4)) +
                              ". That belongs to the bench, so it is not in the model file.");
}

/// Zooms the curve there.
std::string placeLink(const Report& report, const GapInterval& place) {
  std::string file = html::text(place.file);
  for (std::size_t i = 0; i < report.given->logs.size(); ++i)
    if (report.given->logs[i].file == place.file) {
      const std::string from = "<a href=\"#curves\" data-log=\"" + std::to_string(i) + "\" data-from=\"" +
                               text::fixedText(place.t0_s, 3) + "\" data-to=\"" + text::fixedText(place.t1_s, 3) +
                               "\">";
      return from + file + ", " + text::fixedText(place.t0_s, 2) + " to " + text::fixedText(place.t1_s, 2) + " s</a>";
    }
  return file;
}

std::string placeRow(const Report& report, const GapInterval& place) {
  return "<tr><td>" + placeLink(report, place) + "</td>" + element("td", place.happens) + element("td", place.signal) +
         "<td>" + html::number(place.size, text::generalText(place.size, 3)) + " " + html::text(place.unit) + "</td>" +
         element("td", place.block ? std::string{name(*place.block)} : "-") + "</tr>\n";
}

std::string sectionOf(std::string_view id, const std::string& title, const std::string& inside) {
  return wrap("section", element("h2", title) + inside, " id=\"" + std::string{id} + "\"") + "\n";
}

}  // namespace

std::string whatSection(const Report& report) {
  if (report.outcome == nullptr) return "";
  const Identification& identification = report.outcome->identification;
  std::string inside;
  if (identification.effects.empty()) inside += element("p", "No effect was named.");
  if (identification.verdict == Verdict::kUnknown && !identification.effects.empty())
    inside += element("p", "These effects improve the fit but do not explain the gap, so none of them is named.");
  for (const IdentifiedEffect& found : identification.effects) inside += foundText(found);
  if (!report.outcome->remainder.empty())
    inside += "<h3>Unexplained remainder</h3>" + element("p", report.outcome->remainder);
  for (const std::string& sentence : {intervalSentence(identification), triedSentence(identification)})
    if (!sentence.empty()) inside += element("p", sentence);
  for (const RejectedEffect& rejected : identification.rejected) inside += element("p", rejectionSentence(rejected));
  inside +=
      rivalsText(identification) + experimentText(identification) + conflictsText(identification) + benchText(report);
  return sectionOf("what", identification.verdict == Verdict::kUnknown ? "What helps" : "What is missing", inside);
}

std::string whereSection(const Report& report) {
  if (report.outcome == nullptr) return "";
  const Localization& where = report.outcome->localization;
  std::string inside;
  if (where.blocks.first)
    inside += wrap("p", "First block of the loop whose residual is significant: " +
                            wrap("strong", html::text(name(*where.blocks.first))) + ".");
  if (where.places.empty()) {
    inside += element("p", "Nowhere do the logs of the fit differ from the model by more than noise.");
  } else {
    std::string rows;
    for (const GapInterval& place : where.places) rows += placeRow(report, place);
    inside +=
        "<div class=\"wide\"><table id=\"places\"><thead><tr><th>place, strongest first</th><th>what happens "
        "there</th><th>signal</th><th>size</th><th>part of the loop</th></tr></thead><tbody>\n" +
        rows + "</tbody></table></div>";
  }
  return sectionOf("where", "Where it is", inside);
}

}  // namespace darwinop::gap
