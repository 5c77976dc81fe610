// Key reports with releases: the kitty keyboard protocol (https://sw.kovidgoyal.net/kitty/keyboard-protocol), also of
// foot, Ghostty, Alacritty and others. A terminal without it ignores the query.
#pragma once

#include <optional>
#include <string_view>

#include "hal/keyboard_terminal/key_event.hpp"

namespace darwinop::terminal {

/// The terminal replies with its flags: CSI ? FLAGS u.
inline constexpr std::string_view kAskForReports = "\x1b[?u";
/// Flag of the reply: releases are reported.
inline constexpr unsigned kReportsReleases = 2;
/// Pushes flags 1 unambiguous, 2 releases, 4 key of the base layout, 8 also of keys that type text; reports of a lost
/// focus. After that Ctrl-C no longer raises SIGINT.
inline constexpr std::string_view kStartReports = "\x1b[>15u\x1b[?1004h";
inline constexpr std::string_view kEndReports = "\x1b[?1004l\x1b[<u";

/// Second parameter of a sequence, "MODIFIERS:EVENT", both optional.
struct KeyState {
  Key modifiers = 0;
  bool released = false;
};
[[nodiscard]] KeyState keyStateOf(std::string_view parameter);

/// "CODE:SHIFTED:BASE;MODIFIERS:EVENT" of CSI ... u. Empty for keys that hal/keyboard.hpp does not know.
[[nodiscard]] std::optional<KeyEvent> keyOfReport(std::string_view parameters);

}  // namespace darwinop::terminal
