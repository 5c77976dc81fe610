#include "hal/keyboard_x11/picture.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "hal/keyboard_x11/reply.hpp"

namespace darwinop::x11 {
namespace {

constexpr std::int16_t kMargin = 16, kBandHeight = 44;

/// X server fonts: "10x20" if available; "fixed" exists on every server.
xcb_font_t openFont(xcb_connection_t* connection) {
  for (const std::string name : {"10x20", "fixed"}) {
    const xcb_font_t font = ::xcb_generate_id(connection);
    const auto asked = ::xcb_open_font_checked(connection, font, static_cast<std::uint16_t>(name.size()), name.data());
    const Reply<xcb_generic_error_t> error{::xcb_request_check(connection, asked)};
    if (!error) return font;
  }
  return XCB_NONE;
}

}  // namespace

KeyWindowCanvas::KeyWindowCanvas(xcb_connection_t* connection, const xcb_screen_t& screen, xcb_window_t window)
    : connection_{connection}, screen_{screen}, window_{window}, pen_{::xcb_generate_id(connection)} {
  ::xcb_create_gc(connection_, pen_, window_, 0, nullptr);
  if (const xcb_font_t font = openFont(connection_); font != XCB_NONE) {
    ::xcb_change_gc(connection_, pen_, XCB_GC_FONT, &font);
    ::xcb_close_font(connection_, font);
  }
  active_ = colour(0x0000, 0x7000, 0x2000);
  inactive_ = colour(0xB000, 0x2000, 0x1000);
}

std::uint32_t KeyWindowCanvas::colour(std::uint16_t red, std::uint16_t green, std::uint16_t blue) const {
  const auto asked = ::xcb_alloc_color(connection_, screen_.default_colormap, red, green, blue);
  const Reply<xcb_alloc_color_reply_t> reply{::xcb_alloc_color_reply(connection_, asked, nullptr)};
  return reply ? reply->pixel : screen_.black_pixel;
}

void KeyWindowCanvas::fill(const xcb_rectangle_t& area, std::uint32_t colour) const {
  ::xcb_change_gc(connection_, pen_, XCB_GC_FOREGROUND, &colour);
  ::xcb_poly_fill_rectangle(connection_, window_, pen_, 1, &area);
}

void KeyWindowCanvas::write(std::int16_t y, const std::string& text, std::uint32_t colour, std::uint32_t ground) const {
  const std::array<std::uint32_t, 2> colours{colour, ground};
  ::xcb_change_gc(connection_, pen_, XCB_GC_FOREGROUND | XCB_GC_BACKGROUND, colours.data());
  constexpr std::size_t kMost = 255;  // per request
  ::xcb_image_text_8(connection_, static_cast<std::uint8_t>(std::min(text.size(), kMost)), window_, pen_, kMargin, y,
                     text.data());
}

void KeyWindowCanvas::draw(bool listening, const std::string& keys) const {
  constexpr std::uint16_t kFar = 4096;  // covers an enlarged window
  const std::uint32_t band = listening ? active_ : inactive_, white = screen_.white_pixel, black = screen_.black_pixel;
  fill({0, 0, kFar, kBandHeight}, band);
  fill({0, kBandHeight, kFar, kFar}, white);
  write(28, listening ? "Keyboard active." : "Keyboard inactive: click here.", white, band);
  write(74, "Keys down: " + (keys.empty() ? std::string{"none"} : keys), black, white);
  write(104, "Keys are read while this window has the focus.", black, white);
  write(128, "Closing it disables the keyboard; the controller continues.", black, white);
}

}  // namespace darwinop::x11
