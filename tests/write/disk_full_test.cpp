// SPDX-License-Identifier: GPL-3.0-or-later
// A disk that fills up, played by a limit on the size of files, at many places of each format.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/output_file.hpp"
#include "write/write_drawing.hpp"

#include <sys/resource.h>

#include <csignal>
#include <filesystem>

using namespace orograph;

namespace {

class FileSizeLimit {
public:
  explicit FileSizeLimit(std::uintmax_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{static_cast<rlim_t>(bytes), before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
  rlimit before_{};
  void (*handler_)(int);
};

// The message, or "none" where it was written.
std::string write_within(std::uintmax_t bytes, const Drawing& drawing, const std::string& path,
                         const WriteOptions& options) {
  const FileSizeLimit limit(bytes);
  try {
    write_drawing(drawing, path, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

} // namespace

TEST_CASE("a full disk is an error in every format, and nothing is left") {
  const Drawing drawing = made_drawing(100, 100);
  for (const std::string& name : format_names()) {
    INFO(name);
    const TemporaryFolder folder;
    const std::string path = folder.file("map." + name);
    const WriteOptions options{.format = format_of_name(name), .dpi = 100};
    write_drawing(drawing, path, options);
    const std::uintmax_t whole = std::filesystem::file_size(path);
    std::filesystem::remove(path);
    for (const std::uintmax_t bytes : {std::uintmax_t{0}, std::uintmax_t{1}, std::uintmax_t{4096},
                                       whole / 4, whole / 2, whole - 5000, whole - 2, whole - 1}) {
      INFO(bytes << " of " << whole);
      const std::string message = write_within(bytes, drawing, path, options);
      CHECK(message.find(path + " can't be written") == 0);
      CHECK(message.find('\n') == std::string::npos);
      CHECK(folder.names().empty());
    }
    CHECK(write_within(whole, drawing, path, options) == "none");
    CHECK(folder.names().size() == 1);
  }
}

TEST_CASE("a full disk leaves the old file as it was") {
  const Drawing drawing = made_drawing(100, 100);
  for (const std::string& name : format_names()) {
    INFO(name);
    const TemporaryFolder folder;
    const std::string path = folder.file("map." + name);
    fill_file(path, "old");
    const WriteOptions options{.format = format_of_name(name), .dpi = 100, .overwrite = true};
    CHECK(write_within(2000, drawing, path, options) != "none");
    CHECK(content_of(path) == "old");
    CHECK(folder.names().size() == 1);
  }
}
