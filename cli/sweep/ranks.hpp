// SPDX-License-Identifier: GPL-3.0-or-later
// The processes that draw one sweep together under MPI, or this one alone.
#pragma once

#include "cli/sweep/view_queue.hpp"

#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <vector>

namespace orograph {

/// Another process failed, and tells of it.
class StoppedElsewhere : public std::exception {
public:
  const char* what() const noexcept override { return "another process of the sweep failed"; }
};

/// Only one at a time, and all calls from the thread that made it. Built without MPI
/// (OROGRAPH_MPI=OFF) there is one process, and starting several throws Error.
class Ranks {
public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }

  /// Runs a stage in all processes. Where it fails in some, it ends in all: the first of these
  /// throws what it threw, all others throw StoppedElsewhere.
  template <class Stage>
  auto together(const Stage& stage) {
    std::optional<decltype(stage())> result;
    std::exception_ptr error;
    try {
      result.emplace(stage());
    } catch (...) {
      error = std::current_exception();
    }
    const int failed = first_failed(error != nullptr);
    if (failed == rank_) std::rethrow_exception(error);
    if (failed >= 0) throw StoppedElsewhere();
    return std::move(*result);
  }

  /// Calls `work` in all processes, each with a queue; rank 0 hands out `views`, which are of no
  /// matter in the others. Throws what `work` throws, after all others have ended theirs.
  void share(const std::vector<std::size_t>& views, const std::function<void(ViewQueue&)>& work);

private:
  int first_failed(bool failed) const; ///< rank, or -1

  int rank_ = 0, size_ = 1;
  bool owns_mpi_ = false;
};

} // namespace orograph
