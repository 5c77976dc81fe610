// Levenshtein distance to a list of known words.
#include "core/text/nearest.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/text/letter_case.hpp"

namespace darwinop::text {
namespace {

std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t kLongest = 40;  // characters; bounds the run time
  if (word.size() > kLongest) return std::nullopt;
  const std::string low = lowered(word);
  std::optional<std::string_view> best;
  std::size_t min_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string_view candidate : known) {
    const std::size_t edits = distance(low, lowered(candidate));
    if (edits >= min_distance || edits >= candidate.size()) continue;
    min_distance = edits;
    best = candidate;
  }
  return best;
}

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
  if (const auto near = nearest(word, known)) return "did you mean " + std::string{*near} + "?";
  return "there are " + listed(known);
}

std::string listed(std::span<const std::string_view> words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 < words.size() ? std::string{", "} : " " + std::string{last} + " ";
    text += words[i];
  }
  return text;
}

}  // namespace darwinop::text
