// Text from somewhere else on its way to a terminal: nothing in it may be taken for a command.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace darwinop::text {

/// Length of the valid UTF-8 sequence at the start of `text`, which is not empty; 0: there is none.
[[nodiscard]] std::size_t utf8Length(std::string_view text);

/// One line that a terminal shows as it is: control characters, bytes that are not UTF-8, and marks that change the
/// direction of writing become \xNN. A backslash stays one: this is for people, not for reading it back.
[[nodiscard]] std::string printable(std::string_view text);

/// The same of a text that may have several lines.
[[nodiscard]] std::string printableLines(std::string_view text);

}  // namespace darwinop::text
