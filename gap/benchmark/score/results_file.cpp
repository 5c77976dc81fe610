#include "gap/benchmark/score/results_file.hpp"

#include <limits>
#include <optional>
#include <set>
#include <stdexcept>

#include "hal/text_file.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kLongestResults = std::size_t{64} << 20;  // bytes

}  // namespace

void forEachResult(const std::string& path,
                   const std::function<void(const std::string& name, const nlohmann::ordered_json& result)>& take) {
  const std::optional<std::string> text = readTextFile(path, kLongestResults);
  if (!text) throw std::runtime_error("cannot read " + path + "; `darwinop gap benchmark run` writes it");
  std::set<std::string> names;
  std::string at;
  try {
    const auto all = nlohmann::ordered_json::parse(*text);
    if (!all.is_array()) throw std::runtime_error("expected a list with one object for each case");
    for (const auto& result : all) {
      const std::string name = result.at("case");
      at = ", case " + name;
      if (!names.insert(name).second) throw std::runtime_error("has two results");
      take(name, result);
    }
  } catch (const std::exception& error) {
    throw std::runtime_error(path + at + ": " + error.what());
  }
}

double numberIn(const nlohmann::ordered_json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number() ? found->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace darwinop::gap
