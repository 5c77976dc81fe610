// One page of the text as its lines come in. Sentences name the field; file and line are the caller's.
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

  /// Throws std::runtime_error when the key is unknown, has been there before, or the value cannot be.
  void set(const std::string& key, std::string_view value);
  /// The whole page. Throws std::runtime_error when what the lines say does not fit together.
  [[nodiscard]] Page finish();

  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  void setName(std::string_view value);
  void setSchedule(std::string_view value);
  bool setHeader(const std::string& key, std::string_view value);
  bool setGain(const std::string& key, std::string_view value);
  bool setRow(const std::string& key, std::string_view value);
  /// One value a step; every row of a page has the same number of them.
  std::vector<std::string_view> columnsOf(const std::string& key, std::string_view value);
  void setOthers(std::size_t step, std::uint16_t word);

  std::size_t number_;
  Page page_ = emptyPage();
  std::set<std::string> seen_;
  std::optional<std::size_t> columns_;
  std::string first_row_;  // whose number of columns the others must have
};

}  // namespace darwinop::motion
