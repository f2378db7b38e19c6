// SPDX-License-Identifier: GPL-3.0-or-later
// What an index's file is made of: numbers that are told, and blocks of them with a sum each.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// Why an index, or a part of it, isn't believed.
struct Refused {
  std::string why;
};

/// Of words of eight bytes; what is left over counts as one that is filled up. (FNV-1a by words.)
class Checksum {
public:
  void add(const void* bytes, std::size_t size) {
    const auto* at = static_cast<const char*>(bytes);
    for (; size > 0; at += sizeof(std::uint64_t)) {
      std::uint64_t word = 0;
      const std::size_t part = std::min(size, sizeof word);
      std::memcpy(&word, at, part);
      state_ = std::rotl((state_ ^ word) * 0x100000001b3ULL, 29);
      size -= part;
    }
  }
  std::uint64_t state() const { return state_; }

private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

template <class Values>
std::uint64_t sum_of(const Values& values) {
  Checksum sum;
  sum.add(values.data(), values.size() * sizeof(values[0]));
  return sum.state();
}

/// What is told, as bytes.
class Teller {
public:
  template <class Number>
  void put(Number number) {
    const auto* at = reinterpret_cast<const char*>(&number);
    bytes_.append(at, sizeof number);
  }
  void put_text(std::string_view text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_.append(text);
  }
  const std::string& bytes() const { return bytes_; }

private:
  std::string bytes_;
};

/// Takes the same apart. Throws Refused where it ends too early.
class Listener {
public:
  explicit Listener(std::string_view bytes) : rest_(bytes) {}

  template <class Number>
  Number take() {
    Number number{};
    const std::string_view bytes = take_bytes(sizeof number);
    std::memcpy(&number, bytes.data(), sizeof number);
    return number;
  }
  std::string_view take_text() { return take_bytes(take<std::uint64_t>()); }

private:
  std::string_view take_bytes(std::uint64_t size) {
    if (size > rest_.size()) throw Refused{"it is damaged"};
    const std::string_view bytes = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return bytes;
  }

  std::string_view rest_;
};

/// Whether they are what a reader gives: finite, or NaN.
template <class Height>
bool are_heights(const std::vector<Height>& values) {
  return std::ranges::none_of(values, [](Height value) { return std::isinf(value); });
}

/// A block of values that are as they are in memory. Throws Refused where it isn't there, or its
/// sum isn't this.
template <class Values>
void read_block(std::istream& file, Values& values, std::uint64_t sum) {
  if (!file.read(reinterpret_cast<char*>(values.data()),
                 static_cast<std::streamsize>(values.size() * sizeof(values[0]))) ||
      sum_of(values) != sum)
    throw Refused{"it is damaged"};
}

} // namespace orograph
