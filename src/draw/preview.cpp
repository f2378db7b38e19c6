// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/preview.hpp"

#include "draw/simplify.hpp"
#include "geometry/vec.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace orograph {
namespace {

constexpr double kStep_mm = 0.1;
constexpr std::size_t kMostBytes = 30000; // of a preview
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

// The profiles that a drawing has, by number, and the level of each.
std::map<std::int32_t, int> levels_of_profiles(const Drawing& drawing) {
  std::map<std::int32_t, int> levels;
  for (const Layer& layer : drawing.layers)
    for (const Stroke& stroke : layer.strokes)
      if (stroke.profile >= 0) levels[stroke.profile] = stroke.level;
  return levels;
}

// As many as are asked for, or fewer, evenly spread: those of high levels, of which lines are even
// where all lines are; and of these each so-and-so-many-th.
std::unordered_set<std::int32_t> spread_profiles(const std::map<std::int32_t, int>& levels,
                                                 double most) {
  std::set<int> all;
  for (const auto& [number, level] : levels) all.insert(level);
  std::vector<std::int32_t> taken;
  for (const int least : all) {
    taken.clear();
    for (const auto& [number, level] : levels)
      if (level >= least) taken.push_back(number);
    if (static_cast<double>(taken.size()) <= most) break;
  }
  const auto every =
      static_cast<std::size_t>(std::max(std::ceil(static_cast<double>(taken.size()) / most), 1.0));
  std::unordered_set<std::int32_t> spread;
  for (std::size_t i = 0; i < taken.size(); i += every) spread.insert(taken[i]);
  return spread;
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
             const std::map<std::int32_t, int>& levels) {
  Preview preview{drawing.page.width_mm, drawing.page.height_mm, {}};
  const std::unordered_set<std::int32_t> spread = spread_profiles(levels, coarseness.profiles);
  const auto one_in = static_cast<std::size_t>(std::ceil(coarseness.one_in));
  for (const Layer& layer : drawing.layers) {
    PathWriter writer(coarseness);
    std::size_t number = 0; // of a line, which is several strokes where its width changes
    std::vector<Vec2> line;
    const auto end_line = [&] {
      if (!line.empty() && number++ % one_in == 0) writer.add(line);
      line.clear();
    };
    std::int32_t profile = -1;
    for (const Stroke& stroke : layer.strokes) {
      if (stroke.profile >= 0 && !spread.contains(stroke.profile)) continue;
      const auto points = layer.points(stroke);
      const bool goes_on =
          !line.empty() && stroke.profile == profile && points.front() == line.back();
      if (!goes_on) end_line();
      line.insert(line.end(), points.begin() + (goes_on ? 1 : 0), points.end());
      profile = stroke.profile;
    }
    end_line();
    std::string path = writer.take();
    const auto ink = layer.ink();
    if (!path.empty())
      preview.layers.push_back({layer.name, layer.pen_width_mm, layer.grey,
                                ink ? hex_of(*ink) : std::string(), std::move(path)});
  }
  return preview;
}

std::size_t bytes_of(const Preview& preview) {
  std::size_t bytes = 0;
  for (const PreviewLayer& layer : preview.layers) bytes += layer.path.size();
  return bytes;
}

} // namespace

Preview preview_of(const Drawing& drawing) {
  const auto levels = levels_of_profiles(drawing);
  Coarseness coarseness;
  std::size_t points = 0;
  for (const Layer& layer : drawing.layers) points += layer.page_mm.size();
  // About as many bytes for each point as are left after simplification.
  const double guess = 1.6 * static_cast<double>(points) *
                       std::min(coarseness.profiles / static_cast<double>(levels.size() + 1), 1.0) /
                       kMostBytes;
  coarseness.profiles /= std::clamp(guess, 1.0, kMostProfiles / kFewestProfiles);
  for (;;) {
    Preview preview = draw(drawing, coarseness, levels);
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

} // namespace orograph
