// SPDX-License-Identifier: GPL-3.0-or-later
// Text formats on standard output: the bytes of the file, and an error where they get lost.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/write_drawing.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

using namespace orograph;

namespace {

constexpr int kWritten = 10, kRefused = 11, kOtherwise = 12;

// Writes in a child process to `descriptor` as standard output; messages go to `said`.
int write_to(int descriptor, const Drawing& drawing, Format format, const std::string& said) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGPIPE, SIG_IGN); // as the command has it
    ::dup2(descriptor, STDOUT_FILENO);
    int code = kOtherwise;
    try {
      write_drawing(drawing, "-", {.format = format});
      code = kWritten;
    } catch (const Error& error) {
      fill_file(said, error.what());
      code = kRefused;
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

TEST_CASE("standard output takes what a file would hold, and tells when it doesn't") {
  const Drawing drawing = made_drawing();
  for (const Format format : {Format::svg, Format::ps, Format::eps, Format::geojson}) {
    const std::string name = format_names()[static_cast<std::size_t>(format)];
    INFO(name);
    REQUIRE(is_text(format));
    const TemporaryFolder folder;
    const std::string said = folder.file("said");

    const int file = ::open(folder.file("out").c_str(), O_CREAT | O_WRONLY, 0600);
    CHECK(write_to(file, drawing, format, said) == kWritten);
    ::close(file);
    write_drawing(drawing, folder.file("map"), {.format = format});
    const bool same = content_of(folder.file("out")) == content_of(folder.file("map"));
    CHECK(same);

    const int full = ::open("/dev/full", O_WRONLY);
    REQUIRE(full >= 0);
    CHECK(write_to(full, drawing, format, said) == kRefused);
    CHECK(content_of(said) == "standard output can't be written (No space left on device): "
                              "a disk with room for it");
    ::close(full);

    std::array<int, 2> pipe{};
    REQUIRE(::pipe(pipe.data()) == 0);
    ::close(pipe[0]);
    CHECK(write_to(pipe[1], drawing, format, said) == kRefused);
    CHECK(content_of(said) == "standard output can't be written (Broken pipe): "
                              "a reader that takes all of it");
    ::close(pipe[1]);
  }
}
