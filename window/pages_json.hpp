// The motion pages that the page may play, for its buttons.
#pragma once

#include <string>

#include "managers/motion/page_file.hpp"

namespace darwinop::window {

/// [{"number": 1, "name": "init"}], of those that can be played by themselves.
[[nodiscard]] std::string pagesJson(const motion::PageFile& pages);

}  // namespace darwinop::window
