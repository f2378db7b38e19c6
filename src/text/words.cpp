// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/words.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace orograph {
namespace {

template <class Word>
std::string with_between(std::span<const Word> words, std::string_view between) {
  std::string text;
  for (const Word& word : words) {
    if (&word != words.data()) text += between;
    text += word;
  }
  return text;
}

} // namespace

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const auto at = text.find(separator);
    parts.emplace_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

std::string joined(std::span<const std::string> words, std::string_view between) {
  return with_between(words, between);
}

std::string joined(std::span<const std::string_view> words, std::string_view between) {
  return with_between(words, between);
}

int edit_distance(std::string_view a, std::string_view b, int limit) {
  const auto [shorter, longer] = std::minmax({a.size(), b.size()});
  if (longer - shorter >= static_cast<std::size_t>(limit)) return limit;
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i) + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return std::min(row.back(), limit);
}

std::string_view nearest_word(std::string_view given, std::span<const std::string_view> words) {
  std::string_view nearest;
  int least = 4; // farther than that, a suggestion is a guess
  for (const std::string_view word : words) {
    const int distance = edit_distance(given, word, least);
    // A word of three letters is within 3 edits of any other.
    if (distance < least && distance < static_cast<int>(word.size())) {
      least = distance;
      nearest = word;
    }
  }
  return nearest;
}

} // namespace orograph
