// The texts that a page is made of. embed.cmake makes page_parts.cpp from the files in page/ and from dygraphs.
#pragma once

#include <string_view>

namespace darwinop::plot::page_parts {

extern const std::string_view kPage, kStyle, kScript;
extern const std::string_view kLibrary, kLibraryStyle, kSynchronizer;

}  // namespace darwinop::plot::page_parts
