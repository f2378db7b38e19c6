// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a straight line, as shares of the way along it.
#pragma once

#include <algorithm>
#include <vector>

namespace orograph {

/// From `begin` to `end`, 0 at the line's first end and 1 at its last.
struct Share {
  double begin, end;
};

/// Brings shares in order and puts together what overlaps or meets. What is no longer than `sliver`
/// is dropped, and gaps that are no wider are closed.
inline void unite(std::vector<Share>& shares, double sliver) {
  std::sort(shares.begin(), shares.end(),
            [](const Share& a, const Share& b) { return a.begin < b.begin; });
  std::size_t count = 0;
  for (const Share& share : shares) {
    if (count > 0 && shares[count - 1].end >= share.begin - sliver)
      shares[count - 1].end = std::max(shares[count - 1].end, share.end);
    else
      shares[count++] = share;
  }
  shares.resize(count);
  std::erase_if(shares, [&](const Share& s) { return s.end - s.begin <= sliver; });
}

/// Calls `take` with every part of [begin, end] that is in none of the shares and longer than
/// `sliver`. REQUIRES that they are united.
template <class Take>
void for_each_rest(const std::vector<Share>& shares, double begin, double end, double sliver,
                   const Take& take) {
  for (const Share& share : shares) {
    if (std::min(share.begin, end) - begin > sliver) take(Share{begin, std::min(share.begin, end)});
    begin = std::max(begin, share.end);
  }
  if (end - begin > sliver) take(Share{begin, end});
}

} // namespace orograph
