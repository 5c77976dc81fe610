// Built-in motion pages: the texts of managers/motion/pages/, embedded at build time.
#pragma once

#include <span>
#include <string_view>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

/// Stands for the built-in pages in place of a motion file name; write ./own for a file of that name.
inline constexpr std::string_view kOwn = "own";

struct OwnText {
  std::string_view name;  // file name without folder
  std::string_view text;
};

/// Sorted by name.
[[nodiscard]] std::span<const OwnText> ownTexts();

/// All pages as one file. Throws std::runtime_error if a text is invalid or two texts have the same page.
[[nodiscard]] PageFile mergeTexts(std::span<const OwnText> texts);

/// The pages of ownTexts(), parsed at the first call.
[[nodiscard]] const PageFile& ownPages();

}  // namespace darwinop::motion
