// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of segments from bytes, clipped in double and exactly.
#include "tests/fuzz/bytes.hpp"
#include "tests/reference/compare_clips.hpp"

#include <vector>

namespace orograph {

void fuzz_clip(FuzzBytes all) {
  Bytes bytes(all);
  FlatScene scene;
  std::vector<Role> roles;
  const int lists = bytes.whole(1, 6);
  for (int list = 0; list < lists; ++list) {
    roles.push_back(static_cast<Role>(bytes.whole(0, 2)));
    auto& segments = scene.emplace_back();
    double x = bytes.number(), y = bytes.number();
    const int count = bytes.whole(1, 6);
    for (int i = 0; i < count; ++i) {
      const double to_x = x + std::abs(bytes.number()), to_y = bytes.number();
      if (to_x > x && bytes.whole(0, 3) != 0)
        segments.push_back(
            {x, y, to_x, to_y,
             (static_cast<std::uint64_t>(list) << 32U) | static_cast<std::uint64_t>(i)});
      x = std::max(x, to_x);
      y = to_y;
    }
    if (segments.empty())
      segments.push_back({x, y, x + 1 + std::abs(x), y, static_cast<std::uint64_t>(list) << 32U});
  }
  const ClipDifferences differences = compare_clips(scene, roles);
  expect(differences.wrong == 0, differences.first_wrong);
}

} // namespace orograph
