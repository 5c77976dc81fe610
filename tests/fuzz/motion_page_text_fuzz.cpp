// Motion pages as text: an error message, or a file that reads back equal.
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "managers/motion_text/check_pages.hpp"
#include "managers/motion_text/dry_run.hpp"
#include "managers/motion_text/mirror.hpp"
#include "managers/motion_text/page_text.hpp"

namespace {

using namespace darwinop::motion;

void require(bool holds) {
  if (!holds) std::abort();
}

void requireSound(const PageFile& pages) {
  require(decodePages(encodePages(pages)) == pages);
  require(parsePages(writePages(pages), "again.txt") == pages);
  for (const std::string& finding : checkPages(pages)) require(finding.starts_with("page "));
  for (const Page& page : pages)
    if (page.canPlay()) require(mirrored(mirrored(mirrored(page))) == mirrored(page));
  // One of them: a page may take a minute of ticks.
  for (std::size_t i = 1; i < pages.size(); ++i)
    if (pages[i].canPlay()) {
      const DryRun played = dryRun(pages, static_cast<int>(i), firstPose(pages[i]));
      require(!played.sections.empty() && played.poses.size() < 8000);
      break;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  PageFile pages;
  try {
    pages = parsePages({reinterpret_cast<const char*>(data), size}, "pages.txt");
  } catch (const std::runtime_error& refused) {
    require(std::string_view{refused.what()}.starts_with("pages.txt, line "));
    return 0;
  }
  requireSound(pages);
  return 0;
}
