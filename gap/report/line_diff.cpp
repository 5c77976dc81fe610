#include "gap/report/line_diff.hpp"

#include <algorithm>

namespace darwinop::gap {
namespace {

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    if (lines.back().ends_with('\r')) lines.back().pop_back();
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// By the longest common subsequence; model files have some hundred lines.
std::vector<DiffLine> wholeDiff(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::vector<std::vector<std::size_t>> common(a.size() + 1, std::vector<std::size_t>(b.size() + 1, 0));
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      common[i][j] = a[i] == b[j] ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
  std::vector<DiffLine> lines;
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j])
      lines.push_back({' ', a[i]}), ++i, ++j;
    else if (i < a.size() && (j == b.size() || common[i + 1][j] >= common[i][j + 1]))
      lines.push_back({'-', a[i++]});
    else
      lines.push_back({'+', b[j++]});
  }
  return lines;
}

}  // namespace

std::vector<DiffLine> lineDiff(std::string_view before, std::string_view after, std::size_t context) {
  const std::vector<DiffLine> whole = wholeDiff(linesOf(before), linesOf(after));
  std::vector<bool> shown(whole.size(), false);
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (whole[i].kind != ' ')
      for (std::size_t near = i - std::min(i, context); near <= std::min(i + context, whole.size() - 1); ++near)
        shown[near] = true;
  std::vector<DiffLine> lines;
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (shown[i])
      lines.push_back(whole[i]);
    else if (i > 0 && shown[i - 1])
      lines.push_back({'@', ""});
  if (!lines.empty() && lines.back().kind == '@') lines.pop_back();
  return lines;
}

}  // namespace darwinop::gap
