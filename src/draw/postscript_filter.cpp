// SPDX-License-Identifier: GPL-3.0-or-later
// Line by line; Cairo's lines are short.
#include "draw/postscript_filter.hpp"

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
                "free space in /tmp, or another format");
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

} // namespace orograph
