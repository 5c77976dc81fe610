// Checks motion pages for errors that could make the robot fall: one finding per line, with page, step and joint.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

/// Finds links to pages that are not playable, endless chains, gains that are too low, positions out of range, jumps of
/// goals, and speeds above the servo's. Checks playable pages only.
[[nodiscard]] std::vector<std::string> checkPages(const PageFile& pages);

/// One message of decodePages() per damaged page of a binary file. `pages` receives the others, and empty pages for
/// these; it is empty if the length is wrong.
[[nodiscard]] std::vector<std::string> checkBytes(std::span<const std::uint8_t> bytes, PageFile& pages);

}  // namespace darwinop::motion
