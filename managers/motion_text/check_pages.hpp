// What a robot would stumble over in a motion file: one finding a line, with page, step and joint.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "managers/motion/page_file.hpp"

namespace darwinop::motion {

// Source: MX-28 control table, the top of the moving speed, 117.07 rpm; the runtime's safety lets nothing pass that is
// faster (max_joint_speed). Without a load and at 12 V the servo does about half of it.
inline constexpr double kServoMaxSpeed = 12.26;  // rad/s

/// Chains to pages that cannot be played, rings, gains that leave a joint limp, positions beyond the
/// joints' limits, goals that jump, speeds beyond the servo's. Only pages that can be played are looked at.
[[nodiscard]] std::vector<std::string> checkPages(const PageFile& pages);

/// One sentence for each page of a binary file that is damaged, as decodePages() tells it. `pages` gets the others,
/// and empty pages for these; it has none when the length is wrong.
[[nodiscard]] std::vector<std::string> checkBytes(std::span<const std::uint8_t> bytes, PageFile& pages);

}  // namespace darwinop::motion
