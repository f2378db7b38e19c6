// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader says of files that it can't take.
#pragma once

#include "dem/read/read_terrain.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace orograph {

/// What `read_terrain` throws; "" if nothing.
inline std::string message_of_all(const std::vector<std::string>& paths,
                                  const ReadOptions& options = {}) {
  try {
    read_terrain(paths, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

inline std::string message_of(const std::string& path, const ReadOptions& options = {}) {
  return message_of_all({path}, options);
}

/// One line that holds all of the words.
inline void check_message(const std::string& message, const std::vector<std::string>& words) {
  INFO(message);
  CHECK(!message.empty());
  CHECK(std::count(message.begin(), message.end(), '\n') == 0);
  for (const std::string& word : words) {
    INFO("should say: " << word);
    CHECK(message.find(word) != std::string::npos);
  }
}

inline void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

} // namespace orograph
