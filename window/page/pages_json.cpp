// Lists playable motion pages as JSON.
#include "window/page/pages_json.hpp"

#include <nlohmann/json.hpp>

#include "core/json/json_text.hpp"

namespace darwinop::window {

std::string pagesJson(const motion::PageFile& pages) {
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t number = 1; number < pages.size(); ++number)
    if (pages[number].canPlay()) list.push_back({{"number", number}, {"name", std::string{pages[number].nameText()}}});
  return jsonText(list, -1, true);
}

}  // namespace darwinop::window
