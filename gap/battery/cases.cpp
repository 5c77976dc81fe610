#include "gap/battery/cases.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "gap/battery/answer.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::vector<CaseFolder> casesIn(const std::string& folder) {
  if (!fs::is_directory(folder)) throw std::runtime_error(folder + ": is no folder; name one that has cases in it");
  if (fs::exists(fs::path{folder} / "case.json"))
    throw std::runtime_error(folder + ": is one case; `darwinop gap run` takes it, a battery is a folder of such");
  std::vector<CaseFolder> cases;
  for (const auto& entry : fs::directory_iterator{folder})
    if (fs::exists(entry.path() / "case.json"))
      cases.push_back({entry.path().filename().string(), entry.path().string(), fingerprintOf(entry.path().string())});
  if (cases.empty() && fs::is_directory(fs::path{folder} / "cases"))
    return casesIn((fs::path{folder} / "cases").string());
  if (cases.empty()) throw std::runtime_error(folder + ": there is no case in it, a folder with a case.json");
  std::ranges::sort(cases, {}, &CaseFolder::name);
  return cases;
}

}  // namespace darwinop::gap
