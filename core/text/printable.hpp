// Escapes untrusted text for output to a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace darwinop::text {

/// Length of the valid UTF-8 sequence at the start of `text`, which is not empty; 0: there is none.
[[nodiscard]] std::size_t utf8Length(std::string_view text);

/// One line without terminal control: control characters, bytes that are not UTF-8, and bidirectional marks become
/// \xNN. A backslash is not escaped, so the result cannot be parsed back.
[[nodiscard]] std::string printable(std::string_view text);

/// The same for text with several lines.
[[nodiscard]] std::string printableLines(std::string_view text);

}  // namespace darwinop::text
