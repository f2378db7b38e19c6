// SPDX-License-Identifier: GPL-3.0-or-later
// A library to be preloaded (LD_PRELOAD) that makes the Nth call of one kind fail, from the
// beginning of `main` on, in the first process alone. By the environment:
//   OROGRAPH_FAULT=KIND:N    the Nth fails; KIND:N+ all from the Nth on; KIND:0 none. Kinds: write,
//                            short (half is written or read), sync, rename, open, mkdir, read,
//                            memory, opened (there is no memory right behind the Nth open), thread
//   OROGRAPH_FAULT_COUNT=FD  how many calls of the kind there were is written there in the end
//   OROGRAPH_FAULT_TRACE=1   tells on stderr from where the call came that failed
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

// The program's calls find these in front of libc's.
#pragma GCC visibility push(default)

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
}

namespace {

enum class Kind { none, write, short_io, sync, rename, open, mkdir, read, memory, opened, thread };
constexpr struct {
  const char* name;
  Kind kind;
} kKinds[] = {{"write", Kind::write},   {"short", Kind::short_io}, {"sync", Kind::sync},
              {"rename", Kind::rename}, {"open", Kind::open},      {"mkdir", Kind::mkdir},
              {"read", Kind::read},     {"memory", Kind::memory},  {"opened", Kind::opened},
              {"thread", Kind::thread}};

std::atomic<Kind> asked = Kind::none; ///< none before `main` and after it
std::atomic<unsigned long> calls = 0;
unsigned long nth = 0;
bool all_from_nth = false, tells = false;
int count_to = -1, trace_to = -1;

bool fails(Kind kind) {
  if (asked.load(std::memory_order_relaxed) != kind) return false;
  const unsigned long call = ++calls;
  const bool failing = nth != 0 && (call == nth || (all_from_nth && call > nth));
  if (failing && tells) {
    tells = false;
    asked = Kind::none; // what tells may call as well
    void* frames[40];
    backtrace_symbols_fd(frames, backtrace(frames, 40), trace_to);
    asked = kind;
  }
  return failing;
}

std::atomic<bool> no_memory_now = false;

bool memory_fails() {
  return fails(Kind::memory) ||
         (no_memory_now.load(std::memory_order_relaxed) && no_memory_now.exchange(false));
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}
#define NEXT(name) static auto* const real = next<decltype(::name)>(#name)

int fail(int error_number) {
  errno = error_number;
  return -1;
}

constexpr int kErrorSeen = 0x20; ///< of a FILE of glibc's: what ferror tells

// At least one byte, so that it isn't an end of file.
size_t shortened(size_t size) {
  return size > 1 && fails(Kind::short_io) ? size / 2 : size;
}

int (*real_main)(int, char**, char**) = nullptr;

void begin() {
  const char* const fault = getenv("OROGRAPH_FAULT");
  if (fault == nullptr) return;
  const char* const colon = strchr(fault, ':');
  const char* const count = getenv("OROGRAPH_FAULT_COUNT");
  tells = getenv("OROGRAPH_FAULT_TRACE") != nullptr;
  if (tells) {
    trace_to = fcntl(2, F_DUPFD_CLOEXEC, 100); // the program keeps 2 from libraries
    void* frames[2];
    backtrace(frames, 2); // loads what it needs
  }
  Kind kind = Kind::none;
  for (const auto& [name, one] : kKinds)
    if (colon && strlen(name) == static_cast<size_t>(colon - fault) &&
        strncmp(name, fault, strlen(name)) == 0)
      kind = one;
  char* end = nullptr;
  if (colon) nth = strtoul(colon + 1, &end, 10);
  all_from_nth = end && *end == '+';
  if (count) count_to = atoi(count);
  for (const char* name : {"LD_PRELOAD", "OROGRAPH_FAULT", "OROGRAPH_FAULT_COUNT"}) unsetenv(name);
  asked = kind;
}

void end() {
  asked = Kind::none;
  if (count_to < 0) return;
  char text[24];
  const int size = snprintf(text, sizeof text, "%lu", calls.load());
  syscall(SYS_write, count_to, text, size);
}

int main_with_faults(int argc, char** argv, char** environment) {
  begin();
  const int code = real_main(argc, argv, environment);
  end();
  return code;
}

} // namespace

extern "C" {

void _Exit(int code) noexcept { // by which the command ends
  end();
  syscall(SYS_exit_group, code);
  __builtin_unreachable();
}

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(),
                      void (*fini)(), void (*rtld_fini)(), void* stack_end) {
  real_main = main;
  using Start =
      int(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(), void (*)(), void*);
  return next<Start>("__libc_start_main")(main_with_faults, argc, argv, init, fini, rtld_fini,
                                          stack_end);
}

ssize_t write(int file, const void* bytes, size_t size) {
  if (fails(Kind::write)) return fail(ENOSPC);
  NEXT(write);
  return real(file, bytes, shortened(size));
}
ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at) {
  if (fails(Kind::write)) return fail(ENOSPC);
  NEXT(pwrite64);
  return real(file, bytes, size, at);
}
ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) {
  if (fails(Kind::write)) return fail(ENOSPC);
  NEXT(pwrite);
  return real(file, bytes, size, at);
}
ssize_t writev(int file, const iovec* parts, int count) {
  if (fails(Kind::write)) return fail(ENOSPC);
  NEXT(writev);
  return real(file, parts, count);
}
size_t fwrite(const void* things, size_t size, size_t count, FILE* file) {
  if (fails(Kind::write)) {
    errno = ENOSPC;
    file->_flags |= kErrorSeen;
    return 0;
  }
  NEXT(fwrite);
  return real(things, size, count, file);
}

ssize_t read(int file, void* bytes, size_t size) {
  if (fails(Kind::read)) return fail(EIO);
  NEXT(read);
  return real(file, bytes, shortened(size));
}
ssize_t pread64(int file, void* bytes, size_t size, off64_t at) {
  if (fails(Kind::read)) return fail(EIO);
  NEXT(pread64);
  return real(file, bytes, size, at);
}
ssize_t pread(int file, void* bytes, size_t size, off_t at) {
  if (fails(Kind::read)) return fail(EIO);
  NEXT(pread);
  return real(file, bytes, size, at);
}
size_t fread(void* things, size_t size, size_t count, FILE* file) {
  if (fails(Kind::read)) {
    errno = EIO;
    file->_flags |= kErrorSeen;
    return 0;
  }
  NEXT(fread);
  return real(things, size, count, file);
}

int fsync(int file) {
  if (fails(Kind::sync)) return fail(EIO);
  NEXT(fsync);
  return real(file);
}
int fdatasync(int file) {
  if (fails(Kind::sync)) return fail(EIO);
  NEXT(fdatasync);
  return real(file);
}

int rename(const char* from, const char* to) {
  if (fails(Kind::rename)) return fail(EIO);
  NEXT(rename);
  return real(from, to);
}
int renameat2(int from_folder, const char* from, int to_folder, const char* to,
              unsigned flags) noexcept {
  if (fails(Kind::rename)) return fail(EIO);
  NEXT(renameat2);
  return real(from_folder, from, to_folder, to, flags);
}

#define OPENS(name)                                                                                \
  int name(const char* path, int flags, ...) {                                                     \
    va_list rest;                                                                                  \
    va_start(rest, flags);                                                                         \
    const mode_t mode = va_arg(rest, mode_t);                                                      \
    va_end(rest);                                                                                  \
    if (fails(Kind::open)) return fail(EMFILE);                                                    \
    NEXT(name);                                                                                    \
    const int file = real(path, flags, mode);                                                      \
    if (fails(Kind::opened)) no_memory_now = true;                                                 \
    return file;                                                                                   \
  }
OPENS(open)
OPENS(open64)
FILE* fopen(const char* path, const char* mode) {
  if (fails(Kind::open)) {
    errno = EMFILE;
    return nullptr;
  }
  NEXT(fopen);
  FILE* const file = real(path, mode);
  if (fails(Kind::opened)) no_memory_now = true;
  return file;
}
FILE* fopen64(const char* path, const char* mode) {
  if (fails(Kind::open)) {
    errno = EMFILE;
    return nullptr;
  }
  NEXT(fopen64);
  FILE* const file = real(path, mode);
  if (fails(Kind::opened)) no_memory_now = true;
  return file;
}

int mkdir(const char* path, mode_t mode) noexcept {
  if (fails(Kind::mkdir)) return fail(ENOSPC);
  NEXT(mkdir);
  return real(path, mode);
}

void* malloc(size_t size) noexcept {
  if (memory_fails()) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_malloc(size);
}
void* calloc(size_t count, size_t size) noexcept {
  if (memory_fails()) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_calloc(count, size);
}
void* realloc(void* old, size_t size) noexcept {
  if (memory_fails()) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_realloc(old, size);
}
int posix_memalign(void** out, size_t alignment, size_t size) noexcept {
  if (memory_fails()) return ENOMEM;
  *out = __libc_memalign(alignment, size);
  return *out ? 0 : ENOMEM;
}
void* aligned_alloc(size_t alignment, size_t size) noexcept {
  if (memory_fails()) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_memalign(alignment, size);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                   void* argument) noexcept {
  if (fails(Kind::thread)) return EAGAIN;
  NEXT(pthread_create);
  return real(thread, attributes, run, argument);
}
}
