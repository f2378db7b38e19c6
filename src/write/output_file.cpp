// SPDX-License-Identifier: GPL-3.0-or-later
// Temporary file, then rename: the only two steps that a file system does whole.
#include "write/output_file.hpp"

#include "geometry/error.hpp"
#include "write/byte_sink.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h> // renameat2
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>

namespace orograph {
namespace {

// Temporary files that a signal handler has to remove: a fixed table of paths, since it may neither
// allocate nor lock.
constexpr std::size_t kLongestPath = 4096;
constexpr std::size_t kLongestSuffix = 16;

enum class SlotState { free, filling, used };
static_assert(std::atomic<SlotState>::is_always_lock_free);

struct Slot {
  std::atomic<SlotState> state = SlotState::free;
  std::array<char, kLongestPath> path{};
};
std::array<Slot, 256> slots;

// Notes a file, by a path of less than 4096 bytes; up to 256 files at a time, from any thread.
// Returns its number, or nothing where there is no room.
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

// Forgets it again. By number: another's path may not be read, it may be forgotten and another
// noted meanwhile.
void forget_removal(std::size_t number) {
  slots[number].state = SlotState::free;
}

// Removes the file and what SQLite leaves beside it. Safe in signal handlers. The path may be gone
// already.
void remove_with_companions(const char* path) {
  std::array<char, kLongestPath + kLongestSuffix> name;
  const std::size_t length = std::strlen(path);
  std::memcpy(name.data(), path, length);
  for (const char* suffix : {"", "-journal", "-wal", "-shm"}) {
    std::memcpy(name.data() + length, suffix, std::strlen(suffix) + 1);
    ::unlink(name.data());
  }
}

namespace fs = std::filesystem;

Error exists_error(const std::string& path) {
  return {path + " exists already", "another name, or `overwrite`", ErrorCode::output};
}

// Renaming would replace a symbolic link by the file; what is meant is the file it points to.
std::string followed(const std::string& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path file = fs::weakly_canonical(path, error);
  if (error) throw write_error(path, error.value());
  return file.string();
}

void check_place(const std::string& path, bool overwrite) {
  if (!fs::path(path).has_filename())
    throw Error("'" + path + "' names no file", "the name of a file to write", ErrorCode::output);
  struct stat place {};
  if (::stat(path.c_str(), &place) != 0) {
    if (errno != ENOENT) throw write_error(path, errno);
    return;
  }
  if (!S_ISREG(place.st_mode))
    throw Error(path + " is not an ordinary file", "the name of a file to write",
                ErrorCode::output);
  if (!overwrite) throw exists_error(path);
  if (::access(path.c_str(), W_OK) != 0) throw write_error(path, errno);
}

// Process and counter tell it from those of other runs and threads; O_EXCL from any left over.
// With its number among the files to be removed: noted before it is there, since a signal may come
// to any thread at any time.
std::pair<std::string, std::size_t> create_temporary(const std::string& path) {
  static std::atomic<unsigned> counter = 0;
  const fs::path place(path);
  for (;;) {
    const std::string name =
        fmt::format(".orograph-{}-{}{}", ::getpid(), counter++, place.extension().string());
    std::string temporary = (place.parent_path() / name).string();
    const std::optional<std::size_t> number = note_for_removal(temporary);
    if (!number)
      throw Error(path + " is one output too many at a time, or its path is too long",
                  "up to 256 at a time, with paths under 4096 bytes", ErrorCode::output);
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) {
      ::close(descriptor);
      return {std::move(temporary), *number}; // a copy may fail, and would leave the file
    }
    const int error_number = errno;
    forget_removal(*number);
    if (error_number != EEXIST) throw write_error(path, error_number);
  }
}

void flush_to_disk(const std::string& temporary, const std::string& path) {
  const int descriptor = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw write_error(path, errno);
  const int error_number = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (error_number != 0) throw write_error(path, error_number);
}

// The new file is its owner's and readable as the old one was, as far as this process may give
// files away.
void take_over_rights(const std::string& temporary, const std::string& path) {
  struct stat old {};
  if (::stat(path.c_str(), &old) != 0) return;
  const bool given = ::chown(temporary.c_str(), old.st_uid, old.st_gid) == 0;
  // Its own group isn't to read what was another's.
  const mode_t rights = old.st_mode & (given ? 07777U : 0707U);
  if (::chmod(temporary.c_str(), rights) != 0) throw write_error(path, errno);
}

// Renames without replacing a file that has appeared meanwhile. 0 or an errno.
int rename_to_free_place(const char* temporary, const char* path) {
  if (::renameat2(AT_FDCWD, temporary, AT_FDCWD, path, RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  // A file system without that flag, such as NFS: a second name can't replace anything either.
  if (::link(temporary, path) != 0) return errno;
  ::unlink(temporary);
  return 0;
}

// Taken by whoever renames several files or removes all, so that neither comes into the other's
// midst. A signal handler may wait for it: who holds it has signals wait in his own thread.
std::atomic_flag names_change = ATOMIC_FLAG_INIT;

class NamesChange {
public:
  NamesChange() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    while (names_change.test_and_set()) ::sched_yield();
  }
  ~NamesChange() {
    names_change.clear();
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NamesChange(const NamesChange&) = delete;
  NamesChange& operator=(const NamesChange&) = delete;

private:
  sigset_t before_{};
};

} // namespace

OutputFile::OutputFile(const std::string& path, bool overwrite)
    : path_(followed(path)), overwrite_(overwrite) {
  check_place(path_, overwrite_);
  std::tie(temporary_path_, noted_) = create_temporary(path_);
}

OutputFile::~OutputFile() {
  if (!committed_) remove_with_companions(temporary_path_.c_str());
  forget_removal(noted_);
}

void OutputFile::flush() const {
  flush_to_disk(temporary_path_, path_);
  if (overwrite_) take_over_rights(temporary_path_, path_);
}

void OutputFile::rename_to_place() {
  const char *const from = temporary_path_.c_str(), *const to = path_.c_str();
  const int error_number = !overwrite_               ? rename_to_free_place(from, to)
                           : ::rename(from, to) == 0 ? 0
                                                     : errno;
  if (error_number == EEXIST) throw exists_error(path_);
  if (error_number != 0) throw write_error(path_, error_number);
  committed_ = true;
}

void OutputFile::commit() {
  flush();
  rename_to_place();
}

void commit_together(std::span<const std::unique_ptr<OutputFile>> files) {
  for (const auto& file : files) file->flush();
  const NamesChange change;
  for (const auto& file : files) file->rename_to_place();
}

void remove_temporary_files() noexcept {
  const NamesChange change;
  for (Slot& slot : slots)
    if (slot.state == SlotState::used) remove_with_companions(slot.path.data());
}

void write_text(const std::string& text, const std::string& path, bool overwrite) {
  OutputFile place(path, overwrite);
  ByteSink out(place.temporary_path(), path);
  out.append(text);
  out.finish();
  place.commit();
}

} // namespace orograph
