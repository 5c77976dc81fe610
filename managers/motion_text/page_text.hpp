// Motion files as text: 256 pages to text, and back without the loss of a bit. The format: docs/motion-command.md.
#pragma once

#include <string>
#include <string_view>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

/// The first line of every such text; it tells the two kinds of file apart.
inline constexpr std::string_view kTextTitle = "darwinop motion 1";

/// The page that a text does not mention: an empty one; page 0 is all zeros, as in the vendor's file.
[[nodiscard]] Page unmentionedPage(std::size_t number);

/// Only what differs from an unmentioned page is written.
[[nodiscard]] std::string writePages(const PageFile& pages);
/// The section of one page.
[[nodiscard]] std::string writePage(const Page& page, std::size_t number);

/// Throws std::runtime_error with a sentence that names `file`, line and field: either all of the text is understood,
/// or none of it is taken. What comes out can be encoded, and decoded again.
[[nodiscard]] PageFile parsePages(std::string_view text, const std::string& file);

}  // namespace darwinop::motion
