// Finds a motion page by its name.
#pragma once

#include <string_view>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

/// Number of the first playable page with this name; 0: none.
inline int findPage(const PageFile& pages, std::string_view name) {
  for (std::size_t i = 1; i < pages.size(); ++i)
    if (pages[i].canPlay() && pages[i].nameText() == name) return static_cast<int>(i);
  return 0;
}

}  // namespace darwinop::motion
