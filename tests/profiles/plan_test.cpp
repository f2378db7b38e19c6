// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/error.hpp"
#include "profiles/plan.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"
#include "view/place_view.hpp"
#include "view/sectors.hpp"

namespace orograph::plan_test {
namespace {

// Of the picture plane: at distance 1 in perspective, in metres in a parallel view.
double scale_mm(const View& view) {
  return view.is_perspective() ? 400 : 0.05;
}

Homography on_page(const View& view) {
  const double scale = scale_mm(view);
  return compose({{scale, 0, 100, 0, -scale, 80, 0, 0, 1}}, view.to_picture);
}

// Two vertices are terrain enough for a view.
View view_of(const ViewRequest& request, double near_m = 1, double highest_m = 500) {
  const std::vector<Vec3> vertices{{-2000, -2000, 0}, {2000, 2000, highest_m}};
  BlockedPoints points;
  for (const Vec3& p : vertices) points.boxes.push_back({p, p});
  points.points = [&](std::size_t i) { return std::span(vertices).subspan(i, 1); };
  Box3 box{vertices[0], vertices[1]};
  return place_view(request, {points, {}, box, 250, near_m / kNearShareOfCell}, 0.7);
}

// Height on the page, upwards, of level ground straight ahead: a pinhole whose axis descends.
double page_mm(const View& view, double drop, double depth) {
  const double e = view.elevation.in_radians();
  if (!view.is_perspective()) return scale_mm(view) * depth * std::sin(e);
  const double up = depth * std::sin(e) - drop * std::cos(e);
  const double along = depth * std::cos(e) + drop * std::sin(e);
  return scale_mm(view) * up / along;
}

void check_in_order(const std::vector<double>& depths, double nearest, double farthest) {
  REQUIRE(!depths.empty());
  REQUIRE(depths.front() > nearest);
  REQUIRE(depths.back() < farthest);
  for (std::size_t i = 0; i + 1 < depths.size(); ++i) REQUIRE(depths[i] < depths[i + 1]);
}

// Profiles stand in the middle of equal steps from the nearest to the farthest ground.
void check_even(const std::vector<double>& depths, const View& view, const PlanGround& ground) {
  const double drop = view.eye_z_m - ground.mean_z_m;
  const double low = page_mm(view, drop, ground.nearest_m);
  const double high = page_mm(view, drop, ground.farthest_m);
  const double step = (high - low) / static_cast<double>(depths.size());
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const double expected = low + (static_cast<double>(i) + 0.5) * step;
    REQUIRE(std::abs(page_mm(view, drop, depths[i]) - expected) <= 1e-9);
  }
}

} // namespace

TEST_CASE("profiles are even on the page for a plane at the mean height") {
  for (std::uint64_t seed = 1; seed <= last_seed(300); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    ViewRequest request;
    const bool parallel = random.chance(0.5);
    request.projection = parallel ? Projection::orthographic : Projection::perspective;
    request.from_elevation =
        Angle::degrees(parallel ? random.pick({90.0, 10.0, random.between(6, 90)}) // 6: no tilt
                                : random.between(10, 50));
    request.roll = Angle::degrees(random.pick({0.0, 90.0, random.between(0, 360)}));
    request.distance_m = 8000;
    const View view = view_of(request);
    PlanGround ground{random.between(100, 3000), random.between(3500, 9000), 250, 500};
    if (parallel) ground.nearest_m -= 3000;
    const int count = random.pick({1, 2, 7, 100, 1000});
    const auto depths = plan_depths(ProfileCount{count}, ground, view, on_page(view));
    REQUIRE(depths.size() == static_cast<std::size_t>(count));
    check_in_order(depths, ground.nearest_m, ground.farthest_m);
    check_even(depths, view, ground);

    const double drop = view.eye_z_m - ground.mean_z_m;
    const double length =
        page_mm(view, drop, ground.farthest_m) - page_mm(view, drop, ground.nearest_m);
    const double spacing = random.pick({0.6, 3.0, 2 * length});
    const auto spaced = plan_depths(PageSpacing{spacing}, ground, view, on_page(view));
    // No fewer than go on two thirds of the picture's height.
    const double way = std::max(length, 2.0 / 3 * scale_mm(view) * view.window.height());
    REQUIRE(spaced.size() == static_cast<std::size_t>(std::max(1.0, std::round(way / spacing))));
    check_even(spaced, view, ground);
  }
}

TEST_CASE("a spacing on the ground is even on the ground, from half a step behind its beginning") {
  ViewRequest request;
  request.projection = Projection::orthographic;
  const View view = view_of(request);
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    const PlanGround ground{random.between(-5000, 0), random.between(1, 5000), 0, 100};
    const double spacing = random.pick({5.0, random.between(1, 1000), 1e6});
    CAPTURE(ground.nearest_m, ground.farthest_m, spacing);
    const auto depths = plan_depths(GroundSpacing{spacing}, ground, view, on_page(view));
    check_in_order(depths, ground.nearest_m, ground.farthest_m);
    const double extent = ground.farthest_m - ground.nearest_m;
    if (spacing > 2 * extent) {
      REQUIRE(depths.size() == 1);
      continue;
    }
    REQUIRE(std::abs(static_cast<double>(depths.size()) - extent / spacing) <= 0.5 + 1e-9);
    for (std::size_t i = 0; i < depths.size(); ++i)
      REQUIRE(std::abs(depths[i] - ground.nearest_m - (static_cast<double>(i) + 0.5) * spacing) <=
              1e-11);
  }
  CHECK_THROWS_AS(plan_depths(GroundSpacing{1e-3}, {0, 5000, 0, 100}, view, on_page(view)), Error);
  CHECK_THROWS_AS(plan_depths(PageSpacing{1e-9}, {0, 5000, 0, 100}, view, on_page(view)), Error);
}

TEST_CASE("a spacing of whole rows goes through rows, in the middle of steps or next behind it") {
  int in_rows = 0, between = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(500); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    ViewRequest request;
    const bool parallel = random.chance(0.5);
    request.projection = parallel ? Projection::orthographic : Projection::perspective;
    const View view = view_of(request);
    const int rows = random.pick({random.whole(2, 4), random.whole(5, 300), random.whole(5, 300)});
    const double step = random.between(1, 100), first = random.between(-900, 900);
    PlanGround ground{first, first + (rows - 1) * step, 0, 100};
    for (int row = 0; row < rows; ++row) ground.row_depths_m.push_back(first + row * step);
    const int every = random.pick({1, 2, 3, random.whole(1, 20)});
    // As good as whole, and not.
    const double digits = random.pick({0.0, 0.04 / rows, -0.04 / rows}),
                 wrong = random.pick({0.1 / rows, 0.3});
    const auto plan = [&](double off) {
      return plan_depths(GroundSpacing{every * step * (1 + off)}, ground, view, on_page(view));
    };
    CAPTURE(rows, every, step, first, parallel);
    std::vector<double> expected;
    for (int row = 0; row < rows - 1; ++row)
      if (row % every == (every + 1) / 2 % every && row >= (every + 1) / 2 &&
          (parallel || ground.row_depths_m[static_cast<std::size_t>(row)] > view.near_m))
        expected.push_back(ground.row_depths_m[static_cast<std::size_t>(row)]);
    const auto depths = plan(digits);
    if (expected.empty() || every >= rows - 1) { // no row to go through
      REQUIRE(depths.size() <= 1);
      continue;
    }
    ++in_rows;
    REQUIRE(depths == expected);
    // Never farther apart from even spacing than half a row.
    const PlanGround no_rows{ground.nearest_m, ground.farthest_m, 0, 100};
    const auto even = plan_depths(GroundSpacing{every * step}, no_rows, view, on_page(view));
    if (parallel)
      for (std::size_t i = 0; i < std::min(depths.size(), even.size()); ++i)
        REQUIRE(std::abs(depths[i] - even[i]) <= 0.5 * step * (1 + 1e-9));
    if (every % 2 == 0) continue;
    const auto beside = plan(wrong);
    between += beside != depths ? 1 : 0;
    if (parallel)
      REQUIRE(std::abs(beside.front() - first - 0.5 * every * step * (1 + wrong)) <= 1e-9);
  }
  CHECK(in_rows > enough(300));
  CHECK(between > enough(100));
}

TEST_CASE("views too flat for the plane still get all their profiles, in order") {
  for (std::uint64_t seed = 1; seed <= last_seed(200); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    ViewRequest request;
    request.projection = random.pick({Projection::orthographic, Projection::perspective});
    request.from_elevation = Angle::degrees(random.pick({0.0, 1e-9, 1.0, 5.0}));
    const View view = view_of(request);
    const double relief = random.pick({0.0, 500.0});
    const PlanGround ground{100, 6000, random.pick({250.0, view.eye_z_m, 400.0}), relief};
    const int count = random.pick({1, 10, 500});
    const auto depths = plan_depths(ProfileCount{count}, ground, view, on_page(view));
    REQUIRE(depths.size() == static_cast<std::size_t>(count));
    check_in_order(depths, ground.nearest_m, ground.farthest_m);
  }
}

// The eye stands on the ground or flies over it, and looks anywhere, up too.
TEST_CASE("an eye in the terrain gets all its profiles, most of them for what the page shows") {
  int empty = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(2000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    ViewRequest request;
    request.eye_m = Vec3{0, 0, random.pick({2.0, 260.0, 600.0, 5000.0})};
    const double climb = random.between(-55, 60);
    request.look_at_m = Vec3{0, 1000, request.eye_m->z + 1000 * std::tan(climb * 3.14159 / 180)};
    request.field_of_view = Angle::degrees(random.pick({10.0, 30.0, 50.0}));
    request.roll = Angle::degrees(random.pick({0.0, 0.0, 90.0, 180.0, random.between(0, 360)}));
    const View view = view_of(request, 0.3, climb > 0 ? 1e5 : -1e5); // where it looks
    const PlanGround ground{-2000, 2000, 250, 500};
    const int count = random.pick({1, 10, 300});
    CAPTURE(climb, request.eye_m->z, view.roll.in_degrees(), request.field_of_view->in_degrees());
    const auto depths = plan_depths(ProfileCount{count}, ground, view, on_page(view));
    const DepthRange shown = shown_depths(ground, view);
    if (shown.nearest_m == shown.farthest_m) { // the page shows no ground at all
      REQUIRE(depths.size() == 1);
      ++empty;
      continue;
    }
    REQUIRE(depths.size() == static_cast<std::size_t>(count));
    check_in_order(depths, shows_beside(view) ? ground.nearest_m : view.near_m, ground.farthest_m);
    for (const double depth : depths) REQUIRE(std::abs(depth) >= view.near_m);
    // Even on the page can't mean a crowd at the eye's feet.
    const auto away =
        std::count_if(depths.begin(), depths.end(), [](double d) { return std::abs(d) > 20; });
    REQUIRE(away >= count / 2);
    CHECK_NOTHROW(plan_depths(PageSpacing{0.6}, ground, view, on_page(view)));
  }
  CHECK(empty < 500);
}

// By definition: a depth may show ground if some ray of the window meets some height there.
TEST_CASE("the depths that a window may show, by rays all over it") {
  int narrow = 0, behind = 0;
  for (std::uint64_t seed = 1; seed <= last_seed(1000); ++seed) {
    Random random(seed);
    INFO("seed " << seed);
    ViewRequest request;
    request.eye_m = Vec3{0, 0, random.pick({2.0, 600.0, 5000.0})};
    const double climb = random.pick({-89.9, random.between(-89, 60)});
    request.look_at_m = Vec3{0, 1000, request.eye_m->z + 1000 * std::tan(climb * 3.14159 / 180)};
    request.field_of_view = Angle::degrees(random.pick({1.0, 30.0, 120.0}));
    request.roll = Angle::degrees(random.pick({0.0, random.between(0, 360)}));
    const View view = view_of(request, 0.3, climb > 0 ? 1e5 : -1e5);
    const PlanGround ground{-20000, 20000, 250, random.pick({1.0, 500.0})};
    const DepthRange range = shown_depths(ground, view);
    double low = HUGE_VAL, high = -HUGE_VAL; // of what is met
    const double first = shows_beside(view) ? ground.nearest_m : view.near_m;
    for (int x = 0; x <= 40; ++x)
      for (int y = 0; y <= 40; ++y) {
        const Vec3 ray = ray_of_picture(view, {view.window.low.x + view.window.width() * x / 40,
                                               view.window.low.y + view.window.height() * y / 40});
        // In front of a ray's first place there may be ground at the ray's own height there.
        const double at_first = view.eye_z_m + first / ray.z * ray.y;
        if (first > 0 && ray.z > 0 && std::abs(at_first - 250) <= ground.relief_m)
          low = std::min(low, first);
        for (int k = -10; k <= 10; ++k) {
          const double height = 250 + ground.relief_m * k / 10 - view.eye_z_m, t = height / ray.y;
          if (!(t > 0) || t * ray.z < first || t * ray.z > ground.farthest_m) continue;
          low = std::min(low, t * ray.z);
          high = std::max(high, t * ray.z);
        }
      }
    CAPTURE(climb, request.eye_m->z, low, high, range.nearest_m, range.farthest_m);
    if (low > high) continue;
    REQUIRE(range.nearest_m <= low + 1e-6);
    REQUIRE(range.farthest_m >= high - 1e-6);
    narrow += range.farthest_m - range.nearest_m < 10000;
    behind += range.nearest_m < 0;
    // Not much more than that, where all rays go down.
    if (std::ranges::all_of(corner_rays(view), [](Vec3 r) { return r.y < -0.1 * length(r); })) {
      REQUIRE(range.nearest_m >= low - 0.1 * (high - low) - 1);
      REQUIRE(range.farthest_m <= high + 0.1 * (high - low) + 1);
    }
  }
  CHECK(narrow > enough(100));
  CHECK(behind > enough(20));
}

TEST_CASE("profiles go where the page shows ground, as many as fit on it") {
  const PlanGround ground{-15000, 15000, 250, 500};
  ViewRequest request;
  const auto planned = [&](Vec3 eye, Vec3 target, double field) {
    request.eye_m = eye;
    request.look_at_m = target;
    request.field_of_view = Angle::degrees(field);
    const View view = view_of(request, 0.3, target.z > eye.z ? 1e5 : -1e5);
    // As wide as an A4 page shows it.
    const double scale = 277 / view.window.width();
    return plan_depths(PageSpacing{0.6}, ground, view,
                       compose({{scale, 0, 148, 0, -scale, 105, 0, 0, 1}}, view.to_picture))
        .size();
  };
  // 194 mm of height, each side of it once more at the most.
  CHECK(planned({0, -14000, 3000}, {0, 1000, 500}, 1) < 1000);
  // Ground 500 m higher or lower than the plane may be on the page from 18 % nearer or farther
  // away.
  CHECK(planned({0, -14000, 3000}, {0, 1000, 500}, 0.1) < 6000);
  CHECK(planned({0, 0, 5000}, {0, 500, 500}, 1) < 1000);
  CHECK(planned({0, 0, 800}, {0, 200, 600}, 108) < 1000);
  CHECK(planned({0, 0, 2500}, {0, 1e-9, 9000}, 170) < 2000);
  CHECK(planned({0, 0, 2500}, {0, 1, 0}, 60) > 250);
  CHECK(planned({0, 0, 2500}, {0, 1, 0}, 60) < 1000);
}

} // namespace orograph::plan_test
