// SPDX-License-Identifier: GPL-3.0-or-later
// The walks over a mesh that make one profile.
#pragma once

#include "profiles/profile.hpp"

#include <cstddef>
#include <vector>

namespace orograph {

/// One walk's vertices, [begin, end) of those found.
struct Run {
  std::size_t begin, end;
  double u_first, u_last;
  bool along; ///< a border edge in the plane, with nothing in front of it
};

/// Takes away border edges in the plane that lie where there is ground in front of it as well: a
/// wall is missing between the two.
void keep_ground_in_front(std::vector<Run>& runs);

/// The runs of `from`, in order and joined where one ends at the vertex at which the next begins.
void put_in_order(const Profile& from, std::vector<Run>& runs, Profile& out);

} // namespace orograph
