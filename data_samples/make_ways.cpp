// SPDX-License-Identifier: GPL-3.0-or-later
// Writes fractal_alps_ways.geojson: the rivers and streams that run off the heights of
// fractal_alps, and roads along its valleys and over a pass. usage: make_ways OUT_DIR
#include "data_samples/terrains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace orograph;

namespace {

constexpr int kVertices = 601; // along a side, twice as many as the sample has
constexpr Vec2 kCorner{500000, 100000};
constexpr double kStream_m2 = 3.2e6, kRiver_m2 = 2e7; // that feed a stream, and a river

constexpr std::array<std::pair<int, int>, 16> kSteps{{{1, 0},
                                                      {0, 1},
                                                      {-1, 0},
                                                      {0, -1},
                                                      {1, 1},
                                                      {-1, 1},
                                                      {-1, -1},
                                                      {1, -1},
                                                      {2, 1},
                                                      {1, 2},
                                                      {-1, 2},
                                                      {-2, 1},
                                                      {-2, -1},
                                                      {-1, -2},
                                                      {1, -2},
                                                      {2, -1}}};
constexpr std::size_t kNeighbours = 8; // of those steps

using Place = std::size_t; // a vertex's number
constexpr Place kNowhere = std::numeric_limits<Place>::max();
using Path = std::vector<Place>;

class Ground {
public:
  double height_m(Place p) const { return grid_.height_m(column(p), row(p)); }
  int column(Place p) const { return static_cast<int>(p % kVertices); }
  int row(Place p) const { return static_cast<int>(p / kVertices); }
  Vec2 at_m(Place p) const { return grid_.plane().position_m(column(p), row(p)); }
  Place nearest(Vec2 at_m) const {
    const auto whole = [&](double m) {
      return static_cast<std::size_t>(std::lround(m / cell_m()));
    };
    return (kVertices - 1 - whole(at_m.y)) * kVertices + whole(at_m.x);
  }
  double cell_m() const { return grid_.plane().column_step_m.x; }
  /// Where a step leads; kNowhere beyond the border.
  Place after(Place p, std::pair<int, int> step) const {
    const int c = column(p) + step.first, r = row(p) + step.second;
    if (c < 0 || r < 0 || c >= kVertices || r >= kVertices) return kNowhere;
    return static_cast<Place>(r) * kVertices + static_cast<Place>(c);
  }
  bool is_at_border(Place p) const {
    return column(p) == 0 || row(p) == 0 || column(p) == kVertices - 1 || row(p) == kVertices - 1;
  }

private:
  Grid grid_ = make_terrain(MadeTerrain::fractal_alps, kVertices);
};

constexpr Place kPlaces = Place{kVertices} * kVertices;

// How water runs off: the terrain is flooded from its border inwards, always over the lowest shore,
// and each place drains to the one that it was flooded from (Barnes and others, 2014). So all water
// reaches the border, out of hollows too: there it follows their deepest ground.
struct Drainage {
  std::vector<Place> to;            ///< kNowhere at the border
  std::vector<double> catchment_m2; ///< what drains through a place
};

Drainage drained(const Ground& ground) {
  using Shore = std::tuple<double, double, Place>; // the water's level, the ground's
  std::priority_queue<Shore, std::vector<Shore>, std::greater<>> shores;
  Drainage out{std::vector<Place>(kPlaces, kNowhere), std::vector<double>(kPlaces)};
  std::vector<bool> is_reached(kPlaces);
  Path order;
  for (Place p = 0; p < kPlaces; ++p)
    if (ground.is_at_border(p)) {
      shores.emplace(ground.height_m(p), ground.height_m(p), p);
      is_reached[p] = true;
    }
  while (!shores.empty()) {
    const auto [level_m, ground_m, p] = shores.top();
    shores.pop();
    order.push_back(p);
    for (std::size_t k = 0; k < kNeighbours; ++k) {
      const Place next = ground.after(p, kSteps[k]);
      if (next == kNowhere || is_reached[next]) continue;
      is_reached[next] = true;
      out.to[next] = p;
      shores.emplace(std::max(level_m, ground.height_m(next)), ground.height_m(next), next);
    }
  }
  const double cell_m2 = ground.cell_m() * ground.cell_m();
  for (auto p = order.rbegin(); p != order.rend(); ++p) {
    out.catchment_m2[*p] += cell_m2;
    if (out.to[*p] != kNowhere) out.catchment_m2[out.to[*p]] += out.catchment_m2[*p];
  }
  return out;
}

// From mouth to source: where two meet, the larger one goes on and the other begins.
std::vector<Path> rivers_of(const Drainage& drainage) {
  std::vector<Path> upstream(kPlaces);
  Path mouths;
  for (Place p = 0; p < kPlaces; ++p) {
    if (drainage.catchment_m2[p] < kStream_m2) continue;
    if (drainage.to[p] == kNowhere)
      mouths.push_back(p);
    else
      upstream[drainage.to[p]].push_back(p);
  }
  std::vector<Path> rivers;
  for (const Place mouth : mouths) rivers.push_back({mouth});
  for (std::size_t i = 0; i < rivers.size(); ++i) // grows
    for (Place p = rivers[i].back(); !upstream[p].empty(); p = rivers[i].back()) {
      const auto larger = [&](Place a, Place b) {
        return drainage.catchment_m2[a] > drainage.catchment_m2[b];
      };
      std::sort(upstream[p].begin(), upstream[p].end(), larger);
      for (std::size_t k = 1; k < upstream[p].size(); ++k) rivers.push_back({p, upstream[p][k]});
      rivers[i].push_back(upstream[p].front());
    }
  std::erase_if(rivers, [](const Path& river) { return river.size() < 25; });
  return rivers;
}

// Of least effort: it climbs as little as it can, by bends where a slope isn't easy, and keeps out
// of the river's bed.
Path way_between(const Ground& ground, const Drainage& drainage, Vec2 from_m, Vec2 to_m,
                 double easy_slope) {
  constexpr double kRiverBed = 2;
  using Reached = std::pair<double, Place>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> ahead;
  std::vector<double> effort(kPlaces, std::numeric_limits<double>::infinity());
  std::vector<Place> before(kPlaces, kNowhere);
  const Place from = ground.nearest(from_m), to = ground.nearest(to_m);
  effort[from] = 0;
  ahead.emplace(0, from);
  while (!ahead.empty() && ahead.top().second != to) {
    const auto [reached, p] = ahead.top();
    ahead.pop();
    if (reached > effort[p]) continue;
    for (const auto& step : kSteps) {
      const Place next = ground.after(p, step);
      if (next == kNowhere) continue;
      const double way_m = length(ground.at_m(next) - ground.at_m(p));
      const double slope = (ground.height_m(next) - ground.height_m(p)) / way_m / easy_slope;
      const double bed = drainage.catchment_m2[next] >= kStream_m2 ? kRiverBed : 0;
      const double there = reached + way_m * (1 + bed + slope * slope);
      if (there >= effort[next]) continue;
      effort[next] = there;
      before[next] = p;
      ahead.emplace(there, next);
    }
  }
  Path path{to};
  while (path.back() != from) path.push_back(before[path.back()]);
  std::reverse(path.begin(), path.end());
  return path;
}

using Line = std::vector<Vec2>;

// Without the corners of the lattice: each point but the ends goes to the mean of its neighbours
// and itself, several times; then corners are cut.
Line smooth(const Ground& ground, const Path& path) {
  Line line;
  for (const Place p : path) line.push_back(ground.at_m(p));
  for (int times = 0; times < 3; ++times) {
    const Line before = line;
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
      line[i] = 0.25 * (before[i - 1] + before[i + 1]) + 0.5 * before[i];
  }
  return line;
}

// Leaves out points that are this near to the line without them (Douglas and Peucker).
void add_simplified(const Line& line, std::size_t first, std::size_t last, Line& out) {
  constexpr double kNear_m = 2;
  double farthest_m = kNear_m;
  std::size_t middle = first;
  const Vec2 way = line[last] - line[first];
  for (std::size_t i = first + 1; i < last; ++i) {
    const Vec2 from_first = line[i] - line[first];
    const double off_m =
        length(way) > 0 ? std::abs(cross(way, from_first)) / length(way) : length(from_first);
    if (off_m <= farthest_m) continue;
    farthest_m = off_m;
    middle = i;
  }
  if (middle != first) {
    add_simplified(line, first, middle, out);
    add_simplified(line, middle, last, out);
  } else {
    out.push_back(line[last]);
  }
}

class Features {
public:
  explicit Features(std::FILE* file) : file_(file) {
    std::fprintf(file_, "{ \"type\": \"FeatureCollection\",\n  \"crs\": { \"type\": \"name\", "
                        "\"properties\": { \"name\": \"urn:ogc:def:crs:EPSG::32631\" } },\n"
                        "  \"features\": [");
  }
  ~Features() { std::fprintf(file_, "\n  ]\n}\n"); }
  Features(const Features&) = delete;
  Features& operator=(const Features&) = delete;

  void add(const char* kind, const Line& line) {
    Line few{line.front()};
    add_simplified(line, 0, line.size() - 1, few);
    std::fprintf(file_,
                 "%s\n    { \"type\": \"Feature\", \"properties\": { \"class\": \"%s\" }, "
                 "\"geometry\": { \"type\": \"LineString\", \"coordinates\": [",
                 is_first_ ? "" : ",", kind);
    for (std::size_t i = 0; i < few.size(); ++i)
      std::fprintf(file_, "%s[%.1f,%.1f]", i == 0 ? "" : ",", kCorner.x + few[i].x,
                   kCorner.y + few[i].y);
    std::fprintf(file_, "] } }");
    is_first_ = false;
  }

private:
  std::FILE* file_;
  bool is_first_ = true;
};

struct Way {
  const char* kind;
  Vec2 from_m, to_m;
  double easy_slope;
};
// Up the long valley from the south-east, over a pass to the east, over another to the west, and on
// foot to the heights in the north.
constexpr std::array<Way, 4> kWays{{{"road", {20900, 200}, {10900, 10300}, 0.08},
                                    {"road", {10900, 10300}, {23800, 16100}, 0.08},
                                    {"road", {12440, 12020}, {300, 13700}, 0.08},
                                    {"track", {18700, 16000}, {20000, 23000}, 0.25}}};

} // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: make_ways OUT_DIR\n");
    return 2;
  }
  const std::string path = std::string(arguments[1]) + "/fractal_alps_ways.geojson";
  std::FILE* const file = std::fopen(path.c_str(), "w");
  if (!file) {
    std::fprintf(stderr, "make_ways: error: %s can't be written\n", path.c_str());
    return 1;
  }
  const Ground ground;
  const Drainage drainage = drained(ground);
  {
    Features features(file);
    for (const Path& river : rivers_of(drainage)) {
      const Line line = smooth(ground, river);
      std::size_t rivers = 0; // points of it, up to where it is a stream
      while (rivers < river.size() && drainage.catchment_m2[river[rivers]] >= kRiver_m2) ++rivers;
      if (rivers > 1)
        features.add("river", {line.begin(), line.begin() + static_cast<long>(rivers)});
      if (rivers + 1 < river.size())
        features.add(
            "stream",
            {line.begin() + static_cast<long>(std::max<std::size_t>(rivers, 1)) - 1, line.end()});
    }
    for (const auto& [kind, from_m, to_m, easy_slope] : kWays)
      features.add(kind, smooth(ground, way_between(ground, drainage, from_m, to_m, easy_slope)));
  }
  return std::fclose(file) == 0 ? 0 : 1;
}
