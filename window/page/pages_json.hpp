// List of playable motion pages for the web page.
#pragma once

#include <string>

#include "managers/motion/page_file.hpp"

namespace darwinop::window {

/// [{"number": 1, "name": "init"}]; only pages that can be played on their own.
[[nodiscard]] std::string pagesJson(const motion::PageFile& pages);

}  // namespace darwinop::window
