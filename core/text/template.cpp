#include "core/text/template.hpp"

#include <stdexcept>

namespace darwinop::text {

std::string filledTemplate(std::string_view page, std::span<const TemplatePart> parts) {
  std::string filled;
  for (const auto& [place, text] : parts) {
    const std::size_t at = page.find(place);
    if (at == std::string_view::npos) throw std::logic_error("the template has no " + std::string{place});
    filled.append(page.substr(0, at)).append(text);
    page.remove_prefix(at + place.size());
  }
  return filled.append(page);
}

}  // namespace darwinop::text
