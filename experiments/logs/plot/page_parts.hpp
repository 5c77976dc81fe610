// Embedded parts of the HTML file. embed.cmake generates page_parts.cpp from the files in page/ and from dygraphs.
#pragma once

#include <string_view>

namespace darwinop::plot::page_parts {

extern const std::string_view kPage, kStyle, kSamples, kScript;
extern const std::string_view kLibrary, kLibraryStyle, kSynchronizer;

}  // namespace darwinop::plot::page_parts
