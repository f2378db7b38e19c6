// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_strokes.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

namespace orograph {
namespace {

using Closer = int (*)(std::FILE*);
using File = std::unique_ptr<std::FILE, Closer>;

std::string whole(const File& file) {
  std::string text;
  std::string block(1U << 20U, '\0');
  while (const std::size_t read = std::fread(block.data(), 1, block.size(), file.get()))
    text.append(block, 0, read);
  return text;
}

void add(Strokes& strokes, std::vector<Vec2>& points) {
  if (points.size() > 1) {
    if (!strokes.empty() && strokes.back().back() == points.front())
      strokes.back().insert(strokes.back().end(), points.begin() + 1, points.end());
    else
      strokes.push_back(points);
  }
  points.clear();
}

/// Numbers of a text, each from where the last ended; commands between them are seen by the caller.
struct Numbers {
  const char* at;
  const char* end;

  bool skip_to_number(char& command) {
    for (; at < end; ++at) {
      if ((*at >= '0' && *at <= '9') || *at == '-' || *at == '.' || *at == '+') return true;
      if ((*at >= 'A' && *at <= 'Z') || (*at >= 'a' && *at <= 'z')) command = *at;
    }
    return false;
  }
  double next() {
    char* after = nullptr;
    const double number = std::strtod(at, &after);
    at = after > at ? after : end;
    return number;
  }
};

void read_svg(const std::string& text, Strokes& strokes) {
  std::vector<Vec2> points;
  const std::size_t defined = text.find("</defs>"); // markers that are drawn elsewhere, or nowhere
  std::size_t at = defined == std::string::npos ? 0 : defined;
  while ((at = text.find_first_of("\"'", at)) != std::string::npos) {
    const std::size_t end = text.find(text[at], at + 1);
    if (end == std::string::npos) break;
    const std::string_view before(text.data(), at);
    const bool is_path = before.ends_with(" d=") || before.ends_with("\nd=");
    if (is_path || before.ends_with("points=")) {
      Numbers numbers{text.data() + at + 1, text.data() + end};
      char command = is_path ? 'M' : 'L';
      while (numbers.skip_to_number(command)) {
        if (command == 'M') add(strokes, points);
        if (command == 'M') command = 'L';
        const double x = numbers.next();
        if (!numbers.skip_to_number(command)) break;
        points.push_back({x, 0 - numbers.next()});
      }
      add(strokes, points);
    }
    at = end + 1;
  }
}

// Object 2 is a polyline: a line of 16 numbers, of which the ninth is -1 where it isn't filled and
// the last is how many points follow.
void read_fig(const std::string& text, Strokes& strokes) {
  std::vector<Vec2> points;
  for (std::size_t at = 0; (at = text.find("\n2 1 ", at)) != std::string::npos; ++at) {
    Numbers numbers{text.data() + at, text.data() + text.size()};
    char command = ' ';
    double settings[16] = {};
    for (double& setting : settings)
      if (numbers.skip_to_number(command)) setting = numbers.next();
    if (settings[8] != -1) continue;
    for (int i = 0; i < settings[15] && numbers.skip_to_number(command); ++i) {
      const double x = numbers.next();
      if (!numbers.skip_to_number(command)) break;
      points.push_back({x, 0 - numbers.next()});
    }
    add(strokes, points);
  }
}

void read_lines(const std::string& text, Strokes& strokes) {
  std::vector<Vec2> points;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    char* after = nullptr;
    const double x = std::strtod(text.data() + at, &after);
    if (end == at)
      add(strokes, points);
    else
      points.push_back({x, std::strtod(after, nullptr)});
    at = end + 1;
  }
  add(strokes, points);
}

File opened(const std::string& path) {
  File file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw Error(path + " can't be opened", "name a drawing that is there");
  return file;
}

} // namespace

Strokes read_strokes(const std::string& path, const std::string& strokes_ps) {
  Strokes strokes;
  File file = opened(path);
  if (path.ends_with(".svg")) {
    read_svg(whole(file), strokes);
  } else if (path.ends_with(".fig")) {
    read_fig(whole(file), strokes);
  } else if (path.ends_with(".ps") || path.ends_with(".eps")) {
    const std::string command = fmt::format(
        "gs -q -dBATCH -dNOPAUSE -dNODISPLAY -dNOBIND -dNOSAFER '{}' '{}'", strokes_ps, path);
    const File pipe(popen(command.c_str(), "r"), pclose);
    if (pipe) read_lines(whole(pipe), strokes);
  } else {
    read_lines(whole(file), strokes);
  }
  if (strokes.empty())
    throw Error(path + " holds no polylines", "name an SVG, PostScript or xfig drawing, or text");
  return strokes;
}

} // namespace orograph
