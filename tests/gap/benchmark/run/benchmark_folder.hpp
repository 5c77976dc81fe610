// A folder of cases with a case.json only, for suites with trivial results.
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace darwinop::gap {

class SuiteFolder {
 public:
  explicit SuiteFolder(const std::vector<std::string>& names) {
    for (const std::string& name : names) add(name);
  }
  void add(const std::string& name) { write(name, "{}"); }
  void change(const std::string& name) { write(name, "{ }"); }
  void remove(const std::string& name) { std::filesystem::remove_all(cases() + "/" + name); }

  [[nodiscard]] std::string top() const { return folder_ / "suite"; }
  [[nodiscard]] std::string cases() const { return folder_ / "suite/cases"; }
  [[nodiscard]] std::string results() const { return folder_ / "results.json"; }

 private:
  void write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories(cases() + "/" + name);
    std::ofstream{cases() + "/" + name + "/case.json"} << text;
  }
  TemporaryFolder folder_;
};

inline nlohmann::json cheapAnswer(const std::string& path) {
  return {{"case", std::filesystem::path{path}.filename()},
          {"verdict", "none"},
          {"effects", nlohmann::json::array()},
          {"runtime_s", 1.5}};
}

}  // namespace darwinop::gap
