// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/page.hpp"

#include <string_view>
#include <utility>

namespace orograph {
namespace {

// Of all: more would make the page slow to open.
constexpr std::size_t kMostPreviewBytes = 32'000'000;
constexpr std::string_view kNoPreview = "null";

// In JSON `<` stands in strings only, where it may be escaped: so no tag and no comment begins.
void append_escaped(std::string& page, std::string_view json) {
  for (const char c : json)
    if (c == '<')
      page += "\\u003c";
    else
      page += c;
}

} // namespace

void RowPreviews::add(std::string preview) {
  if (previews_.size() % every_ != 0) preview = kNoPreview;
  bytes_ += preview.size();
  previews_.push_back(std::move(preview));
  while (bytes_ > kMostPreviewBytes && every_ < previews_.size()) {
    every_ *= 2;
    for (std::size_t i = every_ / 2; i < previews_.size(); i += every_) {
      bytes_ -= previews_[i].size() - kNoPreview.size();
      previews_[i] = kNoPreview;
    }
  }
}

std::string RowPreviews::json() const {
  std::string text = "[";
  for (const std::string& preview : previews_) {
    if (text.size() > 1) text += ",\n";
    text += preview;
  }
  return text + "]";
}

std::string sweep_page(const std::string& table_json, const std::string& previews_json) {
  constexpr std::string_view table_mark = "{{table}}", previews_mark = "{{previews}}";
  // Places in the template, looked for before any data is in it: data may hold the marks as well.
  const std::string_view text = sweep_page_template();
  const std::size_t table_at = text.find(table_mark);
  const std::size_t between = table_at + table_mark.size();
  const std::size_t previews_at = text.find(previews_mark, between);

  std::string page;
  page.reserve(text.size() + table_json.size() + previews_json.size());
  page += text.substr(0, table_at);
  append_escaped(page, table_json);
  page += text.substr(between, previews_at - between);
  append_escaped(page, previews_json);
  page += text.substr(previews_at + previews_mark.size());
  return page;
}

} // namespace orograph
