// Text from a log on its way to a picture or page: nothing in it may be taken for a command.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::plot {

/// One line of valid UTF-8: control characters become spaces, broken bytes question marks.
[[nodiscard]] std::string oneLine(std::string_view text);

/// At most `length` characters; what is cut off is told by an ellipsis.
[[nodiscard]] std::string shortened(const std::string& text, std::size_t length);

/// A number as the outputs write it, `digits` significant ones.
void appendNumber(std::string& out, double value, int digits);

}  // namespace darwinop::plot
