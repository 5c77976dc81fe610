// Motion files as text, lossless. Format: docs/motion-command.md.
#pragma once

#include <string>
#include <string_view>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

/// The first line of every text; distinguishes it from a binary file.
inline constexpr std::string_view kTextTitle = "darwinop motion 1";

/// Page that is absent from a text: empty; page 0 is all zeros, as in the vendor's file.
[[nodiscard]] Page defaultPage(std::size_t number);

/// Writes only what differs from the default pages.
[[nodiscard]] std::string writePages(const PageFile& pages);
/// The section of one page.
[[nodiscard]] std::string writePage(const Page& page, std::size_t number);

/// Throws std::runtime_error with `file`, line and field. The result can be encoded and decoded again.
[[nodiscard]] PageFile parsePages(std::string_view text, const std::string& file);

}  // namespace darwinop::motion
