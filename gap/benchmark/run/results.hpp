// results.json, written after each case: a killed run loses only the cases in progress.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace darwinop::gap {

/// What went wrong may be told in bytes of a broken file: what is no UTF-8 is replaced. `indent` -1: on one line.
std::string textOf(const nlohmann::json& answers, int indent = 1);

class Results {
 public:
  /// `path` empty: in memory only. `resume`: takes over what is there; else a file that is there becomes
  /// `path`.before. Throws std::runtime_error, a sentence, when it cannot be read or written.
  Results(std::string path, bool resume);

  /// An answer to this very case (answer.hpp: fingerprintOf) that needs no second try.
  [[nodiscard]] bool has(const std::string& name, const std::string& fingerprint) const;
  /// Adds or replaces, and writes the file.
  void put(nlohmann::json answer);
  /// Of these cases only, so that no answer stays of a case that is gone; writes the file.
  void keepOnly(const std::map<std::string, std::string>& fingerprints);

  /// A list, in the order of the names: the same whatever the order in which the answers came.
  [[nodiscard]] nlohmann::json all() const;
  [[nodiscard]] std::size_t count() const { return answers_.size(); }

 private:
  void load();
  void save() const;

  std::string path_;
  std::map<std::string, nlohmann::json> answers_;
};

}  // namespace darwinop::gap
