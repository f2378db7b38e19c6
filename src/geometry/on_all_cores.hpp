// SPDX-License-Identifier: GPL-3.0-or-later
// Work on all cores, and work that can be stopped.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace orograph {

/// Calls `task` with 0 to count - 1, each once, on the threads that the caller's arena has, and
/// returns when all are done, whatever becomes of others around it. While it waits the caller's
/// thread takes nothing but these tasks, so that another drawing's isn't begun in the midst of this
/// one's. Rethrows what a task throws. Before each task it looks whether the work that it is a part
/// of is to be stopped, as `throw_if_stopped` does.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& task);

/// Runs `work` on at most `jobs` threads, and no more than there are cores; 0: on as many as the
/// caller's arena has, which are all cores unless someone said otherwise. Once `stop` is requested,
/// the work ends as soon as it comes to a task of `on_all_cores` or to `throw_if_stopped`. Throws
/// Error where `jobs` is below 0.
void on_cores(int jobs, const std::stop_token& stop, const std::function<void()>& work);

/// Throws Error with ErrorCode::cancelled where the work that the caller is a part of is to be
/// stopped. For loops that run long without `on_all_cores`; costs some nanoseconds.
void throw_if_stopped();

/// The same at one of 4096 steps of a loop that does little in each.
inline void throw_if_stopped(std::size_t step) {
  if (step % 4096 == 0) throw_if_stopped();
}

/// Whether that work is to be stopped, for callbacks that mustn't throw.
bool is_stopped();

/// `<` for the sorting and merging of long lists by std's algorithms: at one of 4096 comparisons it
/// does as `throw_if_stopped` does, and leaves the list in any order. REQUIRES that the counter,
/// of comparisons, outlives it.
class StoppableLess {
public:
  explicit StoppableLess(std::size_t& steps) : steps_(&steps) {}

  template <class Thing>
  bool operator()(const Thing& a, const Thing& b) const {
    throw_if_stopped((*steps_)++);
    return a < b;
  }

private:
  std::size_t* steps_;
};

/// `work`, which is stopped with what the caller is a part of, whichever thread runs it. REQUIRES
/// that the caller's work lasts longer.
std::function<void()> stopped_with_caller(std::function<void()> work);

} // namespace orograph
