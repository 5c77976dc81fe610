// Lines of the keys of an INI text, to find repeated ones.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "core/text/letter_case.hpp"

namespace darwinop::text {

class KeyLines {
 public:
  /// Line in which this key stands before `line`, in any letter case; 0: none.
  int firstOf(std::string_view section, std::string_view key, int line) {
    const auto [at, is_new] = lines_.try_emplace({lowered(section), lowered(key)}, line);
    return is_new ? 0 : at->second;
  }

 private:
  std::map<std::pair<std::string, std::string>, int> lines_;
};

}  // namespace darwinop::text
