// The files of the page, which lie in the program.
#pragma once

#include <span>
#include <string_view>

namespace darwinop::window {

struct Asset {
  std::string_view name;  // "window.js"; empty: the page itself
  std::string_view type;
  std::string_view body;
};

[[nodiscard]] std::span<const Asset> assets();

}  // namespace darwinop::window
