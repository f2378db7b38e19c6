// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/on_all_cores.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace orograph {

void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& task) {
  tbb::this_task_arena::isolate(
      [&] { tbb::parallel_for(std::size_t{0}, count, task, tbb::simple_partitioner()); });
}

} // namespace orograph
