// SPDX-License-Identifier: GPL-3.0-or-later
// The one way by which bytes leave: a file or standard output, with every write checked.
#pragma once

#include "geometry/error.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace orograph {

/// What to say about a file named `name` that can't be written, by its `errno`.
Error write_error(const std::string& name, int error_number);

/// `append` never throws, so that foreign libraries may call it; after the first failure it takes
/// no more, and `finish` throws.
class ByteSink {
public:
  /// Empties and opens the existing file at `path`; messages call it `name`. Throws Error.
  ByteSink(const std::string& path, std::string name);
  static ByteSink standard_output();
  /// Appends to a text, which must outlive it.
  static ByteSink into(std::string& text);
  ~ByteSink();
  ByteSink(ByteSink&& other) noexcept;
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;

  /// Whether all bytes up to now went out or wait in the buffer.
  bool append(std::string_view bytes) noexcept;
  const std::string& name() const { return name_; }
  /// Writes what waits and closes. Throws Error where this or any write before has failed.
  void finish();

private:
  ByteSink(int descriptor, std::string name);
  void write_out(std::string_view bytes) noexcept;
  std::size_t begin_to_store(std::size_t written) noexcept;

  int descriptor_ = -1;
  bool owns_descriptor_ = true;
  std::string* text_ = nullptr; ///< instead of a descriptor
  int error_number_ = 0;
  std::string name_;
  std::string waiting_;
  std::uint64_t written_ = 0;
};

} // namespace orograph
