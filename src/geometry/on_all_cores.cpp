// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/on_all_cores.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

namespace orograph {

void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& task) {
  // Another drawing's error must not cancel this one's tasks, all of which are counted on.
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::this_task_arena::isolate(
      [&] { tbb::parallel_for(std::size_t{0}, count, task, tbb::simple_partitioner(), own); });
}

} // namespace orograph
