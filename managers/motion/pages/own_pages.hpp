// The project's own motion pages: the texts of managers/motion/pages/, put into the library when it is built.
#pragma once

#include <span>
#include <string_view>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

/// What stands for the own pages where a motion file is asked for; a file of that name is ./own.
inline constexpr std::string_view kOwn = "own";

struct OwnText {
  std::string_view name;  // of the file, without a folder
  std::string_view text;
};

/// In the order of their names.
[[nodiscard]] std::span<const OwnText> ownTexts();

/// All their pages as one file. Throws std::runtime_error: a text is broken, or two have the same page; both are named.
[[nodiscard]] PageFile mergeTexts(std::span<const OwnText> texts);

/// Of ownTexts(), parsed at the first call.
[[nodiscard]] const PageFile& ownPages();

}  // namespace darwinop::motion
