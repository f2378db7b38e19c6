// SPDX-License-Identifier: GPL-3.0-or-later
// Buffered writing without stdio, whose errors are easily lost.
#include "write/byte_sink.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

namespace orograph {
namespace {

constexpr std::size_t kBufferBytes = 1 << 16;

std::string what_would_be_right(int error_number) {
  switch (error_number) {
  case ENOSPC:
  case EDQUOT:
  case EFBIG:
    return "a disk with room for it";
  case EACCES:
  case EPERM:
  case EROFS:
    return "a folder that you may write to";
  case ENOENT:
  case ENOTDIR:
    return "a folder that exists";
  case ENAMETOOLONG:
    return "a shorter name";
  case EPIPE:
    return "a reader that takes all of it";
  default:
    return "a place that can be written to";
  }
}

} // namespace

Error write_error(const std::string& name, int error_number) {
  return {name + " can't be written (" + std::generic_category().message(error_number) + ")",
          what_would_be_right(error_number), ErrorCode::output};
}

ByteSink::ByteSink(int descriptor, std::string name)
    : descriptor_(descriptor), name_(std::move(name)) {
  waiting_.reserve(kBufferBytes);
}

ByteSink::ByteSink(const std::string& path, std::string name)
    : ByteSink(::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC), std::move(name)) {
  if (descriptor_ < 0) throw write_error(name_, errno);
}

ByteSink ByteSink::standard_output() {
  ByteSink sink(STDOUT_FILENO, "standard output");
  sink.owns_descriptor_ = false;
  return sink;
}

ByteSink ByteSink::into(std::string& text) {
  ByteSink sink(-1, "a text");
  sink.owns_descriptor_ = false;
  sink.text_ = &text;
  return sink;
}

ByteSink::ByteSink(ByteSink&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), owns_descriptor_(other.owns_descriptor_),
      text_(other.text_), error_number_(other.error_number_), name_(std::move(other.name_)),
      waiting_(std::move(other.waiting_)), written_(other.written_) {}

ByteSink::~ByteSink() {
  if (descriptor_ >= 0 && owns_descriptor_) ::close(descriptor_);
}

bool ByteSink::append(std::string_view bytes) noexcept {
  if (waiting_.size() + bytes.size() > kBufferBytes) {
    write_out(waiting_);
    waiting_.clear();
  }
  if (bytes.size() > kBufferBytes)
    write_out(bytes);
  else
    waiting_.append(bytes);
  return error_number_ == 0;
}

// The disk begins with what it has got while the rest is being made; otherwise all of it waits for
// the flush at the end. Where a file system can't, nothing is lost.
std::size_t ByteSink::begin_to_store(std::size_t written) noexcept {
  if (owns_descriptor_)
    ::sync_file_range(descriptor_, static_cast<off_t>(written_), static_cast<off_t>(written),
                      SYNC_FILE_RANGE_WRITE);
  written_ += written;
  return written;
}

void ByteSink::write_out(std::string_view bytes) noexcept {
  if (text_ != nullptr) {
    try {
      text_->append(bytes);
    } catch (const std::bad_alloc&) {
      error_number_ = ENOMEM;
    }
    return;
  }
  while (!bytes.empty() && error_number_ == 0) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(begin_to_store(static_cast<std::size_t>(written)));
    else if (errno != EINTR)
      error_number_ = errno;
  }
}

void ByteSink::finish() {
  write_out(waiting_);
  const int descriptor = std::exchange(descriptor_, -1);
  // Network file systems report a full disk only here.
  if (owns_descriptor_ && ::close(descriptor) != 0 && error_number_ == 0) error_number_ = errno;
  if (error_number_ != 0) throw write_error(name_, error_number_);
}

} // namespace orograph
