// results.json, written after each case: a killed run loses only the cases in progress.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace darwinop::gap {

class Results {
 public:
  /// `path` empty: in memory only. `resume`: loads an existing file; else it is renamed to `path`.before.
  /// Throws std::runtime_error, a sentence, when it cannot be read or written.
  Results(std::string path, bool resume);

  /// A result of this content of the case (answer.hpp: fingerprintOf) that is not an internal error.
  [[nodiscard]] bool has(const std::string& name, const std::string& fingerprint) const;
  /// Adds or replaces, and writes the file.
  void put(nlohmann::json answer);
  /// Drops the results of all other cases; writes the file.
  void keepOnly(const std::map<std::string, std::string>& fingerprints);

  /// A list in the order of the names.
  [[nodiscard]] nlohmann::json all() const;
  [[nodiscard]] std::size_t count() const { return answers_.size(); }

 private:
  void load();
  void save() const;

  std::string path_;
  std::map<std::string, nlohmann::json> answers_;
};

}  // namespace darwinop::gap
