// Suggestions for misspelled names.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace darwinop::text {

/// The word of `known` with the smallest edit distance, ignoring case; empty if none is close.
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> known);

/// "did you mean coulomb?", or "there are coulomb, viscous and backlash".
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

/// "coulomb, viscous and backlash"; `last` is the conjunction.
std::string listed(std::span<const std::string_view> words, std::string_view last = "and");

}  // namespace darwinop::text
