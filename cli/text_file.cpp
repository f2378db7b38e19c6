// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/text_file.hpp"

#include "geometry/error.hpp"
#include "write/byte_sink.hpp"
#include "write/output_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace orograph {

std::optional<std::string> whole_file(const std::string& path) {
  // Streams throw, or tell nothing, where a folder is opened as a file.
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             std::fclose);
  if (!file && (errno == ENOENT || errno == ENOTDIR)) return std::nullopt;
  std::string text;
  char block[65536];
  while (file) {
    const std::size_t count = std::fread(block, 1, sizeof block, file.get());
    text.append(block, count);
    if (count < sizeof block) break;
  }
  if (!file || std::ferror(file.get()))
    throw Error(fmt::format("{} can't be read ({})", path, std::strerror(errno)),
                "look at what it is, and at its rights");
  return text;
}

void write_text(const std::string& text, const std::string& path, bool overwrite) {
  OutputFile place(path, overwrite);
  ByteSink out(place.temporary_path(), path);
  out.append(text);
  out.finish();
  place.commit();
}

} // namespace orograph
