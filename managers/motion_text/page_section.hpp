// Parses the fields of one page. Messages name the field; the caller adds file and line.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "managers/motion/page.hpp"

namespace darwinop::motion {

class PageSection {
 public:
  explicit PageSection(std::size_t number) : number_{number} {}

  /// Throws std::runtime_error for an unknown or duplicate key or an invalid value.
  void set(const std::string& key, std::string_view value);
  /// Returns the page. Throws std::runtime_error for inconsistent fields.
  [[nodiscard]] Page finish();

  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  void setName(std::string_view value);
  void setSchedule(std::string_view value);
  bool setHeader(const std::string& key, std::string_view value);
  bool setGain(const std::string& key, std::string_view value);
  bool setRow(const std::string& key, std::string_view value);
  /// One value per step; all rows of a page have the same number of values.
  std::vector<std::string_view> columnsOf(const std::string& key, std::string_view value);
  void setOthers(std::size_t step, std::uint16_t word);

  std::size_t number_;
  Page page_ = emptyPage();
  std::set<std::string> seen_;
  std::optional<std::size_t> columns_;
  std::string first_row_;  // sets the number of columns
};

}  // namespace darwinop::motion
