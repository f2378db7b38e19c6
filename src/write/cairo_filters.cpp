// SPDX-License-Identifier: GPL-3.0-or-later
// PostScript goes line by line, since Cairo's lines are short. Layout and check sum of a PNG are by
// its specification (ISO/IEC 15948), sections 5 and 11.3.5.3.
#include "write/cairo_filters.hpp"

#include <cmath>
#include <cstdint>
#include <string>

namespace orograph {

bool PostscriptFilter::append(std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    line_.append(bytes.substr(0, end));
    if (end == std::string_view::npos) break;
    line_ += '\n';
    bytes.remove_prefix(end + 1);
    if (!pass_on_line()) return false;
  }
  return good_;
}

bool PostscriptFilter::pass_on_line() noexcept {
  page_is_whole_ = page_is_whole_ || line_ == "showpage\n";
  if (!line_.starts_with("%%CreationDate:")) good_ = out_.append(line_) && good_;
  line_.clear();
  return good_;
}

void PostscriptFilter::finish() {
  pass_on_line();
  if (good_ && !page_is_whole_)
    throw Error(out_.name() + " can't be written (the page got lost in a temporary file)",
                "free space in /tmp, or another format", ErrorCode::output);
}

std::string postscript_title(std::string_view title) {
  constexpr std::size_t most = 240;
  std::string comment = "%%Title: ";
  for (const char c : title.substr(0, most)) {
    const bool is_continuation = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (!is_continuation) comment += c >= ' ' && c <= '~' ? c : '?';
  }
  return comment;
}

namespace {

constexpr std::size_t kHeaderBytes = 8 + 25; // signature and IHDR chunk
constexpr double kInchesPerMetre = 1 / 0.0254;

void append_number(std::string& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xFF);
}

std::uint32_t crc_of(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
  }
  return ~crc;
}

std::string resolution_chunk(double dpi) {
  const auto pixels_per_metre = static_cast<std::uint32_t>(std::lround(dpi * kInchesPerMetre));
  std::string typed_data = "pHYs";
  append_number(typed_data, pixels_per_metre);
  append_number(typed_data, pixels_per_metre);
  typed_data += '\1'; // the unit is the metre
  std::string chunk;
  append_number(chunk, static_cast<std::uint32_t>(typed_data.size() - 4));
  chunk += typed_data;
  append_number(chunk, crc_of(typed_data));
  return chunk;
}

} // namespace

bool PngResolution::append(std::string_view bytes) noexcept {
  const std::size_t before = passed_;
  passed_ += bytes.size();
  if (before >= kHeaderBytes || passed_ < kHeaderBytes) return out_.append(bytes);
  const std::string_view header_end = bytes.substr(0, kHeaderBytes - before);
  out_.append(header_end);
  out_.append(resolution_chunk(dpi_));
  return out_.append(bytes.substr(header_end.size()));
}

} // namespace orograph
