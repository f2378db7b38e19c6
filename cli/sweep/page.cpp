// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/page.hpp"

#include "draw/simplify.hpp"
#include "geometry/vec.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace orograph {
namespace {

constexpr double kStep_mm = 0.1;
constexpr std::size_t kMostBytes = 30000; // of a preview
// Of all: more would make the page slow to open.
constexpr std::size_t kMostPreviewBytes = 32'000'000;
constexpr std::string_view kNoPreview = "null";
constexpr double kFewestProfiles = 40;
constexpr double kMostProfiles = 64; // some 1.5 mm apart on A4, where screens have 3 pixels

struct Coarseness {
  double tolerance_mm = 0.12;
  double shortest_mm = 0.6;
  double profiles = kMostProfiles;
  double one_in = 1; // of all lines
  double least_step_mm = 0;
};

void append(std::string& path, int number) {
  std::array<char, 16> text;
  path.append(text.data(), std::to_chars(text.begin(), text.end(), number).ptr);
}

// Numbers with no more between them than there must be.
void append(std::string& path, int x, int y, char command) {
  if (command != 0)
    path += command;
  else if (x >= 0)
    path += ' ';
  append(path, x);
  if (y >= 0) path += ' ';
  append(path, y);
}

// In which the profiles are that some drawing has, by number.
std::unordered_map<std::int32_t, std::size_t> ranks_of_profiles(const Drawing& drawing) {
  std::vector<std::int32_t> numbers;
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes)
      if (stroke.profile >= 0) numbers.push_back(stroke.profile);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::unordered_map<std::int32_t, std::size_t> ranks;
  for (std::size_t i = 0; i < numbers.size(); ++i) ranks[numbers[i]] = i;
  return ranks;
}

bool is_shorter(std::span<const Vec2> points, double mm) {
  for (std::size_t i = 1; i < points.size() && mm > 0; ++i)
    mm -= plain_length(points[i] - points[i - 1]);
  return mm > 0;
}

class PathWriter {
public:
  explicit PathWriter(const Coarseness& coarseness) : coarseness_(coarseness) {}

  void add(std::span<const Vec2> points) {
    if (is_shorter(points, coarseness_.shortest_mm)) return;
    simplify(points, coarseness_.tolerance_mm, kept_);
    bool begun = false, drawn = false;
    Vec2 last;
    for (const std::uint32_t i : kept_) {
      if (begun && i != kept_.back() && length(points[i] - last) < coarseness_.least_step_mm)
        continue;
      last = points[i];
      const int x = static_cast<int>(std::lround(points[i].x / kStep_mm)),
                y = static_cast<int>(std::lround(points[i].y / kStep_mm));
      if (begun && x == x_ && y == y_) continue;
      append(path_, x - x_, y - y_, !begun ? 'm' : !drawn ? 'l' : char(0));
      drawn = begun;
      begun = true;
      x_ = x;
      y_ = y;
    }
  }
  std::string take() { return std::move(path_); }

private:
  const Coarseness& coarseness_;
  std::vector<std::uint32_t> kept_;
  std::string path_;
  int x_ = 0, y_ = 0;
};

Preview draw(const Drawing& drawing, const Coarseness& coarseness,
             const std::unordered_map<std::int32_t, std::size_t>& ranks) {
  Preview preview{drawing.page.width_mm, drawing.page.height_mm, {}};
  const auto every = static_cast<std::size_t>(
      std::max(std::ceil(static_cast<double>(ranks.size()) / coarseness.profiles), 1.0));
  for (const Layer& layer : drawing.layers) {
    PathWriter writer(coarseness);
    const auto one_in = static_cast<std::size_t>(std::ceil(coarseness.one_in));
    for (std::size_t i = 0; i < layer.strokes.size(); i += one_in) {
      const Stroke& stroke = layer.strokes[i];
      if (stroke.profile < 0 || ranks.at(stroke.profile) % every == 0)
        writer.add(layer.points(stroke));
    }
    std::string path = writer.take();
    if (!path.empty())
      preview.layers.push_back({layer.name, layer.pen_width_mm, layer.grey, std::move(path)});
  }
  return preview;
}

std::size_t bytes_of(const Preview& preview) {
  std::size_t bytes = 0;
  for (const PreviewLayer& layer : preview.layers) bytes += layer.path.size();
  return bytes;
}

// In JSON `<` stands in strings only, where it may be escaped: so no tag and no comment begins.
void append_escaped(std::string& page, std::string_view json) {
  for (const char c : json)
    if (c == '<')
      page += "\\u003c";
    else
      page += c;
}

} // namespace

Preview preview_of(const Drawing& drawing) {
  const auto ranks = ranks_of_profiles(drawing);
  Coarseness coarseness;
  std::size_t points = 0;
  for (const Layer& layer : drawing.layers) points += layer.page_mm.size();
  // About as many bytes for each point as are left after simplification.
  const double guess = 1.6 * static_cast<double>(points) *
                       std::min(coarseness.profiles / static_cast<double>(ranks.size() + 1), 1.0) /
                       kMostBytes;
  coarseness.profiles /= std::clamp(guess, 1.0, kMostProfiles / kFewestProfiles);
  for (;;) {
    Preview preview = draw(drawing, coarseness, ranks);
    const double excess = static_cast<double>(bytes_of(preview)) / kMostBytes;
    if (excess <= 1) return preview;
    // Fewer profiles first, down to what still tells a form; then less of each. Of lines that are
    // all short or wild it is some that tell more than none.
    constexpr double kMargin = 1.1, kLongest_mm = 2;
    const double fewer =
        std::min(kMargin * excess, std::max(coarseness.profiles / kFewestProfiles, 1.0));
    coarseness.profiles /= fewer;
    if (excess <= fewer) continue;
    const double less = kMargin * excess / fewer;
    if (coarseness.shortest_mm >= kLongest_mm) {
      coarseness.one_in *= less;
      coarseness.least_step_mm = coarseness.tolerance_mm;
    }
    coarseness.tolerance_mm *= std::min(less, 1.5);
    coarseness.shortest_mm = std::min(coarseness.shortest_mm * less, kLongest_mm);
  }
}

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
