// SPDX-License-Identifier: GPL-3.0-or-later
// Where patches of different cells meet nothing shows: profiles bend no more than elsewhere in the
// larger cells, and silhouettes are no denser.
#include "map/draw_map.hpp"
#include "placing/level_of_detail.hpp"
#include "placing/placed_view.hpp"
#include "tests/catch.hpp"
#include "tests/support/plane_terrain.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orograph::patch_seams_test {
namespace {

// How large the cells of a patchwork are, by place, in metres: a triangle's longer side along the
// lattice, which of those that parted cells have is the whole cell's for one at least.
class CellSizes {
public:
  explicit CellSizes(const Tin& tin) {
    std::vector<Box2> boxes;
    double least = kInfinity;
    for (const auto& corners : tin.triangles) {
      Box2& box = boxes.emplace_back();
      for (const std::uint32_t corner : corners) {
        box.include({tin.vertices_m[corner].x, tin.vertices_m[corner].y});
        all_.include({tin.vertices_m[corner].x, tin.vertices_m[corner].y});
      }
      least = std::min(least, side_m(box));
    }
    unit_m_ = least;
    across_ = static_cast<std::size_t>(std::ceil(all_.width() / unit_m_)) + 1;
    const auto down = static_cast<std::size_t>(std::ceil(all_.height() / unit_m_)) + 1;
    sizes_m_.assign(across_ * down, 0);
    for (const Box2& box : boxes) {
      const double size_m = side_m(box);
      for (double y = box.low.y + unit_m_ / 2; y < box.high.y; y += unit_m_)
        for (double x = box.low.x + unit_m_ / 2; x < box.high.x; x += unit_m_) {
          double& here = sizes_m_[index({x, y})];
          here = std::max(here, size_m);
        }
    }
  }

  double unit_m() const { return unit_m_; }

  struct Around {
    double least_m, most_m; ///< 0 beside the terrain
  };
  // Of the cells a distance away, aslant and straight.
  Around around(Vec2 at, double away_m) const {
    Around out{kInfinity, 0};
    for (const double x : {-away_m, 0.0, away_m})
      for (const double y : {-away_m, 0.0, away_m}) {
        if (x == 0 && y == 0) continue;
        const double size_m = of({at.x + x, at.y + y});
        out = {std::min(out.least_m, size_m), std::max(out.most_m, size_m)};
      }
    return out;
  }

private:
  static double side_m(const Box2& box) { return std::max(box.width(), box.height()); }
  std::size_t index(Vec2 at) const {
    return static_cast<std::size_t>((at.y - all_.low.y) / unit_m_) * across_ +
           static_cast<std::size_t>((at.x - all_.low.x) / unit_m_);
  }
  double of(Vec2 at) const {
    return at.x > all_.low.x && at.x < all_.high.x && at.y > all_.low.y && at.y < all_.high.y
               ? sizes_m_[index(at)]
               : 0;
  }

  Box2 all_{};
  double unit_m_ = 0;
  std::size_t across_ = 0;
  std::vector<double> sizes_m_;
};

struct Mean {
  double sum = 0, count = 0;
  void add(double value) { sum += value, count += 1; }
  double value() const { return sum / count; }
};

// Lengths in the visibility plane. Profiles are evenly spaced on the page, so theirs tells how much
// of it that is.
struct Ink {
  double profiles = 0, silhouettes = 0;
  double silhouettes_of_page() const { return silhouettes / profiles; }
};

struct Seams {
  Mean turns, turns_in_larger, turns_in_smaller; ///< in radians, on seams and in the cells beside
  Ink near, farther; ///< in larger cells: within one of them from a seam, and within four
};

// Adds up what is visible on seams and beside them.
class SeamObserver : public LineObserver {
public:
  SeamObserver(const Tin& tin, Seams& seams) : sizes_(tin), seams_(seams) {}

  void see(const SeenProfile& seen) override {
    const View& view = seen.sector.view;
    const Profile& profile = seen.profile;
    std::size_t next = 0;
    for (std::size_t i = 1; i + 1 < profile.size(); ++i) {
      if (profile.after[i - 1] != Span::slope || profile.after[i] != Span::slope) continue;
      const auto at = [&](std::size_t k) {
        return ProfilePoint{profile.u_m[k], profile.depth_m, profile.z_m[k]};
      };
      const Vec2 before = project(view, at(i - 1)), here = project(view, at(i)),
                 after = project(view, at(i + 1));
      while (next < seen.visible.size() && seen.visible[next].x_end < here.x) ++next;
      if (next == seen.visible.size() || seen.visible[next].x_begin > here.x) continue;
      const Vec3 ground = to_ground_m(view, at(i));
      const Vec2 place{ground.x, ground.y};
      const auto close = sizes_.around(place, sizes_.unit_m() / 4);
      if (close.least_m == 0) continue;
      const Vec2 in = here - before, out = after - here;
      const double turn = std::abs(std::atan2(cross(in, out), dot(in, out)));
      const auto wide = sizes_.around(place, 2.5 * close.most_m);
      if (close.most_m > 1.5 * close.least_m)
        seams_.turns.add(turn);
      else if (wide.most_m > 1.5 * wide.least_m && wide.least_m > 0)
        (close.most_m > 0.7 * wide.most_m ? seams_.turns_in_larger : seams_.turns_in_smaller)
            .add(turn);
    }
    for (const Piece& piece : seen.visible) {
      const double x = (piece.x_begin + piece.x_end) / 2;
      add_ink(view, {x * profile.depth_m, profile.depth_m, 0}, piece.x_end - piece.x_begin,
              &Ink::profiles);
    }
  }

  void see(const SeenLines& seen) override {
    const View& view = seen.sector.view;
    for (const LinePart& part : seen.visible) {
      if (seen.lines.line(part.line).kind != LineKind::silhouette) continue;
      const ProfilePoint from = seen.lines.point(part.line, part.t_begin),
                         to = seen.lines.point(part.line, part.t_end);
      add_ink(view, seen.lines.point(part.line, (part.t_begin + part.t_end) / 2),
              length(project(view, to) - project(view, from)), &Ink::silhouettes);
    }
  }

private:
  void add_ink(const View& view, ProfilePoint at, double length, double Ink::*kind) {
    const Vec3 ground = to_ground_m(view, at);
    const auto here = sizes_.around({ground.x, ground.y}, sizes_.unit_m() / 64);
    if (here.least_m == 0 || here.most_m > 1.5 * here.least_m) return;
    const double cell_m = here.most_m;
    const auto is_seam_within = [&](double away_m) {
      return sizes_.around({ground.x, ground.y}, away_m).least_m < 0.7 * cell_m;
    };
    if (is_seam_within(cell_m))
      seams_.near.*kind += length;
    else if (is_seam_within(4 * cell_m))
      seams_.farther.*kind += length;
  }

  CellSizes sizes_;
  Seams& seams_;
};

} // namespace

TEST_CASE("nothing shows where patches meet") {
  for (const double noise_m : {0.0, 12.0}) {
    Seams seams;
    for (std::uint64_t seed = 1; seed <= last_seed(24); ++seed) {
      Random random(700 + seed);
      const TerrainData whole = plane_terrain(220, 220, [&](double x, double y) {
        return 300 * std::sin(x * 3) * std::cos(y * 2.3) + 120 * std::sin(11 * x + 7 * y) +
               noise_m * std::sin(90 * x) * std::sin(101 * y);
      });
      MapSpec spec;
      spec.style.detail.cell_mm = random.pick({1.5, 2.5});
      spec.view.eye_map = GivenPlace{random.between(1500, 5000), random.between(-5000, -1500)};
      spec.view.eye_height_m = random.pick({60.0, 300.0});
      spec.view.look_azimuth = Angle::degrees(random.between(0, 360));
      TerrainOfView terrain(whole, spec.view);
      const auto level = choose_level(terrain, spec, nullptr);
      REQUIRE(level);
      const auto* tin = std::get_if<Tin>(&terrain->surface);
      REQUIRE(tin);
      SeamObserver observer(*tin, seams);
      Instruments instruments;
      instruments.observers = {&observer};
      draw_map(
          *terrain, placed_view(terrain, spec), spec, [](double) {}, instruments);
    }
    WARN("noise of " << noise_m << " m: profiles turn by " << seams.turns.value() << " at "
                     << seams.turns.count << " places on seams, " << seams.turns_in_larger.value()
                     << " in larger cells beside them, " << seams.turns_in_smaller.value()
                     << " in smaller");
    CHECK(seams.turns.count > 1000);
    CHECK(seams.turns.value() < seams.turns_in_larger.value());
    // A fourth more than farther away would be a seam that one sees.
    CHECK(seams.near.silhouettes_of_page() < 1.25 * seams.farther.silhouettes_of_page());
  }
}

} // namespace orograph::patch_seams_test
