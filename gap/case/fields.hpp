// The values of one object of a JSON file, taken out one by one. What is not taken in the end is a typing error, or
// said.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "twin/model/number.hpp"

namespace darwinop::gap {

using Json = nlohmann::ordered_json;

/// Every failure is a BadInput, "FILE: `baseline.params.kt_Nm_A` …". The JSON has to outlive it.
class Fields {
 public:
  Fields(const Json& json, std::string file, std::string path);

  /// There, and not null.
  [[nodiscard]] bool has(std::string_view key);
  double number(std::string_view key, const twin::NumberRule& rule);
  double number(std::string_view key, const twin::NumberRule& rule, double otherwise);
  /// A list of `count` numbers.
  std::vector<double> numbers(std::string_view key, const twin::NumberRule& rule, std::size_t count);
  std::string text(std::string_view key);
  std::string text(std::string_view key, std::string_view otherwise);
  bool flag(std::string_view key, bool otherwise);
  /// One of `words`; its index.
  std::size_t word(std::string_view key, const std::vector<std::string_view>& words, std::size_t otherwise);
  Fields object(std::string_view key);
  std::vector<Fields> list(std::string_view key);

  /// May be there, for people.
  void leave(std::string_view key);
  /// Keys that were not read.
  [[nodiscard]] std::vector<std::string> untaken() const;
  /// Throws for the first of them. Comments may stand anywhere: note, comment, source and the like.
  void finish() const;
  /// Of an object that other programs add to: throws for what is a few letters away from a key that was read, or a
  /// part of one, and puts into `warnings` what else is left out.
  void finish(std::vector<std::string>& warnings) const;

  [[nodiscard]] std::vector<std::string> keys() const;
  [[nodiscard]] const std::string& file() const { return file_; }
  [[noreturn]] void fail(std::string_view key, const std::string& sentence) const;

 private:
  const Json& needed(std::string_view key, const std::string& wanted);
  [[nodiscard]] std::string pathOf(std::string_view key) const;

  const Json* json_;
  std::string file_, path_;
  std::vector<std::string> known_;
};

/// A case of the whole robot, gap/case/body: "family" is "body".
bool isWholeRobot(const Json& json);

/// The whole of a file, an object. Throws BadInput with file and line for invalid JSON and for a key that occurs twice.
Json parseJson(std::string_view text, const std::string& file);

}  // namespace darwinop::gap
