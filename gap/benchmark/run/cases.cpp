#include "gap/benchmark/run/cases.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "gap/benchmark/run/answer.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::vector<CaseFolder> casesIn(const std::string& folder) {
  if (!fs::is_directory(folder)) throw std::runtime_error(folder + ": not a folder; give one that contains cases");
  if (fs::exists(fs::path{folder} / "case.json"))
    throw std::runtime_error(folder + ": is a single case; use `darwinop gap run`, or give a folder of cases");
  std::vector<CaseFolder> cases;
  for (const auto& entry : fs::directory_iterator{folder})
    if (fs::exists(entry.path() / "case.json"))
      cases.push_back({entry.path().filename().string(), entry.path().string(), fingerprintOf(entry.path().string())});
  if (cases.empty() && fs::is_directory(fs::path{folder} / "cases"))
    return casesIn((fs::path{folder} / "cases").string());
  if (cases.empty()) throw std::runtime_error(folder + ": contains no case (a folder with a case.json)");
  std::ranges::sort(cases, {}, &CaseFolder::name);
  return cases;
}

}  // namespace darwinop::gap
