// Fills the places of a template, such as @TITLE@ in an HTML page.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace darwinop::text {

/// A place, and the text to put there.
using TemplatePart = std::pair<std::string_view, std::string>;

/// `page` with each place replaced once. `parts` are in the order of the page; text that is put in is not searched for
/// places. Throws std::logic_error if a place is missing.
std::string filledTemplate(std::string_view page, std::span<const TemplatePart> parts);

}  // namespace darwinop::text
