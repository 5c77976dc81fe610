#include "gap/report/html.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/json/json_text.hpp"

namespace darwinop::gap::html {
namespace {

/// Valid UTF-8: what JSON's writer makes of it.
std::string repaired(std::string_view raw) {
  const std::string quoted = jsonText(nlohmann::json(raw));
  return nlohmann::json::parse(quoted).get<std::string>();
}

}  // namespace

std::string text(std::string_view raw) {
  std::string out;
  for (const char c : repaired(raw)) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) < ' ' && c != '\n')
      out += ' ';
    else
      out += c;
  }
  return out;
}

std::string inScript(std::string json) {
  for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at))
    json.replace(at, 1, "\\u003c");
  return json;
}

std::string element(std::string_view tag, std::string_view raw) {
  return wrap(tag, text(raw));
}

std::string wrap(std::string_view tag, std::string_view html, std::string_view attributes) {
  return "<" + std::string{tag} + std::string{attributes} + ">" + std::string{html} + "</" + std::string{tag} + ">";
}

std::string number(double exact, const std::string& shown) {
  if (!std::isfinite(exact)) return "–";
  return wrap("data", text(shown), " value=\"" + nlohmann::json(exact).dump() + "\"");
}

}  // namespace darwinop::gap::html
