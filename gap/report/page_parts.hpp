// The texts that the page is made of. experiments/logs/plot/embed.cmake makes page_parts.cpp from page/ and from
// dygraphs.
#pragma once

#include <string_view>

namespace darwinop::gap::page_parts {

extern const std::string_view kPage, kStyle, kCurves, kScript;
extern const std::string_view kLibrary, kLibraryStyle;
extern const std::string_view kPlotPage;  // has the licence of the library

}  // namespace darwinop::gap::page_parts
