// The page, from the verdict down to the commands.
#include "gap/report/page_sections.hpp"

#include <algorithm>
#include <cmath>

#include "core/text/joined.hpp"
#include "core/text/number_text.hpp"
#include "gap/case/bad_rows.hpp"
#include "gap/case/contradictions.hpp"
#include "gap/case/messages.hpp"
#include "gap/report/data_hash.hpp"
#include "gap/report/html.hpp"
#include "gap/report/line_diff.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/sentences.hpp"

namespace darwinop::gap {
namespace {

using html::element;
using html::wrap;

std::string floors(double value) {
  return text::fixedText(value, value < 9.95 ? 1 : 0);
}

double rounded2(double value) {
  return std::round(value * 100) / 100;
}

std::string section(std::string_view id, std::string_view title, const std::string& inside) {
  return wrap("section", wrap("h2", html::text(title)) + inside, " id=\"" + std::string{id} + "\"") + "\n";
}

/// A bar as long as its share of the longest.
std::string bar(std::string_view kind, const std::string& label, double rad, double longest) {
  const std::string width = " class=\"bar " + std::string{kind} +
                            "\" style=\"width:" + text::fixedText(std::max(0.4, 100 * rad / longest), 1) + "%\"";
  return wrap("div", element("dt", label) +
                         wrap("dd", html::number(mradOf(rad), inMrad(rad)) + " mrad" + wrap("span", "", width)));
}

std::string gapCells(const Gap& gap, bool below_floor) {
  const auto cell = [](const std::string& inside, std::string_view attributes = "") {
    return wrap("td", inside, attributes);
  };
  std::string after_floors = html::number(rounded2(gap.floorsAfter()), floors(gap.floorsAfter()));
  if (below_floor) after_floors += std::string{" <strong class=\"flag\">"} + messages::kBelowFloorFlag + "</strong>";
  return cell(html::number(mradOf(gap.before_rad), inMrad(gap.before_rad))) +
         cell(html::number(mradOf(gap.after_rad), inMrad(gap.after_rad))) +
         cell(html::number(mradOf(gap.floor_rad), inMrad(gap.floor_rad))) +
         cell(html::number(rounded2(gap.floorsBefore()), floors(gap.floorsBefore()))) + cell(after_floors);
}

std::string titleRow(std::size_t count, const char* role, const Gap& gap) {
  if (count == 0) return "";
  return "<tr class=\"all\"><th scope=\"row\">" + std::to_string(count) + (count == 1 ? " log" : " logs") +
         "</th><td>" + role + "</td>" + gapCells(gap, false) + "</tr>\n";
}

std::string maskedText(const Case& given) {
  std::string items;
  for (const Trajectory& log : given.logs)
    for (const MaskedReadings& masked : log.masked) items += element("li", asSentence(log, masked)) + "\n";
  return items.empty() ? "" : element("p", messages::kMaskedReadings) + wrap("ul", items);
}

}  // namespace

std::string verdictSection(const Report& report) {
  std::string inside = element("p", "darwinop gap, case " + report.given->name);
  std::string sentences;
  if (report.outcome == nullptr) {
    inside += wrap("h1", "two models compared");
    sentences = helpSentence(report.comparison);
  } else {
    std::string name{nameOf(report.outcome->identification.verdict)};
    std::ranges::replace(name, '_', ' ');
    inside +=
        wrap("h1", html::text(name), " class=\"" + std::string{nameOf(report.outcome->identification.verdict)} + "\"");
    sentences = text::joined(verdictSentences(*report.outcome, report.comparison), " ");
  }
  for (const Contradiction& found : contradictionsOf(*report.given)) sentences += " " + asSentence(found) + ".";
  return wrap("header", inside + wrap("p", html::text(sentences), " id=\"verdict\"")) + "\n";
}

std::string headlineSection(const Report& report) {
  const Comparison& all = report.comparison;
  if (all.held_out_logs == 0)
    return section(
        "headline", "Before and after",
        element("p", std::string{messages::kNoHeldOutLog} +
                         " Mark one or two with \"role\": \"held_out\" in case.json: errors on logs that were "
                         "fitted prove nothing."));
  const Gap& gap = all.held_out;
  const double longest = std::max({gap.before_rad, gap.after_rad, gap.floor_rad});
  std::string inside =
      wrap("dl", bar("before", "before", gap.before_rad, longest) + bar("after", "after", gap.after_rad, longest) +
                     bar("floor", "noise alone", gap.floor_rad, longest));
  inside += element("p", "Position error of the closed loop, root of the mean square, on the " +
                             std::to_string(all.held_out_logs) + (all.held_out_logs == 1 ? " log" : " logs") +
                             " that no fit has used (held out). Noise alone is what a right model would show.");
  if (report.outcome != nullptr) inside += element("p", std::string{messages::kHeldOutUse} + " " + messages::kOtherUse);
  if (all.anyBelowFloor()) inside += wrap("p", html::text(messages::kBelowFloor), " class=\"flag\"");
  return section("headline", "Before and after", inside);
}

std::string logsSection(const Report& report) {
  const Comparison& all = report.comparison;
  std::string rows;
  for (const bool held_out : {true, false}) {
    rows +=
        held_out ? titleRow(all.held_out_logs, "held out", all.held_out) : titleRow(all.fit_logs, "fitted", all.fit);
    for (const LogComparison& one : all.logs) {
      const Trajectory& log = report.given->logs[one.log];
      if (log.held_out != held_out) continue;
      rows += "<tr><th scope=\"row\"><a href=\"#curves\" data-log=\"" + std::to_string(one.log) + "\">" +
              html::text(log.file) + "</a> " + wrap("small", html::text(log.kind)) + "</th><td>" +
              (held_out ? "held out" : "fitted") + "</td>" + gapCells(one.gap, one.below_floor) + "</tr>\n";
    }
  }
  rows += titleRow(all.other_logs, "other", all.others);
  std::string inside =
      "<div class=\"wide\"><table id=\"logs\"><thead><tr><th>log</th><th>role</th><th>before, mrad</th>"
      "<th>after, mrad</th><th>noise, mrad</th><th>before, floors</th><th>after, floors</th></tr>"
      "</thead><tbody>\n" +
      rows + "</tbody></table></div>";
  inside +=
      element("p",
              "A floor is the error that noise alone causes on that motion. About 1 is as good as a model can be; 3 "
              "and more is a gap. Only held-out logs show whether a model is better.");
  if (all.anyBelowFloor()) inside += wrap("p", html::text(messages::kBelowFloor), " class=\"flag\"");
  return section("log-by-log", "Log by log", inside + maskedText(*report.given));
}

std::string modelSection(const std::string& model_before, const std::string& model_after) {
  std::string lines;
  for (const DiffLine& line : lineDiff(model_before, model_after)) {
    const std::string text = html::text(line.text);
    if (line.kind == '+')
      lines += "<ins>+ " + text + "</ins>\n";
    else if (line.kind == '-')
      lines += "<del>- " + text + "</del>\n";
    else
      lines += line.kind == '@' ? "<span class=\"cut\">  …</span>\n" : "  " + text + "\n";
  }
  const std::string inside = lines.empty()
                                 ? element("p", "Nothing: both model files are the same.")
                                 : wrap("pre", lines, " tabindex=\"0\" aria-label=\"Changes of the model file\"");
  return section("model", "What changes in the model file", inside);
}

std::string againSection(const Report& report) {
  std::string inside;
  if (!report.commands.empty())
    inside += wrap("pre", html::text(text::joined(report.commands, "\n")), " tabindex=\"0\" aria-label=\"Commands\"");
  if (!report.data_hash.empty())
    inside += wrap("p", "sha256 of the data: " + wrap("code", report.data_hash, " id=\"hash\"")) +
              wrap("p", "The same number, made in the folder of the case:") +
              wrap("pre", html::text(hashCommand(*report.given)), " tabindex=\"0\" aria-label=\"Command of the hash\"");
  return inside.empty() ? "" : section("again", "Make it again", inside);
}

}  // namespace darwinop::gap
