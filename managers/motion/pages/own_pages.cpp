// The project's own motion pages.
#include "managers/motion/pages/own_pages.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "managers/motion_text/page_text.hpp"

namespace darwinop::motion {

PageFile mergeTexts(std::span<const OwnText> texts) {
  PageFile all;
  for (std::size_t i = 0; i < kPages; ++i) all.push_back(unmentionedPage(i));
  std::array<std::string_view, kPages> from{};  // which text has this page
  for (const OwnText& text : texts) {
    const PageFile pages = parsePages(text.text, std::string{text.name});
    for (std::size_t i = 0; i < kPages; ++i) {
      if (pages[i] == unmentionedPage(i)) continue;
      if (!from.at(i).empty())
        throw std::runtime_error("page " + std::to_string(i) + " is in " + std::string{from.at(i)} + " and in " +
                                 std::string{text.name} + ": give one of them another number");
      from.at(i) = text.name;
      all[i] = pages[i];
    }
  }
  return all;
}

const PageFile& ownPages() {
  static const PageFile pages = mergeTexts(ownTexts());
  return pages;
}

}  // namespace darwinop::motion
