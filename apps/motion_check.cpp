#include "motion_check.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "exit_codes.hpp"
#include "managers/motion_text/check_pages.hpp"
#include "managers/motion_text/motion_file.hpp"
#include "motion_own.hpp"

namespace darwinop::motion {
namespace {

/// Errors of the file are added to `findings`; returns the readable pages.
PageFile readForCheck(const std::string& path, std::vector<std::string>& findings) {
  if (path == kOwn) return ownPages();
  const std::vector<std::uint8_t> bytes = readBytes(path);
  PageFile pages;
  if (!isText(bytes)) {
    findings = checkBytes(bytes, pages);
    return pages;
  }
  try {
    pages = readMotionFile(path).pages;
  } catch (const std::runtime_error& why) {
    findings.emplace_back(why.what());
  }
  return pages;
}

}  // namespace

int checkMotions(const std::string& file) {
  refuseMotionOfWebots(file);
  std::vector<std::string> findings;
  const PageFile pages = readForCheck(file, findings);
  for (std::string& finding : checkPages(pages)) findings.push_back(std::move(finding));
  for (const std::string& finding : findings) std::cout << finding << '\n';
  if (!findings.empty()) return app::kFailed;
  const auto used = std::ranges::count_if(pages, [](const Page& page) { return page.canPlay(); });
  std::cout << file << ": " << used << (used == 1 ? " page" : " pages") << " to play, no findings\n";
  return app::kDone;
}

}  // namespace darwinop::motion
