// SPDX-License-Identifier: GPL-3.0-or-later
// A file appears whole or not at all.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/output_file.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>

using namespace orograph;

namespace {

extern "C" void remove_and_exit(int signal_number) {
  remove_temporary_files();
  ::_exit(128 + signal_number);
}

} // namespace

TEST_CASE("the temporary file lies beside its place, with its extension") {
  const TemporaryFolder folder;
  const OutputFile file(folder.file("map.svg"), false);
  const std::filesystem::path temporary = file.temporary_path();
  CHECK(temporary.parent_path().string() + "/" == folder.file(""));
  CHECK(temporary.extension() == ".svg");
  CHECK(std::filesystem::exists(temporary));
  CHECK_FALSE(std::filesystem::exists(folder.file("map.svg")));
  const OutputFile other(folder.file("map.svg"), false);
  CHECK(other.temporary_path() != file.temporary_path());
}

TEST_CASE("a file not committed goes, with what SQLite left") {
  const TemporaryFolder folder;
  {
    const OutputFile file(folder.file("map.gpkg"), false);
    for (const char* suffix : {"-journal", "-wal", "-shm"})
      fill_file(file.temporary_path() + suffix, "x");
  }
  CHECK(folder.names().empty());
}

TEST_CASE("a committed file is in its place alone") {
  const TemporaryFolder folder;
  for (const bool overwrite : {false, true}) {
    OutputFile file(folder.file("map.svg"), overwrite);
    fill_file(file.temporary_path(), overwrite ? "second" : "first");
    file.commit();
    CHECK(content_of(folder.file("map.svg")) == (overwrite ? "second" : "first"));
  }
  CHECK(folder.names() == std::vector<std::string>{"map.svg"});
}

TEST_CASE("a file that has appeared meanwhile is not lost") {
  const TemporaryFolder folder;
  {
    OutputFile file(folder.file("map.svg"), false);
    fill_file(folder.file("map.svg"), "of somebody else");
    CHECK_THROWS_AS(file.commit(), Error);
  }
  CHECK(content_of(folder.file("map.svg")) == "of somebody else");
  CHECK(folder.names() == std::vector<std::string>{"map.svg"});
}

TEST_CASE("a symbolic link stays, its file is replaced") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("elsewhere"));
  fill_file(folder.file("elsewhere/real.svg"), "old");
  std::filesystem::create_symlink("elsewhere/real.svg", folder.file("map.svg"));
  OutputFile file(folder.file("map.svg"), true);
  fill_file(file.temporary_path(), "new");
  file.commit();
  CHECK(std::filesystem::is_symlink(folder.file("map.svg")));
  CHECK(content_of(folder.file("elsewhere/real.svg")) == "new");
}

TEST_CASE("temporary files can be removed in a signal handler") {
  for (const int signal_number : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    std::array<int, 2> ready{};
    REQUIRE(::pipe(ready.data()) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
      std::signal(signal_number, remove_and_exit);
      const OutputFile first(folder.file("map.gpkg"), false), second(folder.file("b.svg"), false);
      OutputFile done(folder.file("done.svg"), false);
      done.commit();
      fill_file(first.temporary_path() + "-journal", "x");
      if (::write(ready[1], "!", 1) != 1) ::_exit(1);
      for (;;) ::pause();
    }
    char byte = 0;
    REQUIRE(::read(ready[0], &byte, 1) == 1);
    CHECK(folder.names().size() == 4);
    REQUIRE(::kill(child, signal_number) == 0);
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 128 + signal_number);
    CHECK(folder.names() == std::vector<std::string>{"done.svg"});
    ::close(ready[0]);
    ::close(ready[1]);
  }
}
