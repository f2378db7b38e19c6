// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/text_of_file.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

namespace orograph {

std::string text_of_file(const std::string& path, const TextKind& kind) {
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) throw Error(path + " is a folder", kind.right);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    if (errno == ENOENT) throw Error(path + ": no such file", kind.right);
    throw Error(fmt::format("{} can't be opened ({})", path, std::strerror(errno)), kind.right);
  }
  std::string text;
  constexpr std::size_t block = 65536;
  while (file && text.size() <= kind.most_bytes) {
    const std::size_t before = text.size();
    text.resize(before + block);
    file.read(text.data() + before, block);
    text.resize(before + static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) throw Error(path + " can't be read", kind.right);
  if (text.size() > kind.most_bytes)
    throw Error(fmt::format("{} is too large for {} (over {} MB)", path, kind.noun,
                            kind.most_bytes / 1'000'000),
                kind.right);
  return text;
}

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

} // namespace orograph
