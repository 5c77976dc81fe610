// Puts the page together: what is written in page/, the plotting library, and the report.
#include <array>
#include <string_view>

#include "core/text/template.hpp"
#include "gap/report/html.hpp"
#include "gap/report/page_parts.hpp"
#include "gap/report/page_sections.hpp"

namespace darwinop::gap {
namespace {

/// Author and licence of the plotting library, as in the HTML plots.
std::string libraryNote() {
  constexpr std::string_view kBegin = "<footer>", kEnd = "</footer>";
  const std::string_view page = page_parts::kPlotPage;
  const std::size_t begin = page.find(kBegin) + kBegin.size();
  return std::string{page.substr(begin, page.find(kEnd) - begin)};
}

}  // namespace

std::string asHtml(const Report& report) {
  const std::string body =
      verdictSection(report) + headlineSection(report) + whatSection(report) + whereSection(report);
  const std::array<text::TemplatePart, 8> parts{{
      {"@TITLE@", html::text("darwinop gap: " + report.given->name)},
      {"@STYLE@", std::string{page_parts::kLibraryStyle} + std::string{page_parts::kStyle}},
      {"@FINDINGS@", body},
      {"@DETAILS@", logsSection(report) + modelSection(report.model_before, report.model_after) + againSection(report)},
      {"@LIBRARY_NOTE@", libraryNote()},
      {"@CURVES@", curvesAsJson(report)},
      {"@LIBRARY@", std::string{page_parts::kLibrary}},
      {"@SCRIPT@", std::string{page_parts::kCurves} + std::string{page_parts::kScript}},
  }};
  return text::filledTemplate(page_parts::kPage, parts);
}

}  // namespace darwinop::gap
