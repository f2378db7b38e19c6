// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace orograph {

/// Calls `task` with 0 to count - 1, each once, on the threads that the caller's arena has, and
/// returns when all are done, whatever becomes of others around it. While it waits the caller's
/// thread takes nothing but these tasks, so that another drawing's isn't begun in the midst of this
/// one's. Rethrows what a task throws.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& task);

} // namespace orograph
