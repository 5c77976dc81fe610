// Escapes texts of logs for HTML.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::gap::html {

/// Between tags, or in an attribute in double quotes. Control characters become spaces, broken UTF-8 question marks.
std::string text(std::string_view raw);
/// JSON, such that nothing in it ends the <script> that it stands in.
std::string inScript(std::string json);

/// <tag>text</tag>
std::string element(std::string_view tag, std::string_view raw);
/// The same around what is HTML already; `attributes` begin with a blank, or are empty.
std::string wrap(std::string_view tag, std::string_view html, std::string_view attributes = {});

/// `shown`, and the number that programs read: as report.json has it. NaN: a dash.
std::string number(double exact, const std::string& shown);

}  // namespace darwinop::gap::html
