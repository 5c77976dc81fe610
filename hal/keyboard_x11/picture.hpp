// Draws the window's content: keyboard state, held keys, instructions.
#pragma once

#include <xcb/xcb.h>

#include <cstdint>
#include <string>

namespace darwinop::x11 {

class KeyWindowCanvas {
 public:
  static constexpr std::uint16_t kWidth = 500, kHeight = 150;

  KeyWindowCanvas(xcb_connection_t* connection, const xcb_screen_t& screen, xcb_window_t window);

  /// `keys`: display names. Sends the requests without flushing.
  void draw(bool listening, const std::string& keys) const;

 private:
  void write(std::int16_t y, const std::string& text, std::uint32_t colour, std::uint32_t ground) const;
  void fill(const xcb_rectangle_t& area, std::uint32_t colour) const;
  [[nodiscard]] std::uint32_t colour(std::uint16_t red, std::uint16_t green, std::uint16_t blue) const;

  xcb_connection_t* connection_;
  const xcb_screen_t& screen_;
  xcb_window_t window_;
  xcb_gcontext_t pen_;
  std::uint32_t active_ = 0, inactive_ = 0;
};

}  // namespace darwinop::x11
