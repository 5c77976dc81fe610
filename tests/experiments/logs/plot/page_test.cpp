// The page: it carries the data, asks for nothing from outside, and obeys nothing that stands in a log.
#include "experiments/logs/plot/page.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>

#include "experiments/logs/plot/make_figure.hpp"
#include "some_logs.hpp"

namespace darwinop::plot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Figure oneCurve(const std::string& text) {
  Curve curve;
  curve.label = text;
  curve.x = {0, 0.5, 1};
  curve.y = {1.25, NAN, -3};
  return {text, text, {{text, text, text, text, text, text}}, {text}, {{text, text, {curve}}}};
}

/// What the browser takes as the figure: all from the opening tag to the first closing one.
std::string figureIn(const std::string& page) {
  const std::string tag = "<script type=\"application/json\" id=\"figure\">";
  const std::size_t begin = page.find(tag) + tag.size();
  return page.substr(begin, page.find("</script", begin) - begin);
}

/// Numbers of the first list that follows this key; null is NaN.
std::vector<double> numbersAfter(const std::string& text, const std::string& key) {
  std::size_t at = text.find(key) + key.size();
  std::vector<double> values;
  while (text[at] != ']') {
    const std::size_t end = text.find_first_of(",]", at);
    const std::string number = text.substr(at, end - at);
    values.push_back(number == "null" ? NAN : std::atof(number.c_str()));
    at = text[end] == ',' ? end + 1 : end;
  }
  return values;
}

TEST(Page, CarriesEveryNumberOfTheFigure) {
  const std::string figure = figureIn(htmlPage(oneCurve("Neck")));
  EXPECT_THAT(numbersAfter(figure, "\"y\":["), ElementsAre(1.25, testing::IsNan(), -3));
  EXPECT_THAT(numbersAfter(figure, "\"axes\":[["), ElementsAre(0, 0.5, 1));
  for (const char* text : {"\"title\":\"Neck\"", "\"robot\":\"Neck\"", "\"label\":\"Neck\"", "\"notes\":[\"Neck\"]"})
    EXPECT_THAT(figure, HasSubstr(text));
}

TEST(Page, CarriesWhereSomethingBegins) {
  Figure figure = oneCurve("a");
  figure.marks = {0, 1.25};
  EXPECT_THAT(htmlPage(figure), HasSubstr("\"marks\":[0,1.25]"));
}

TEST(Page, WritesTimesThatCurvesShareOnce) {
  const Figure figure = makeFigure({twoJoints("a.csv"), twoJoints("b.csv", 70)}, {{"a.csv", "b.csv"}, "", {}, ""});
  const std::string text = figureIn(htmlPage(figure));
  EXPECT_THAT(text, HasSubstr("\"axes\":[[0,1,2]]"));
  EXPECT_THAT(text, Not(HasSubstr("\"x\":1")));
}

TEST(Page, AsksForNothingFromOutside) {
  const std::string page = htmlPage(oneCurve("Neck"));
  // What a browser would fetch: sources, styles, imports, maps.
  for (const char* fetch :
       {"<link rel=\"stylesheet", " src=", "@import", "sourceMappingURL", "url(", "XMLHttpRequest(\"http"})
    EXPECT_THAT(page, Not(HasSubstr(fetch))) << fetch;
  const std::regex address{"https?://[^\\s\"'<>)]+"};
  for (std::sregex_iterator it{page.begin(), page.end(), address}, end; it != end; ++it)
    EXPECT_THAT(it->str(),
                testing::AnyOf(HasSubstr("github.com/danvk/dygraphs"), HasSubstr("opensource.org/licenses/MIT")))
        << "only licence notes in comments of the library name an address";
  EXPECT_THAT(page, HasSubstr("default-src 'none'")) << "and the browser is told to fetch nothing";
}

class HostileText : public testing::TestWithParam<const char*> {};

TEST_P(HostileText, EndsNoScriptAndIsKeptToTheLetter) {
  const std::string page = htmlPage(oneCurve(GetParam()));
  const std::string plain = htmlPage(oneCurve("Neck"));
  const auto tags = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find("<script"); at != std::string::npos; at = text.find("<script", at + 1)) ++count;
    for (std::size_t at = text.find("</script"); at != std::string::npos; at = text.find("</script", at + 1)) ++count;
    for (std::size_t at = text.find("<img"); at != std::string::npos; at = text.find("<img", at + 1)) ++count;
    for (std::size_t at = text.find("<!--"); at != std::string::npos; at = text.find("<!--", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(tags(page), tags(plain));
  EXPECT_THAT(page, HasSubstr("© 2006–2023")) << "the rest of the page stands";
  // Read back as JSON does: the text itself.
  const std::string figure = figureIn(page);
  std::string text;
  const std::string key = "{\"title\":\"";
  for (std::size_t at = key.size(); figure[at] != '"'; ++at) {
    if (figure[at] != '\\') {
      text += figure[at];
    } else if (figure[at + 1] == 'u') {
      text += static_cast<char>(std::strtol(figure.substr(at + 2, 4).c_str(), nullptr, 16));
      at += 5;
    } else {
      text += figure[++at];
    }
  }
  EXPECT_EQ(text, GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, HostileText,
                         testing::Values("a\"b'c", "</script><script>alert(1)</script>", "<!--<script>",
                                         "`id` $(id) ${x}", "\\", "\\\"", "<img src=x onerror=alert(1)>",
                                         "@FIGURE@ @LIBRARY@", "&lt; &amp;"));

}  // namespace
}  // namespace darwinop::plot
