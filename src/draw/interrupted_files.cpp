// SPDX-License-Identifier: GPL-3.0-or-later
// A fixed table of paths, since a signal handler may neither allocate nor lock.
#include "draw/interrupted_files.hpp"

#include "draw/output_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>

namespace orograph {
namespace {

constexpr std::size_t kLongestPath = 4096;
constexpr std::size_t kLongestSuffix = 16;

enum class SlotState { free, filling, used };
static_assert(std::atomic<SlotState>::is_always_lock_free);

struct Slot {
  std::atomic<SlotState> state = SlotState::free;
  std::array<char, kLongestPath> path{};
};
std::array<Slot, 256> slots;

sigset_t interrupting_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

extern "C" void remove_all_and_exit(int signal_number) {
  for (Slot& slot : slots)
    if (slot.state == SlotState::used) remove_with_companions(slot.path.data());
  _exit(128 + signal_number);
}

} // namespace

SignalPause::SignalPause() {
  const sigset_t set = interrupting_signals();
  pthread_sigmask(SIG_BLOCK, &set, &before_);
}

SignalPause::~SignalPause() {
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

std::optional<std::size_t> note_for_removal(const std::string& path) {
  if (path.size() >= kLongestPath) return std::nullopt;
  for (Slot& slot : slots) {
    SlotState expected = SlotState::free;
    if (!slot.state.compare_exchange_strong(expected, SlotState::filling)) continue;
    *std::ranges::copy(path, slot.path.begin()).out = '\0';
    slot.state = SlotState::used;
    return static_cast<std::size_t>(&slot - slots.data());
  }
  return std::nullopt;
}

// By number: another's path may not be read, it may be forgotten and another noted meanwhile.
void forget_removal(std::size_t number) {
  slots[number].state = SlotState::free;
}

void remove_with_companions(const char* path) {
  std::array<char, kLongestPath + kLongestSuffix> name;
  const std::size_t length = std::strlen(path);
  std::memcpy(name.data(), path, length);
  for (const char* suffix : {"", "-journal", "-wal", "-shm"}) {
    std::memcpy(name.data() + length, suffix, std::strlen(suffix) + 1);
    ::unlink(name.data());
  }
}

void remove_output_files_on_signals() {
  struct sigaction action {};
  action.sa_handler = remove_all_and_exit;
  action.sa_mask = interrupting_signals();
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

} // namespace orograph
