// SPDX-License-Identifier: GPL-3.0-or-later
// Writes quarry_points.csv and quarry_breaklines.geojson: a surveyed quarry on a hillside, as
// scattered points and as the edges of its benches. usage: make_quarry OUT_DIR
#include "geometry/vec.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

using namespace orograph;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kSide_m = 600;         // of the surveyed square
constexpr Vec2 kCorner{501000, 120000}; // its south-west corner, in open sea
constexpr Vec2 kCentre{310, 330};       // of the pit
constexpr double kFloor_m = 164;        // height of the pit's floor
constexpr int kBenches = 5;
constexpr double kFace_m = 14;   // height of a bench's face
constexpr double kFaceRun_m = 6; // how far a face reaches outwards
constexpr double kFloorRadius_m = 55;
constexpr double kBenchRadius_m = 27; // from one toe to the next

// The pit isn't round: its radii are stretched by this, by direction.
double stretch(double angle) {
  return 1 + 0.14 * std::sin(2 * angle + 0.6) + 0.07 * std::sin(3 * angle - 1);
}

Vec2 at(double radius, double angle) {
  return kCentre + (radius * stretch(angle)) * Vec2{std::cos(angle), std::sin(angle)};
}

// The hillside before anything was dug: it rises to the north, with swells.
double hillside_m(Vec2 p) {
  const double swells =
      9 * std::sin(p.x / 83 + 1) * std::cos(p.y / 97) + 4 * std::sin(p.x / 31 - p.y / 43);
  return 228 + 0.09 * p.y + 0.04 * p.x + swells;
}

// Toe and crest of bench i, radii before stretching.
double toe_m(int i) {
  return kFloorRadius_m + i * kBenchRadius_m;
}
double crest_m(int i) {
  return toe_m(i) + kFaceRun_m;
}
double level_m(int i) {
  return kFloor_m + i * kFace_m;
}

// Radius in the unstretched pit.
double radius_m(Vec2 p) {
  const Vec2 from_centre = p - kCentre;
  return length(from_centre) / stretch(std::atan2(from_centre.y, from_centre.x));
}

// Near an edge of a bench the surveyor takes the edge, and no other points.
bool is_at_an_edge(Vec2 p) {
  const double radius = radius_m(p);
  for (int i = 0; i <= kBenches; ++i)
    if (radius > toe_m(i) - 3 && radius < crest_m(i) + 3) return true;
  return false;
}

// Height of the surface as it is now. A bench is level up to the toe of the next face; the pit ends
// at the first crest that would come out above the hillside.
double height_m(Vec2 p) {
  const double radius = radius_m(p), hillside = hillside_m(p);
  double pit = kFloor_m;
  for (int i = 0; i < kBenches; ++i) {
    if (radius >= crest_m(i))
      pit = level_m(i + 1);
    else if (radius > toe_m(i))
      pit = level_m(i) + kFace_m * (radius - toe_m(i)) / kFaceRun_m;
  }
  if (radius >= toe_m(kBenches)) return hillside;
  return std::min(pit, hillside);
}

using Line = std::vector<Vec3>;

// Toes and crests of all faces; where the hillside is lower a line is on the hillside.
std::vector<Line> breaklines() {
  std::vector<Line> lines;
  constexpr int kCorners = 72;
  const auto add = [&](double radius, double level) {
    Line line;
    for (int i = 0; i <= kCorners; ++i) {
      const Vec2 p = at(radius, 2 * kPi * (i % kCorners) / kCorners);
      line.push_back({p.x, p.y, std::min(level, hillside_m(p))});
    }
    lines.push_back(line);
  };
  for (int i = 0; i < kBenches; ++i) {
    add(toe_m(i), level_m(i));
    add(crest_m(i), level_m(i + 1));
  }
  // The rim: the last bench's level below, the hillside above.
  Line foot, rim;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * kPi * (i % kCorners) / kCorners;
    const Vec2 inner = at(toe_m(kBenches), angle), outer = at(toe_m(kBenches) + 5, angle);
    foot.push_back({inner.x, inner.y, std::min(level_m(kBenches), hillside_m(inner))});
    rim.push_back({outer.x, outer.y, hillside_m(outer)});
  }
  lines.push_back(foot);
  lines.push_back(rim);
  return lines;
}

std::vector<Vec3> points() {
  std::vector<Vec3> all;
  const auto add = [&](Vec2 p) { all.push_back({p.x, p.y, height_m(p)}); };
  constexpr int kAround = 25; // the square's border is surveyed evenly
  for (int i = 0; i < kAround; ++i) {
    const double s = kSide_m * i / (kAround - 1);
    add({s, 0});
    add({s, kSide_m});
    if (i > 0 && i + 1 < kAround) {
      add({0, s});
      add({kSide_m, s});
    }
  }
  std::mt19937_64 engine(1871); // fixed by the standard, so the same on every machine
  const auto anywhere = [&] { return kSide_m * (static_cast<double>(engine() >> 11U) * 0x1p-53); };
  for (int i = 0; i < 1400; ++i) {
    const double east = anywhere();
    const Vec2 p{east, anywhere()};
    if (!is_at_an_edge(p)) add(p);
  }
  return all;
}

class TextFile {
public:
  explicit TextFile(const std::string& path) : file_(std::fopen(path.c_str(), "w")) {
    if (!file_) {
      std::perror(path.c_str());
      std::exit(1);
    }
  }
  ~TextFile() { std::fclose(file_); }
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;
  std::FILE* get() const { return file_; }

private:
  std::FILE* file_;
};

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_quarry OUT_DIR\n", stderr);
    return 2;
  }
  const std::string folder = argv[1];
  const TextFile csv(folder + "/quarry_points.csv");
  std::fputs("easting,northing,height\n", csv.get());
  for (const Vec3& p : points())
    std::fprintf(csv.get(), "%.2f,%.2f,%.2f\n", kCorner.x + p.x, kCorner.y + p.y, p.z);

  const TextFile json(folder + "/quarry_breaklines.geojson");
  std::fputs("{ \"type\": \"FeatureCollection\",\n"
             "  \"crs\": { \"type\": \"name\", \"properties\": { \"name\": "
             "\"urn:ogc:def:crs:EPSG::32631\" } },\n  \"features\": [\n",
             json.get());
  const std::vector<Line> lines = breaklines();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::fprintf(json.get(),
                 "    { \"type\": \"Feature\", \"properties\": {}, \"geometry\": { \"type\": "
                 "\"LineString\", \"coordinates\": [");
    for (std::size_t k = 0; k < lines[i].size(); ++k)
      std::fprintf(json.get(), "%s[%.2f,%.2f,%.2f]", k > 0 ? ", " : "", kCorner.x + lines[i][k].x,
                   kCorner.y + lines[i][k].y, lines[i][k].z);
    std::fprintf(json.get(), "] } }%s\n", i + 1 < lines.size() ? "," : "");
  }
  std::fputs("  ]\n}\n", json.get());
  return 0;
}
