// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/say.hpp"

#include "text/printable.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace orograph {
namespace {

// Longer than any message of our own; what makes one longer is a name or a value of the user's.
constexpr std::size_t kLongestLine = 1000;

std::FILE* stream_of_notes = stderr;

} // namespace

void keep_stderr_from_libraries() {
  const int kept = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  std::FILE* const stream = kept < 0 ? nullptr : ::fdopen(kept, "w");
  const int nowhere = stream ? ::open("/dev/null", O_WRONLY | O_CLOEXEC) : -1;
  if (nowhere < 0) return;
  std::setvbuf(stream, nullptr, _IONBF, 0);
  stream_of_notes = stream;
  ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

std::FILE* told_stream() {
  return stream_of_notes;
}

void say_line(std::string_view text) {
  const std::string line = "orograph: " + shortened(printable(text), kLongestLine) + "\n";
  std::fwrite(line.data(), 1, line.size(), stream_of_notes);
}

void say_without_memory(std::string_view text) noexcept {
  for (const std::string_view part : {std::string_view("orograph: "), text, std::string_view("\n")})
    if (::write(::fileno(stream_of_notes), part.data(), part.size()) < 0) return;
}

} // namespace orograph
