// SPDX-License-Identifier: GPL-3.0-or-later
// Walking through text by lines and words, and how far words are apart.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// ASCII letters alone.
inline std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

/// Of a file's name, with its dot and in lower case; empty where there is none.
inline std::string extension_of(const std::string& path) {
  return in_lower_case(std::filesystem::path(path).extension().string());
}

/// Cuts the next word off the text; empty at its end.
inline std::string_view next_word(std::string_view& text) {
  constexpr std::string_view blanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

inline std::size_t count_words(std::string_view text) {
  std::size_t count = 0;
  while (!next_word(text).empty()) ++count;
  return count;
}

/// The whole word as a number; a plus in front is fine.
template <class Number>
std::optional<Number> number_of(std::string_view word) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  Number value{};
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (fault != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

inline bool is_finite_number(std::string_view word) {
  const auto value = number_of<double>(word);
  return value && std::isfinite(*value);
}

/// Lines without what follows a '#', and without those that are blank then.
class DataLines {
public:
  explicit DataLines(std::string_view text) : rest_(text) {}

  bool next() {
    while (!rest_.empty()) {
      ++number_;
      const std::size_t end = rest_.find('\n');
      line_ = rest_.substr(0, end);
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      line_ = line_.substr(0, line_.find('#'));
      if (line_.find_first_not_of(" \t\r") != std::string_view::npos) return true;
    }
    return false;
  }
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }

private:
  std::string_view rest_, line_;
  std::size_t number_ = 0;
};

/// The parts between separators; empty parts stay.
std::vector<std::string> split(std::string_view text, char separator);

/// One after the other, with the same between two of them.
std::string joined(std::span<const std::string> words, std::string_view between);
std::string joined(std::span<const std::string_view> words, std::string_view between);

/// Edits (insert, remove, replace) that turn one word into the other, or `limit` where these aren't
/// fewer: a word of many letters costs nothing then.
int edit_distance(std::string_view a, std::string_view b, int limit);

/// The word that may have been meant: the first of those fewest edits away, if these are at most
/// three and fewer than the word has letters. Empty where there is none.
std::string_view nearest_word(std::string_view given, std::span<const std::string_view> words);

} // namespace orograph
