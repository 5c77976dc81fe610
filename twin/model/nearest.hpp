// The known word that somebody may have meant.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace darwinop::twin {

/// The one of `known` that is a few letters away, upper and lower case being the same. Nothing: none is near.
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> known);

/// "did you mean coulomb?", or "there are coulomb, viscous and backlash".
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

/// "coulomb, viscous and backlash"; `last` stands before the last one.
std::string listed(std::span<const std::string_view> words, std::string_view last = "and");

}  // namespace darwinop::twin
