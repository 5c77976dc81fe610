// Embeds the page's files with the assembler.
#include "window/page/assets.hpp"

#include <array>

// Embeds a file between two symbols.
#define DARWINOP_ASSET(mark, file)                              \
  asm(".pushsection .rodata\n"                                  \
      ".global darwinop_asset_" #mark "\ndarwinop_asset_" #mark \
      ":\n"                                                     \
      ".incbin \"" file                                         \
      "\"\n"                                                    \
      ".global darwinop_end_" #mark "\ndarwinop_end_" #mark     \
      ":\n"                                                     \
      ".byte 0\n.popsection\n");                                \
  extern "C" const char darwinop_asset_##mark[], darwinop_end_##mark[];

DARWINOP_ASSET(page, DARWINOP_PAGE "/index.html")
DARWINOP_ASSET(icon, DARWINOP_PAGE "/icon.svg")
DARWINOP_ASSET(script, DARWINOP_BUNDLE "/window.js")
DARWINOP_ASSET(style, DARWINOP_BUNDLE "/window.css")

namespace darwinop::window {

std::span<const Asset> assets() {
  const auto between = [](const char* begin, const char* end) {
    return std::string_view{begin, static_cast<std::size_t>(end - begin)};
  };
  static const std::array<Asset, 4> all{{
      {"", "text/html; charset=utf-8", between(darwinop_asset_page, darwinop_end_page)},
      {"icon.svg", "image/svg+xml", between(darwinop_asset_icon, darwinop_end_icon)},
      {"window.js", "text/javascript; charset=utf-8", between(darwinop_asset_script, darwinop_end_script)},
      {"window.css", "text/css; charset=utf-8", between(darwinop_asset_style, darwinop_end_style)},
  }};
  return all;
}

}  // namespace darwinop::window
