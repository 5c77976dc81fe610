// Files of the web page, embedded in the program.
#pragma once

#include <span>
#include <string_view>

namespace darwinop::window {

struct Asset {
  std::string_view name;  // "window.js"; empty: index.html
  std::string_view type;
  std::string_view body;
};

[[nodiscard]] std::span<const Asset> assets();

}  // namespace darwinop::window
