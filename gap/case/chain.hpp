// The longest series of readings that one body can have passed through.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace darwinop::gap {

/// Rows outside the longest chain of rows in which each can follow the one before: can(i, j), i < j. `rows`: those that
/// have a reading, rising. Chains skip at most kLongestSkip rows at once; a series without faults takes linear time.
template <class Can>
std::vector<std::size_t> outsideLongestChain(const std::vector<std::size_t>& rows, const Can& can) {
  constexpr std::size_t kLongestSkip = 64;
  const std::size_t n = rows.size();
  std::vector<std::size_t> length(n, 1), greatest(n, 1), before(n);
  for (std::size_t j = 0; j < n; ++j) {
    before[j] = j;
    for (std::size_t i = j; i-- > 0 && j - i <= kLongestSkip;) {
      if (length[i] + 1 > length[j] && can(rows[i], rows[j])) length[j] = length[i] + 1, before[j] = i;
      if (i > 0 && length[j] > greatest[i - 1]) break;  // no row before gives more
    }
    greatest[j] = j == 0 ? length[j] : std::max(greatest[j - 1], length[j]);
  }
  std::vector<std::size_t> outside;
  if (n == 0) return outside;
  std::size_t next = static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  std::vector<bool> inside(n, false);
  for (inside[next] = true; before[next] != next; inside[next] = true) next = before[next];
  for (std::size_t j = 0; j < n; ++j)
    if (!inside[j]) outside.push_back(rows[j]);
  return outside;
}

}  // namespace darwinop::gap
