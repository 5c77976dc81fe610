// Common options of commands that render the twin: model, viewpoint, size.
#include "twin_look.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

#include "twin/render/offscreen.hpp"

namespace {

namespace twin = darwinop::twin;

constexpr const char* kModelHelp = "Name of an included model ('darwinop twin models'), or an INI file";

std::map<std::string, twin::Viewpoint> viewpoints() {
  std::map<std::string, twin::Viewpoint> table;
  for (std::size_t i = 0; i < twin::kViewpoints.size(); ++i)
    table[std::string{twin::kViewpoints.at(i)}] = static_cast<twin::Viewpoint>(i);
  return table;
}

/// "640x480"
std::string readSize(const std::string& text, int& width, int& height) {
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2 &&
      std::min(width, height) >= twin::Offscreen::kSmallest && std::max(width, height) <= twin::Offscreen::kLargest)
    return {};
  return "'" + text + "' is not a size: expected WIDTHxHEIGHT in pixels, " +
         std::to_string(twin::Offscreen::kSmallest) + " to " + std::to_string(twin::Offscreen::kLargest) +
         " each, as in 640x480";
}

}  // namespace

void describeLook(CLI::App& command, twin::ShowOptions& show) {
  command.add_option("--model", show.model, kModelHelp)->capture_default_str();
  std::string names;
  for (const std::string_view name : twin::kViewpoints) names += (names.empty() ? "" : ", ") + std::string{name};
  command
      .add_option_function<std::string>(
          "--camera", [&show](const std::string& name) { show.from = viewpoints().at(name); }, "Viewpoint: " + names)
      ->type_name("NAME")
      ->default_str("follow")
      ->check(CLI::IsMember(viewpoints()));
  const std::string usual = std::to_string(show.width) + "x" + std::to_string(show.height);
  command
      .add_option_function<std::string>(
          "--size",
          [&show](const std::string& text) {
            const std::string wrong = readSize(text, show.width, show.height);
            if (!wrong.empty()) throw CLI::ValidationError("--size", wrong);
          },
          "Size in pixels, for example 640x480")
      ->type_name("WxH")
      ->default_str(usual);
}
