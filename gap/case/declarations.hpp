// What raw logs do not contain, as a user declares it: KEY=VALUE.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// What every log of a bench has.
struct BenchKey {
  std::string_view key;             // "payload_kg"
  std::optional<double> otherwise;  // nothing: has to be given
  std::string_view meaning;
};
std::span<const BenchKey> benchKeys();

class Declarations {
 public:
  /// Of "kp=32" and the like. Throws BadInput for another key, listing them all.
  explicit Declarations(const std::vector<std::string>& words);

  /// Nothing: not declared. The number throws BadInput for a value that is none.
  [[nodiscard]] std::optional<std::string> text(std::string_view key) const;
  [[nodiscard]] std::optional<double> number(std::string_view key) const;
  /// Columns of counts with their encoding: "load_raw".
  [[nodiscard]] const std::map<std::string, std::string>& encodings() const { return encodings_; }

  /// Priors, relative, by the number that they are of: "payload_kg".
  [[nodiscard]] const std::map<std::string, double>& sigmas() const { return sigmas_; }

  /// Any number of the servo is declared.
  [[nodiscard]] bool describeServo() const { return !servo_.empty(); }
  /// One whose key begins so.
  [[nodiscard]] bool describes(std::string_view key) const;
  /// A number that is not declared, of a data sheet, with its prior unless one is declared; sigma 0: it has none of its
  /// own. Returns the prior that counts, 0: none.
  double addServo(const std::string& key, double value, double relative_sigma);
  /// Which of those that a servo needs are not: a line each, empty: none.
  [[nodiscard]] std::string missingOfServo() const;
  /// Of a servo whose gain is known: the same if one half of another gain is declared.
  [[nodiscard]] std::string missingOfGain() const;
  /// What is not declared is as in `servo`. Appends to `notes` what is assumed.
  [[nodiscard]] twin::ServoParameters servoFrom(twin::ServoParameters servo, std::vector<std::string>& notes) const;

  /// A line of the list of what is missing.
  static std::string missing(std::string_view key, std::string_view meaning);

 private:
  [[nodiscard]] std::size_t halvesOfGain() const;

  std::map<std::string, std::string, std::less<>> bench_;
  std::map<std::string, std::string> encodings_;
  std::map<std::string, double> servo_;
  std::map<std::string, double> sigmas_;
};

}  // namespace darwinop::gap
