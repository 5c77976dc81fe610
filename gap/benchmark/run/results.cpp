#include "gap/benchmark/run/results.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "core/json/json_text.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kFingerprint = "case_hash";

}  // namespace

Results::Results(std::string path, bool resume) : path_{std::move(path)} {
  if (path_.empty()) return;
  const bool is_there = fs::exists(path_) && fs::is_regular_file(path_) && fs::file_size(path_) > 0;
  if (is_there && resume)
    load();
  else if (is_there)
    fs::rename(path_, path_ + ".before");
  save();  // a file that cannot be written is known now, not after the first case
}

bool Results::has(const std::string& name, const std::string& fingerprint) const {
  const auto found = answers_.find(name);
  return found != answers_.end() && found->second.value(kFingerprint, "") == fingerprint &&
         found->second.at("verdict") != "error";
}

void Results::put(json answer) {
  std::string name = answer.at("case");
  answers_.insert_or_assign(std::move(name), std::move(answer));
  save();
}

void Results::keepOnly(const std::map<std::string, std::string>& fingerprints) {
  std::erase_if(answers_, [&](const auto& answer) {
    const auto found = fingerprints.find(answer.first);
    return found == fingerprints.end() || !has(found->first, found->second);
  });
  save();
}

json Results::all() const {
  json list = json::array();
  for (const auto& [name, answer] : answers_) list.push_back(answer);
  return list;
}

void Results::load() {
  try {
    std::ifstream file{path_, std::ios::binary};
    for (const json& answer : json::parse(file)) {
      (void)answer.at("verdict").get_ref<const std::string&>();
      answers_[answer.at("case")] = answer;
    }
  } catch (const json::exception& error) {
    throw std::runtime_error(path_ + ": not a results.json of benchmark run (" + error.what() +
                             "); give another --out, or start again without --resume");
  }
}

void Results::save() const {
  if (!path_.empty()) writeTextFile(path_, jsonText(all(), 1) + '\n');
}

}  // namespace darwinop::gap
