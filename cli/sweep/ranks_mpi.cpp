// SPDX-License-Identifier: GPL-3.0-or-later
// Built with MPI: rank 0 hands out the views, and draws as well.
#include "cli/sweep/ranks.hpp"
#include "geometry/error.hpp"

#include <mpi.h>

#include <chrono>
#include <cstdint>
#include <mutex>
#include <thread>

namespace orograph {
namespace {

// Open MPI waits by asking without a pause, which would take a core from those who draw.
constexpr std::chrono::milliseconds kPause{1};

constexpr int kToFirst = 1, kFromFirst = 2; // tags
constexpr std::int64_t kAsk = 0, kStop = 1, kEnd = 2;
constexpr std::int64_t kNone = -1;

bool has_message(int from, int tag, MPI_Status& status) {
  int there = 0;
  MPI_Iprobe(from, tag, MPI_COMM_WORLD, &there, &status);
  return there != 0;
}

std::int64_t receive(int from, int tag) {
  MPI_Status status;
  while (!has_message(from, tag, status)) std::this_thread::sleep_for(kPause);
  std::int64_t message = 0;
  MPI_Recv(&message, 1, MPI_INT64_T, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

void send(std::int64_t message, int to, int tag) {
  MPI_Send(&message, 1, MPI_INT64_T, to, tag, MPI_COMM_WORLD);
}

// Asks rank 0. One thread at a time, as MPI was told.
class AskingQueue : public ViewQueue {
public:
  std::optional<std::size_t> next() override {
    const std::lock_guard lock(mutex_);
    send(kAsk, 0, kToFirst);
    const std::int64_t view = receive(0, kFromFirst);
    return view == kNone ? std::nullopt : std::optional(static_cast<std::size_t>(view));
  }
  void stop() override {
    const std::lock_guard lock(mutex_);
    send(kStop, 0, kToFirst);
  }

private:
  std::mutex mutex_;
};

// Until all other ranks have ended.
void serve(ViewQueue& queue, int ranks) {
  for (int working = ranks - 1; working > 0;) {
    MPI_Status status;
    if (!has_message(MPI_ANY_SOURCE, kToFirst, status)) {
      std::this_thread::sleep_for(kPause);
      continue;
    }
    const std::int64_t message = receive(status.MPI_SOURCE, kToFirst);
    if (message == kAsk) {
      const auto view = queue.next();
      send(view ? static_cast<std::int64_t>(*view) : kNone, status.MPI_SOURCE, kFromFirst);
    } else if (message == kStop) {
      queue.stop();
    } else {
      --working;
    }
  }
}

} // namespace

Ranks::Ranks() {
  if (launched_size() <= 1) return; // not under mpirun: MPI isn't started, which takes its time
  int provided = 0;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided) != MPI_SUCCESS ||
      provided < MPI_THREAD_SERIALIZED)
    throw Error("MPI can't be started with threads", "part the views with --shard I/N instead");
  owns_mpi_ = true;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() {
  if (owns_mpi_) MPI_Finalize();
}

int Ranks::first_failed(bool failed) const {
  if (!owns_mpi_) return failed ? rank_ : -1;
  const int mine = failed ? rank_ : size_;
  int first = size_;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return first < size_ ? first : -1;
}

void Ranks::share(const std::vector<std::size_t>& views,
                  const std::function<void(ViewQueue&)>& work) {
  if (rank_ > 0) {
    AskingQueue queue;
    std::exception_ptr error;
    try {
      work(queue);
    } catch (...) {
      error = std::current_exception();
    }
    send(kEnd, 0, kToFirst);
    if (error) std::rethrow_exception(error);
    return;
  }
  LocalQueue queue(views);
  std::exception_ptr error;
  std::thread drawing([&] {
    try {
      work(queue);
    } catch (...) {
      error = std::current_exception();
    }
  });
  serve(queue, size_);
  drawing.join();
  if (error) std::rethrow_exception(error);
}

} // namespace orograph
