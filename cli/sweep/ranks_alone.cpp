// SPDX-License-Identifier: GPL-3.0-or-later
// Built without MPI.
#include "cli/sweep/ranks.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

namespace orograph {

Ranks::Ranks() {
  if (launched_size() > 1 && launched_rank() > 0) throw StoppedElsewhere(); // the first tells
  if (launched_size() > 1)
    throw Error(fmt::format("{} processes were started, and this build has no MPI: each would draw "
                            "all views",
                            launched_size()),
                "build with -DOROGRAPH_MPI=ON, or part the views with --shard I/N");
}

Ranks::~Ranks() = default;

int Ranks::first_failed(bool failed) const {
  return failed ? rank_ : -1;
}

void Ranks::share(const std::vector<std::size_t>& views,
                  const std::function<void(ViewQueue&)>& work) {
  LocalQueue queue(views);
  work(queue);
}

} // namespace orograph
