// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/page.hpp"

#include "cli/sweep/page_template.hpp"

#include <string_view>

namespace orograph {
namespace {

// In JSON `<` stands in strings only, where it may be escaped: so no tag and no comment begins.
void append_escaped(std::string& page, std::string_view json) {
  for (const char c : json)
    if (c == '<')
      page += "\\u003c";
    else
      page += c;
}

} // namespace

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
