// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/netcdf_header.hpp"

#include "geometry/error.hpp"

#include <cpl_vsi.h>
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace orograph {
namespace {

struct CloseFile {
  void operator()(VSILFILE* file) const { VSIFCloseL(file); }
};

struct HoldsLess {};     // than the header tells of
struct NotUnderstood {}; // no such header

// By the format's grammar (NetCDF Classic Format Specification, Unidata): lists of dimensions,
// attributes and variables, all counts before what they count, in steps of four bytes.
class Header {
public:
  Header(VSILFILE& file, std::uint64_t size, int version)
      : file_(file), left_(size - 4), version_(version) {}

  void check() {
    skip(1, number_bytes()); // records
    list(kDimensions, [&] {
      name();
      skip(1, number_bytes());
    });
    attributes();
    list(kVariables, [&] {
      name();
      skip(number(), number_bytes()); // its dimensions
      attributes();
      skip(1, 4);                                               // its type
      skip(1, number_bytes());                                  // its size
      skip(1, version_ == 1 ? std::size_t{4} : std::size_t{8}); // where it begins
    });
  }

private:
  static constexpr std::uint64_t kDimensions = 10, kVariables = 11, kAttributes = 12;

  std::size_t number_bytes() const { return version_ == 5 ? 8 : 4; }

  std::uint64_t read(std::size_t bytes) {
    std::array<unsigned char, 8> digits{};
    if (left_ < bytes || VSIFReadL(digits.data(), 1, bytes, &file_) != bytes) throw HoldsLess{};
    left_ -= bytes;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value = value << 8U | digits[i];
    return value;
  }
  std::uint64_t number() { return read(number_bytes()); }

  // So many of so many bytes each, filled up to a multiple of four.
  void skip(std::uint64_t count, std::size_t bytes) {
    if (count > left_ / bytes) throw HoldsLess{};
    const std::uint64_t taken = (count * bytes + 3) / 4 * 4;
    if (taken > left_) throw HoldsLess{};
    VSIFSeekL(&file_, taken, SEEK_CUR);
    left_ -= taken;
  }

  template <class One>
  void list(std::uint64_t tag, const One& one) {
    const std::uint64_t found = read(4), count = number();
    if (found == 0 && count == 0) return;
    if (found != tag) throw NotUnderstood{};
    if (count > left_ / number_bytes()) throw HoldsLess{}; // each has a name
    for (std::uint64_t i = 0; i < count; ++i) one();
  }

  void name() { skip(number(), 1); }

  void attributes() {
    // By the number of a type, from 1 on: byte, char, short, int, float, double, and unsigned ones.
    constexpr std::array<std::size_t, 12> kBytes{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    list(kAttributes, [&] {
      name();
      const std::uint64_t type = read(4);
      if (type == 0 || type >= kBytes.size()) throw NotUnderstood{};
      skip(number(), kBytes[type]);
    });
  }

  VSILFILE& file_;
  std::uint64_t left_;
  int version_;
};

std::optional<int> classic_version(VSILFILE& file) {
  std::array<char, 4> begin{};
  if (VSIFReadL(begin.data(), 1, begin.size(), &file) != begin.size()) return {};
  const int version = begin[3];
  const bool is_classic = begin[0] == 'C' && begin[1] == 'D' && begin[2] == 'F';
  return is_classic && (version == 1 || version == 2 || version == 5) ? std::optional(version)
                                                                      : std::nullopt;
}

} // namespace

void check_netcdf_header(const std::string& path) {
  VSIStatBufL status{}; // what is read of a pipe is gone
  if (VSIStatL(path.c_str(), &status) != 0 || !VSI_ISREG(status.st_mode)) return;
  const std::unique_ptr<VSILFILE, CloseFile> file(VSIFOpenL(path.c_str(), "rb"));
  const std::optional<int> version = file ? classic_version(*file) : std::nullopt;
  if (!version) return;
  const auto size = static_cast<std::uint64_t>(status.st_size);
  try {
    Header(*file, size, *version).check();
  } catch (const NotUnderstood&) { // on some of these the library itself breaks off
    throw Error(fmt::format("{} is damaged: its header isn't one of netCDF", path),
                "fetch it again");
  } catch (const HoldsLess&) {
    throw Error(fmt::format("{} is cut off or damaged: its {} bytes can't hold what its header "
                            "tells of",
                            path, size),
                "fetch it again");
  }
}

} // namespace orograph
