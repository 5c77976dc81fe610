// What stands in the window: whether the robot listens, which keys are down, and what not to do.
#pragma once

#include <xcb/xcb.h>

#include <cstdint>
#include <string>

namespace darwinop::x11 {

class Picture {
 public:
  static constexpr std::uint16_t kWidth = 500, kHeight = 150;

  Picture(xcb_connection_t* connection, const xcb_screen_t& screen, xcb_window_t window);

  /// `keys`: their names. Sends, does not flush.
  void draw(bool listening, const std::string& keys) const;

 private:
  void write(std::int16_t y, const std::string& text, std::uint32_t colour, std::uint32_t ground) const;
  void fill(const xcb_rectangle_t& area, std::uint32_t colour) const;
  [[nodiscard]] std::uint32_t colour(std::uint16_t red, std::uint16_t green, std::uint16_t blue) const;

  xcb_connection_t* connection_;
  const xcb_screen_t& screen_;
  xcb_window_t window_;
  xcb_gcontext_t pen_;
  std::uint32_t listening_ = 0, deaf_ = 0;
};

}  // namespace darwinop::x11
