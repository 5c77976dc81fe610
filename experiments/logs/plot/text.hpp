// Sanitizes text from logs for pictures and HTML.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::plot {

/// One line of valid UTF-8: control characters become spaces, invalid bytes question marks.
[[nodiscard]] std::string oneLine(std::string_view text);

/// At most `length` characters; truncated text ends with an ellipsis.
[[nodiscard]] std::string shortened(const std::string& text, std::size_t length);

}  // namespace darwinop::plot
