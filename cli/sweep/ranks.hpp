// SPDX-License-Identifier: GPL-3.0-or-later
// The processes that draw one sweep together under MPI, or this one alone.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <functional>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

namespace orograph {

// What mpirun tells a process before MPI is there to be asked.
inline int launcher_number(const char* open_mpi, const char* pmi, int alone) {
  for (const char* name : {open_mpi, pmi})
    if (const char* text = std::getenv(name)) return std::atoi(text);
  return alone;
}

/// Processes started together, 1 where nothing started them; and which of them this one is.
inline int launched_size() {
  return launcher_number("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", 1);
}
inline int launched_rank() {
  return launcher_number("OMPI_COMM_WORLD_RANK", "PMI_RANK", 0);
}

/// Hands out each view once, to any thread.
class ViewQueue {
public:
  virtual ~ViewQueue() = default;
  /// None where all are handed out, or `stop` was called.
  virtual std::optional<std::size_t> next() = 0;
  /// No more are handed out, to anybody.
  virtual void stop() = 0;
};

/// Of this process alone.
class LocalQueue : public ViewQueue {
public:
  explicit LocalQueue(std::vector<std::size_t> views) : views_(std::move(views)) {}

  std::optional<std::size_t> next() override {
    const std::size_t i = next_.fetch_add(1);
    return i < views_.size() ? std::optional(views_[i]) : std::nullopt;
  }
  void stop() override { next_ = views_.size(); }

private:
  const std::vector<std::size_t> views_;
  std::atomic<std::size_t> next_ = 0;
};

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
  [[maybe_unused]] bool owns_mpi_ = false; // never where there is no MPI
};

} // namespace orograph
