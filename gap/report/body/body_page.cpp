// The page of a whole robot, from the verdict down to the commands.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/text/formatted.hpp"
#include "core/text/joined.hpp"
#include "gap/report/body/body_report.hpp"
#include "gap/report/body/place_marks.hpp"
#include "gap/report/html.hpp"
#include "gap/report/messages.hpp"
#include "gap/report/page_parts.hpp"
#include "gap/report/page_sections.hpp"

namespace darwinop::gap {
namespace {

using html::element;
using html::wrap;
using Json = nlohmann::ordered_json;

// Beside the style of the other report.
constexpr std::string_view kStyle =
    "table.robot td.open{background:var(--gone)}table.robot td.closed{background:var(--added)}"
    "table.robot td.none{color:var(--faint)}table.robot td{text-align:center}"
    "figure{margin:0;print-color-adjust:exact;-webkit-print-color-adjust:exact}svg{max-width:100%}"
    "svg path{stroke:var(--ink)}svg text{font-size:15px;dominant-baseline:middle}"
    "svg polygon,svg circle,svg rect{stroke:var(--ink);stroke-width:.7}"
    "figcaption span{display:inline-block;padding:0 .5em;margin-right:.5em;border:1px solid var(--line)}"
    "figure .untested{fill:#fff;stroke-dasharray:3 3;border-style:dashed}"
    "figure .agrees{fill:#b9dfc2;background:#b9dfc2}figure .diverges{fill:#e0603f;background:#e0603f}"
    "figure .possible{fill:#9ccbeb;background:#9ccbeb}figure .named{fill:#0072b2;background:#0072b2;color:#fff}";

std::string section(std::string_view id, std::string_view title, const std::string& inside) {
  return wrap("section", wrap("h2", html::text(title)) + inside, " id=\"" + std::string{id} + "\"") + "\n";
}

std::string sentenceOf(const BodyReport& report) {
  const std::string end = report.answer["remainder"].is_null() ? "." : messages::kRemainder;
  switch (report.found->verdict) {
    case Verdict::kNamed:
      return "These effects are missing from the model" + end;
    case Verdict::kAmbiguous:
      return "Something is missing from the model, and these recordings do not decide between some names" + end;
    case Verdict::kUnknown:
      return "Signals diverge, and no effect of the catalogue explains them. The table below has the places.";
    case Verdict::kNone:
      return messages::kAgreement;
    default:
      return messages::kNotAllTested;
  }
}

/// "0.1252", "0.05 0 -0.02".
std::string valuesText(const Json& value) {
  if (value.is_number()) return text::formatted("%.4g", value.get<double>());
  std::string out;
  for (const Json& one : value) out += (out.empty() ? "" : " ") + valuesText(one);
  return out;
}

std::string placeText(const Json& at) {
  if (at.is_string()) return at == "all" ? "all joints" : at.get<std::string>();
  std::string out;
  for (const Json& one : at) out += (out.empty() ? "" : " and ") + one.get<std::string>();
  return out;
}

std::string intervalText(const Json& effect, const std::string& key) {
  const Json intervals = effect.value("interval_90", Json::object());
  if (!intervals.contains(key)) return "";
  const Json& ends = intervals[key];
  if (ends.size() == 2 && ends[0].is_number()) return valuesText(ends[0]) + " to " + valuesText(ends[1]);
  std::string out;
  for (const Json& one : ends)
    out += (out.empty() ? "" : "; ") + valuesText(one.at(0)) + " to " + valuesText(one.at(1));
  return out;
}

/// "link_com at Body: shift 0 0.02 0"
std::string candidateText(const Json& effect) {
  std::string text = effect["id"].get<std::string>() + " at " + placeText(effect["at"]), numbers;
  for (const auto& [key, value] : effect["params"].items())
    numbers += (numbers.empty() ? ": " : ", ") + key + " " + valuesText(value);
  return text + numbers;
}

/// What is left, and what was tried on it.
std::string remainderText(const BodyReport& report) {
  std::vector<std::string> candidates;
  for (const Json& effect : report.answer["candidates"]) candidates.push_back(candidateText(effect));
  std::vector<std::string> open;
  for (const OpenSignal& one : openSignals(report)) open.push_back(one.signal + " (" + one.block + ")");
  const std::string left = text::joined(open, ", ");
  return (left.empty() ? "" : element("p", messages::kOpenSignals + left + ".")) +
         (candidates.empty() ? "" : element("p", messages::kTried + text::joined(candidates, "; ") + "."));
}

std::string namesSection(const BodyReport& report) {
  std::string rows;
  for (const Json& effect : report.answer["effects"]) {
    std::string numbers, intervals;
    for (const auto& [key, value] : effect["params"].items()) {
      numbers += (numbers.empty() ? "" : ", ") + key + " " + valuesText(value);
      if (const std::string one = intervalText(effect, key); !one.empty())
        intervals += (intervals.empty() ? "" : ", ") + one;
    }
    rows += wrap("tr", element("td", effect["id"].get<std::string>()) + element("td", placeText(effect["at"])) +
                           element("td", numbers) + element("td", intervals)) +
            "\n";
  }
  const std::string left = remainderText(report);
  if (rows.empty()) return left.empty() ? "" : section("what", "What is not explained", left);
  std::string inside =
      wrap("table", "<tr><th>effect</th><th>place</th><th>numbers, SI units</th><th>90 %</th></tr>\n" + rows);
  for (const Json& group : report.answer["ambiguity"]) {
    std::string names;
    for (const Json& one : group)
      names += (names.empty() ? "" : ", ") + one["id"].get<std::string>() + " at " + placeText(one["at"]);
    inside += element("p", "Not separated by these recordings: " + names + "; " + kSeparatedByPlan);
  }
  for (const std::string& sentence : report.left_out) inside += element("p", "Not in the changed model: " + sentence);
  return section("what", "What is missing", inside + left);
}

/// The groups of signals on recordings that no fit has seen.
std::string heldOutSection(const BodyReport& report) {
  struct Group {
    const char *key, *name;
  };
  constexpr std::array<Group, 3> kGroups{{{"joints_mrad", "positions of the joints, mrad"},
                                          {"gyro_rad_s", "gyroscope, rad/s"},
                                          {"accel_m_s2", "accelerometer, m/s2"}}};
  std::string rows;
  for (const Group& group : kGroups) {
    const auto cell = [&](const char* table) {
      const Json value = report.answer[table].value(group.key, Json(nullptr));
      return wrap("td", value.is_number() ? html::number(value, text::formatted("%.3g", value.get<double>())) : "–");
    };
    rows += wrap("tr", element("th", group.name) + cell("gap_score_before") + cell("gap_score_after") + cell("floor")) +
            "\n";
  }
  const std::string table =
      wrap("table", "<tr><th>rms, held out</th><th>before</th><th>after</th><th>noise</th></tr>\n" + rows);
  return section("held-out", "Before and after, on held-out recordings", table + element("p", messages::kHeldOutUse));
}

std::string cellOf(const BodyRow* row) {
  if (row == nullptr) return wrap("td", "–", " class=\"none\"");
  const std::string sigmas = html::number(row->significance, text::formatted("%.1f", row->significance));
  return wrap("td", sigmas, row->open ? " class=\"open\"" : " class=\"closed\"");
}

const BodyRow* rowOf(const std::vector<BodyRow>& rows, std::string_view place, Block block) {
  const auto found =
      std::ranges::find_if(rows, [&](const BodyRow& row) { return row.place.name == place && row.block == block; });
  return found == rows.end() ? nullptr : &*found;
}

/// A line for each signal on the floor, which includes the trunk; empty: no such recording.
std::string floorTable(const BodyIdentification& found) {
  std::string rows;
  for (const BodyRow& row : found.table.rows) {
    if (row.place.kind != Place::Kind::kContact) continue;
    const auto after = std::ranges::find(found.floor.rows_after, row.signal, &BodyRow::signal);
    rows += wrap("tr", element("th", row.signal) + cellOf(&row) +
                           cellOf(after == found.floor.rows_after.end() ? nullptr : &*after)) +
            "\n";
  }
  if (rows.empty()) return "";
  return wrap("table", "<tr><th>signal, on the floor</th><th>before</th><th>with the effects</th></tr>\n" + rows,
              " class=\"robot\"");
}

/// The robot in colours, and what they mean.
std::string pictureOf(const BodyReport& report) {
  struct Colour {
    PlaceState state;
    const char* meaning;
  };
  constexpr std::array<Colour, 5> kColours{{{PlaceState::kNamed, "an effect is named there"},
                                            {PlaceState::kPossible, "one of several that are possible"},
                                            {PlaceState::kDiverges, "diverges, not explained"},
                                            {PlaceState::kAgrees, "agrees, with what is named"},
                                            {PlaceState::kUntested, "not tested"}}};
  const std::string picture = robotPicture(report.given->joints.model, marksOf(report));
  if (picture.empty()) return "";
  std::string legend;
  for (const Colour& colour : kColours)
    legend += wrap("span", html::text(colour.meaning), " class=\"" + std::string{nameOf(colour.state)} + "\"") + " ";
  return wrap("figure", picture + "\n" + wrap("figcaption", legend)) + "\n";
}

/// A line for each joint, coloured: red diverges, green agrees.
std::string robotSection(const BodyReport& report) {
  std::string rows;
  const BodyIdentification& found = *report.found;
  for (const JointRow& joint : kJointTable)
    rows += wrap("tr", element("th", std::string{joint.name}) +
                           cellOf(rowOf(found.table.rows, joint.name, Block::kController)) +
                           cellOf(rowOf(found.table.rows, joint.name, Block::kSupply)) +
                           cellOf(rowOf(found.table.rows, joint.name, Block::kPlant)) +
                           cellOf(rowOf(found.mechanics.rows, joint.name, Block::kPlant))) +
            "\n";
  std::string sensors;
  for (const BodyRow& row : found.table.rows)
    if (row.block == Block::kSensor) sensors += wrap("tr", element("th", row.signal) + cellOf(&row)) + "\n";
  const std::string head =
      "<tr><th>joint</th><th>controller</th><th>supply</th><th>position</th><th>position, with the effects</th></tr>\n";
  std::string inside =
      pictureOf(report) +
      element("p", text::formatted("Standard deviations; red diverges, beyond %.1f, which chance exceeds in 1 %% of "
                                   "robots that are like their model.",
                                   found.table.open_from)) +
      wrap("table", head + rows, " class=\"robot\"") +
      wrap("table", "<tr><th>sensor, at rest</th><th>mean</th></tr>\n" + sensors, " class=\"robot\"") +
      floorTable(found);
  std::string untested;
  for (const std::string& sentence : found.table.not_tested) untested += element("li", sentence) + "\n";
  if (!untested.empty()) inside += element("p", "Not tested:") + wrap("ul", untested);
  return section("where", "Where the robot and the model diverge", inside);
}

}  // namespace

std::string asHtml(const BodyReport& report) {
  const std::string verdict{nameOf(report.found->verdict)};
  std::string body = wrap("header", element("p", "darwinop gap, whole robot, case " + report.given->name) +
                                        wrap("h1", html::text(verdict), " class=\"" + verdict + "\"") +
                                        wrap("p", html::text(sentenceOf(report)), " id=\"verdict\""));
  body += "\n" + namesSection(report) + heldOutSection(report) + robotSection(report) +
          modelSection(report.model_before, report.model_after);
  if (!report.commands.empty())
    body += section(
        "again", "Make it again",
        wrap("pre", html::text(text::joined(report.commands, "\n")), " tabindex=\"0\" aria-label=\"Commands\""));
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n" +
         element("title", "darwinop gap: " + report.given->name) + "\n<style>\n" + std::string{page_parts::kStyle} +
         std::string{kStyle} + "\n</style>\n</head>\n<body>\n<main>\n" + body + "</main>\n</body>\n</html>\n";
}

}  // namespace darwinop::gap
