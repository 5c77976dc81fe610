// Reads and writes one value of the key table.
#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "core/text/letter_case.hpp"
#include "core/text/nearest.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::twin {
namespace {

// Characters; an INI line may have 200.
constexpr std::size_t kLongestText = 120;

template <class T>
constexpr bool kIsWord = std::is_enum_v<T> || std::is_same_v<T, bool>;

/// `text`: without comment and enclosing quotes.
std::string readText(std::string_view text, const KeyRow& row) {
  const auto odd = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '"'; };
  if (text.empty() || text.size() > kLongestText || std::ranges::any_of(text, odd) || text.front() == ' ' ||
      text.back() == ' ')
    throw std::runtime_error("give " + allowed(row));
  return std::string{text};
}

template <class T>
void readInto(T& value, const KeyRow& row, std::string_view text) {
  if constexpr (std::is_same_v<T, double>) {
    value = readNumber(text, row.number);
  } else if constexpr (kIsWord<T>) {
    const auto found = std::ranges::find(row.words, text::lowered(text));
    if (found == row.words.end()) throw std::runtime_error("give " + allowed(row));
    value = static_cast<T>(found - row.words.begin());
  } else if constexpr (std::is_same_v<T, std::string>) {
    value = readText(text, row);
  } else {
    value = readAxes(text, row.number);
  }
}

template <class T>
std::string written(const T& value, const KeyRow& row) {
  if constexpr (std::is_same_v<T, double>)
    return writeNumber(value, row.number);
  else if constexpr (kIsWord<T>)
    return std::string{row.words[static_cast<std::size_t>(value)]};
  else if constexpr (std::is_same_v<T, std::string>)
    return value;
  else
    return writeAxes(value, row.number);
}

}  // namespace

void readValue(Model& model, const KeyRow& row, std::string_view text) {
  std::visit([&](auto* value) { readInto(*value, row, text); }, row.in(model));
}

std::string writeValue(const Model& model, const KeyRow& row) {
  Model copy = model;  // row.in() needs a mutable model
  return std::visit([&](const auto* value) { return written(*value, row); }, row.in(copy));
}

std::string allowed(const KeyRow& row) {
  if (!row.words.empty()) return text::listed(row.words, "or");
  Model dummy;
  const Slot slot = row.in(dummy);
  if (std::holds_alternative<std::string*>(slot))
    return "a text of 1 to " + std::to_string(kLongestText) + " characters without quotes, ; and #";
  const std::string range = allowed(row.number);
  return std::holds_alternative<double*>(slot) ? range : "three times " + range;
}

std::string keysAsMarkdown() {
  std::string text;
  const Model defaults;
  std::vector<std::string_view> sections(plainSections().begin(), plainSections().end());
  sections.push_back(linkSection(kTrunkLink));
  for (const std::string_view section : sections) {
    const bool is_link = section == sections.back();
    text += (text.empty() ? "### [" : "\n### [") +
            (is_link ? std::string{kLinkSection} + " NAME" : std::string{section}) + "]\n\n";
    for (const KeyRow& row : keyTable()) {
      if (row.section != section) continue;
      const std::string value = writeValue(defaults, row);
      text += "- `" + std::string{row.key} + (value.empty() ? "`, required" : " = " + value + "`") + " (" +
              allowed(row) + "): " + std::string{row.meaning} + "\n";
    }
  }
  return text;
}

}  // namespace darwinop::twin
