// The page: the figures of report.json, well formed, self-contained, with the texts of logs escaped.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "gap/report/html.hpp"
#include "gap/report/report_rig.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// The part of the page between a tag that contains `mark` and `end`.
std::string partOf(const std::string& page, const std::string& mark, const std::string& end) {
  const std::size_t begin = page.find('>', page.find(mark)) + 1;
  return page.substr(begin, page.find(end, begin) - begin);
}

/// The machine-readable figures: the value of every <data>.
std::vector<double> numbersIn(const std::string& html) {
  std::vector<double> values;
  const std::regex number{"<data value=\"([^\"]+)\">"};
  for (std::sregex_iterator it{html.begin(), html.end(), number}, end; it != end; ++it)
    values.push_back(std::stod((*it)[1]));
  return values;
}

std::vector<double> numbersOf(const json& gap) {
  std::vector<double> values;
  for (const char* key : {"before_mrad", "after_mrad", "floor_mrad", "before_floors", "after_floors"})
    values.push_back(gap[key]);
  return values;
}

/// Every tag that opens closes, in order, outside scripts and styles. Empty: it does.
std::string misplacedTag(std::string page) {
  page = std::regex_replace(page, std::regex{"<!DOCTYPE html>"}, "");
  for (const std::string tag : {"script", "style"})  // their content is not HTML, and too long for <regex>
    for (std::size_t at = page.find("<" + tag); at != std::string::npos; at = page.find("<" + tag, at + 1)) {
      const std::size_t begin = page.find('>', at) + 1;
      page.erase(begin, page.find("</" + tag, begin) - begin);
    }
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at)) {
    const std::size_t end = page.find('>', at);
    const std::string inside = page.substr(at + 1, end - at - 1);
    const bool closes = inside.starts_with('/');
    const std::string name = inside.substr(closes ? 1 : 0, inside.find_first_of(" \n", 1) - (closes ? 1 : 0));
    at = end;
    if (name == "meta" || name == "link" || name == "br") continue;
    if (!closes)
      open.push_back(name);
    else if (open.empty() || open.back() != name)
      return inside;
    else
      open.pop_back();
  }
  return open.empty() ? "" : open.back();
}

TEST(GapPage, HasTheFiguresOfTheJson) {
  const ReportRig rig;
  const std::string page = asHtml(rig.report);
  const json all = asJson(rig.report);
  std::vector<double> wanted = numbersOf(all["held_out"]);
  for (const auto& part : {all["logs"][1], all["fit"], all["logs"][0]})
    for (const double value : numbersOf(part)) wanted.push_back(value);
  EXPECT_EQ(numbersIn(partOf(page, "id=\"logs\"", "</table>")), wanted);
  EXPECT_THAT(numbersIn(partOf(page, "id=\"headline\"", "</section>")), testing::ElementsAre(31.041, 0.931, 0.888));
  const std::vector<double> what = numbersIn(partOf(page, "id=\"what\"", "</section>"));
  const json& effect = all["effects"][0];
  for (const json& value :
       {effect["params"]["friction"], effect["interval_90"]["friction"][0], effect["interval_90"]["friction"][1],
        effect["gain"], all["rivals"][0]["behind"], all["rivals"][1]["behind"], all["prior_conflicts"][0]["factor"],
        all["prior_conflicts"][0]["sigma"], all["bench"]["payload_factor"], all["threshold"]})
    EXPECT_THAT(what, testing::Contains(value.get<double>())) << value;
  for (const json& sentence : all["sentences"]) EXPECT_THAT(page, HasSubstr(sentence.get<std::string>()));
}

TEST(GapPage, IsWellFormed) {
  ReportRig rig;
  EXPECT_EQ(misplacedTag(asHtml(rig.report)), "");
  rig.outcome.identification.verdict = Verdict::kAmbiguous;
  rig.report.comparison.logs[1].below_floor = true;
  rig.make();
  EXPECT_EQ(misplacedTag(asHtml(rig.report)), "");
  rig.report.outcome = nullptr;  // two models, no search
  EXPECT_EQ(misplacedTag(asHtml(rig.report)), "");
}

TEST(GapPage, EscapesTheTextsOfLogs) {
  const ReportRig rig;
  const std::string page = asHtml(rig.report);
  EXPECT_THAT(page, Not(HasSubstr("fit</script>")));
  EXPECT_THAT(page, Not(HasSubstr("<!--&")));
  EXPECT_THAT(page, HasSubstr("fit&lt;/script&gt;&lt;!--&amp;&quot;1&quot;.csv"));
  EXPECT_THAT(page, HasSubstr("<title>darwinop gap: e&lt;1&gt;</title>"));
  const json curves = json::parse(partOf(page, "id=\"data\"", "</script>"));
  EXPECT_EQ(curves["logs"][0]["file"], rig.given.logs[0].file) << "and the curves have the exact name";
}

TEST(GapPage, SurvivesNamesThatAreNotUtf8) {
  ReportRig rig;
  rig.given.logs[0].file = "fit\xff\xfe.csv";
  rig.outcome = dryFriction(rig.given);
  rig.make();
  EXPECT_EQ(misplacedTag(asHtml(rig.report)), "");
}

TEST(GapPage, DrawsEverySampleAndShowsUnknownOnesAsGaps) {
  ReportRig rig;
  rig.given.logs[0].position_rad[3] = std::numeric_limits<double>::quiet_NaN();
  rig.given.logs[0].position_rad[4] = -0.12345;
  const json curves = json::parse(partOf(asHtml(rig.report), "id=\"data\"", "</script>"));
  const json& log = curves["logs"][0];
  EXPECT_TRUE(log["measured"][3].is_null());
  EXPECT_NEAR(log["measured"][4].get<double>() * curves["angle_unit_rad"].get<double>(), -0.12345, 1e-9);
  EXPECT_EQ(log["after"].size(), rig.given.logs[0].rows());
  EXPECT_FALSE(log["held_out"]);
  EXPECT_TRUE(curves["logs"][1]["held_out"]);
}

TEST(GapPage, LoadsNothingFromOutside) {
  const ReportRig rig;
  const std::string page = asHtml(rig.report);
  for (const char* fetch : {"<link rel=\"stylesheet", " src=", "@import", "sourceMappingURL", "url("})
    EXPECT_THAT(page, Not(HasSubstr(fetch))) << fetch;
  const std::regex address{"https?://[^\\s\"'<>)]+"};
  for (std::sregex_iterator it{page.begin(), page.end(), address}, end; it != end; ++it)
    EXPECT_THAT(it->str(),
                testing::AnyOf(HasSubstr("github.com/danvk/dygraphs"), HasSubstr("opensource.org/licenses/MIT")))
        << "only licence notes in comments of the library name an address";
  EXPECT_THAT(page, HasSubstr("default-src 'none'")) << "and the browser must not fetch anything";
}

TEST(GapPage, IsTheSameEachTime) {
  const ReportRig one, other;
  EXPECT_EQ(asHtml(one.report), asHtml(other.report));
  ReportRig slow;
  slow.outcome.runtime_s = 99;
  EXPECT_EQ(asHtml(one.report), asHtml(slow.report)) << "however long it took";
  EXPECT_EQ(asJson(one.report).dump(), asJson(slow.report).dump());
}

TEST(GapPage, LinksAPlaceToItsCurve) {
  const ReportRig rig;
  EXPECT_THAT(asHtml(rig.report),
              HasSubstr("<a href=\"#curves\" data-log=\"0\" data-from=\"0.300\" data-to=\"0.600\">"));
}

TEST(GapPage, FlagsWhatIsTooGoodToBeTrue) {
  ReportRig rig;
  EXPECT_THAT(asHtml(rig.report), Not(HasSubstr(messages::kBelowFloor)));
  rig.report.comparison.logs[1].below_floor = true;
  const std::string page = asHtml(rig.report);
  EXPECT_THAT(partOf(page, "id=\"headline\"", "</section>"), HasSubstr(messages::kBelowFloor));
  EXPECT_THAT(partOf(page, "id=\"logs\"", "</table>"), HasSubstr(messages::kBelowFloorFlag));
  EXPECT_TRUE(asJson(rig.report)["logs"][1]["below_floor"]);
}

TEST(GapPage, HasNoHeadlineWithoutHeldOutLogs) {
  ReportRig rig;
  rig.given.logs[1].held_out = false;
  rig.make();
  const std::string page = asHtml(rig.report);
  EXPECT_THAT(partOf(page, "id=\"headline\"", "</section>"), HasSubstr(messages::kNoHeldOutLog));
  EXPECT_TRUE(numbersIn(partOf(page, "id=\"headline\"", "</section>")).empty());
  EXPECT_TRUE(asJson(rig.report)["held_out"]["after_mrad"].is_null()) << "not known is not 0";
}

TEST(GapPage, SaysWhatHeldOutLogsDecide) {
  ReportRig rig;
  for (const char* const sentence : {messages::kHeldOutUse, messages::kOtherUse})
    EXPECT_THAT(partOf(asHtml(rig.report), "id=\"headline\"", "</section>"), HasSubstr(html::text(sentence)));
  rig.report.outcome = nullptr;
  EXPECT_THAT(asHtml(rig.report), Not(HasSubstr(messages::kHeldOutUse))) << "no name was chosen";
}

TEST(GapPage, ShowsTheModelsChangesAndHowToMakeItAgain) {
  const ReportRig rig;
  const std::string page = asHtml(rig.report);
  const std::string model = partOf(page, "id=\"model\"", "</section>");
  EXPECT_THAT(model, HasSubstr("<ins>+ [effect coulomb]</ins>"));
  EXPECT_THAT(model, HasSubstr("<ins>+ friction = 0.0423 N m</ins>"));
  EXPECT_THAT(model, HasSubstr("<del>- kt = 1.786 N m/A</del>"));
  EXPECT_THAT(model, Not(HasSubstr("duty_max")));
  EXPECT_THAT(page, HasSubstr("darwinop gap run 'cases/e&lt;1&gt;'"));
  EXPECT_THAT(page, HasSubstr(rig.report.data_hash));
}

}  // namespace
}  // namespace darwinop::gap
