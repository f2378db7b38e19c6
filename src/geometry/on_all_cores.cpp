// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/on_all_cores.hpp"

#include "geometry/error.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <string>
#include <utility>

// The thread sanitizer doesn't see what TBB, which isn't built with it, does between a loop's
// begin, its tasks and its end.
#ifdef __SANITIZE_THREAD__
extern "C" void __tsan_acquire(void* at);
extern "C" void __tsan_release(void* at);
#else
namespace {
void __tsan_acquire(void*) {}
void __tsan_release(void*) {}
} // namespace
#endif

namespace orograph {
namespace {

// Of the work that this thread is busy with; null where nobody can stop it.
thread_local const std::stop_token* current_stop = nullptr;

// Makes a token this thread's for as long as it lives.
class BusyWith {
public:
  explicit BusyWith(const std::stop_token* stop) : before_(current_stop) { current_stop = stop; }
  ~BusyWith() { current_stop = before_; }
  BusyWith(const BusyWith&) = delete;
  BusyWith& operator=(const BusyWith&) = delete;

private:
  const std::stop_token* before_;
};

} // namespace

void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& task) {
  const std::stop_token* const stop = current_stop;
  char begun = 0, ended = 0; // of which nothing but the address is used
  const auto stoppable = [&](std::size_t i) {
    __tsan_acquire(&begun);
    const BusyWith busy(stop);
    throw_if_stopped();
    task(i);
    __tsan_release(&ended);
  };
  __tsan_release(&begun);
  // Another drawing's error must not cancel this one's tasks, all of which are counted on.
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::this_task_arena::isolate(
      [&] { tbb::parallel_for(std::size_t{0}, count, stoppable, tbb::simple_partitioner(), own); });
  __tsan_acquire(&ended);
}

void on_cores(int jobs, const std::stop_token& stop, const std::function<void()>& work) {
  if (jobs < 0)
    throw Error(std::to_string(jobs) + " jobs", "1 or more, or 0 for one on each core",
                ErrorCode::request);
  const auto stoppable = [&] {
    const BusyWith busy(&stop);
    throw_if_stopped();
    work();
  };
  // Of more TBB would say on stderr that there are none.
  const auto most = static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  if (jobs == 0)
    stoppable();
  else
    tbb::task_arena(std::min(jobs, most)).execute(stoppable);
}

std::function<void()> stopped_with_caller(std::function<void()> work) {
  return [stop = current_stop, work = std::move(work)] {
    const BusyWith busy(stop);
    work();
  };
}

bool is_stopped() {
  return current_stop && current_stop->stop_requested();
}

void throw_if_stopped() {
  if (is_stopped()) throw Error("the work was stopped", "begin it again", ErrorCode::cancelled);
}

} // namespace orograph
