// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/device_words.hpp"

#include <algorithm>

namespace orograph {

std::optional<std::string> unknown_place(std::string_view text,
                                         const std::vector<std::string_view>& places) {
  for (std::size_t at = text.find_first_of("{}"); at != std::string_view::npos;
       at = text.find_first_of("{}", at + 1)) {
    const std::size_t end = text.find('}', at);
    if (text[at] == '}' || end == std::string_view::npos) return std::string(text.substr(at, 1));
    if (std::ranges::find(places, text.substr(at + 1, end - at - 1)) == places.end())
      return std::string(text.substr(at, end - at + 1));
    at = end;
  }
  return std::nullopt;
}

std::string filled(std::string_view text,
                   std::initializer_list<std::pair<std::string_view, std::string_view>> places) {
  std::string out;
  for (std::size_t at = text.find('{'); at != std::string_view::npos; at = text.find('{')) {
    const std::size_t end = text.find('}', at);
    out += text.substr(0, at);
    const std::string_view name = text.substr(at + 1, end - at - 1);
    for (const auto& [place, value] : places)
      if (place == name) out += value;
    text.remove_prefix(end + 1);
  }
  return out += text;
}

std::string plain_words(std::string_view text) {
  std::string plain;
  for (const char c : text)
    if ((c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
        std::string_view(" -_.").find(c) != std::string_view::npos)
      plain += c;
  return plain;
}

} // namespace orograph
