// SPDX-License-Identifier: GPL-3.0-or-later
// Results for other programs to read, beside those for people.
#pragma once

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace orograph {

/// Takes `--csv FILE` out of the front of a program's arguments; empty where it isn't there.
inline std::string csv_asked(int& argc, char** argv) {
  if (argc < 3 || std::string_view(argv[1]) != "--csv") return {};
  std::string path = argv[2];
  std::rotate(argv + 1, argv + 3, argv + argc);
  argc -= 2;
  return path;
}

/// A line of text at a time. Without a path it goes nowhere.
class CsvFile {
public:
  CsvFile(const std::string& path, const std::string& header)
      : file_(path.empty() ? nullptr : std::fopen(path.c_str(), "w")) {
    if (!path.empty() && !file_) std::perror(path.c_str());
    add(header);
  }
  void add(const std::string& line) {
    if (file_) std::fprintf(file_.get(), "%s\n", line.c_str());
    if (file_) std::fflush(file_.get());
  }

private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
};

} // namespace orograph
