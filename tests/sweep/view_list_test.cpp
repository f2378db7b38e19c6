// SPDX-License-Identifier: GPL-3.0-or-later
// The views of a sweep against nested loops, and what their drawings are called.
#include "cli/options/options.hpp"
#include "cli/sweep/view_list.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/support/random.hpp"

#include <algorithm>
#include <set>

using namespace orograph;

namespace {

std::vector<double> rising_values(Random& random, int count) {
  std::set<double> values;
  while (static_cast<int>(values.size()) < count)
    values.insert(random.whole(0, 4000) / random.pick({1.0, 4.0, 10.0}));
  return {values.begin(), values.end()};
}

std::vector<Axis> random_axes(Random& random, bool same_length) {
  std::vector<Axis> axes;
  const int length = random.whole(1, 7);
  for (const Parameter parameter : {Parameter::azimuth, Parameter::elevation, Parameter::distance,
                                    Parameter::fov, Parameter::exaggeration, Parameter::profiles})
    if (random.chance(0.4))
      axes.push_back({parameter, rising_values(random, same_length ? length : random.whole(1, 5))});
  return axes;
}

std::string fault_of(const SweepSettings& settings) {
  try {
    ViewList(settings, {});
    return "";
  } catch (const UsageError& error) {
    return error.what();
  }
}

double value_in(const RenderSettings& settings, Parameter parameter) {
  switch (parameter) {
  case Parameter::azimuth:
    return settings.map.view.from_azimuth.in_degrees();
  case Parameter::elevation:
    return settings.map.view.from_elevation.in_degrees();
  case Parameter::distance:
    return settings.map.view.distance_m.value_or(-1);
  case Parameter::fov:
    return settings.map.view.field_of_view ? settings.map.view.field_of_view->in_degrees() : -1;
  case Parameter::exaggeration:
    return settings.map.view.exaggeration.value_or(-1);
  default:
    return settings.map.style.plan ? std::get<ProfileCount>(*settings.map.style.plan).count : -1;
  }
}

// By a template, or what is wrong with it.
std::string names(const std::string& name_template, const std::vector<Axis>& axes,
                  const std::vector<NamedView>& listed = {}) {
  SweepSettings settings;
  settings.name_template = name_template;
  settings.axes = axes;
  settings.views = listed;
  try {
    const ViewList views(settings, {});
    std::string all;
    for (std::size_t view = 0; view < views.size(); ++view)
      all += (view > 0 ? " " : "") + views.name(view);
    return all;
  } catch (const UsageError& error) {
    return error.what();
  }
}

const std::vector<Axis> kTwo{{Parameter::azimuth, {5, 120}}, {Parameter::look_azimuth, {-8, 0.25}}};

} // namespace

TEST_CASE("crossed axes are nested loops, the last the innermost") {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    SweepSettings settings;
    settings.axes = random_axes(random, false);
    std::vector<std::vector<double>> expected{{}};
    for (const Axis& axis : settings.axes) {
      std::vector<std::vector<double>> longer;
      for (const auto& before : expected)
        for (const double value : axis.values) {
          longer.push_back(before);
          longer.back().push_back(value);
        }
      expected = longer;
    }
    const ViewList views(settings, {});
    REQUIRE(views.size() == expected.size());
    REQUIRE(view_count(settings.axes, false) == static_cast<double>(expected.size()));
    std::vector<std::string> names;
    for (std::size_t view = 0; view < views.size(); ++view) {
      REQUIRE(views.values(view) == expected[view]);
      names.push_back(views.name(view) + ".svg");
      const RenderSettings render = views.settings(view);
      for (std::size_t axis = 0; axis < settings.axes.size(); ++axis) {
        const Parameter parameter = settings.axes[axis].parameter;
        const double value = expected[view][axis];
        REQUIRE(value_in(render, parameter) ==
                (parameter == Parameter::profiles ? std::floor(value) : value));
      }
    }
    // Values rise, so names do.
    CHECK(std::is_sorted(names.begin(), names.end()));
    CHECK(std::set(names.begin(), names.end()).size() == names.size());
  }
}

TEST_CASE("zipped axes go together") {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    SweepSettings settings;
    settings.zipped = true;
    settings.axes = random_axes(random, true);
    const ViewList views(settings, {});
    REQUIRE(views.size() == (settings.axes.empty() ? 1 : settings.axes.front().values.size()));
    REQUIRE(view_count(settings.axes, true) == static_cast<double>(views.size()));
    for (std::size_t view = 0; view < views.size(); ++view)
      for (std::size_t axis = 0; axis < settings.axes.size(); ++axis)
        REQUIRE(views.values(view)[axis] == settings.axes[axis].values[view]);
  }
  SweepSettings settings;
  settings.zipped = true;
  settings.axes = {{Parameter::azimuth, {1, 2, 3}}, {Parameter::fov, {4, 5}}};
  CHECK(fault_of(settings).starts_with("--zip: --azimuth has 3 values and --fov 2: "));
  // A single value goes with all.
  settings.axes = {
      {Parameter::azimuth, {7}}, {Parameter::fov, {4, 5}}, {Parameter::profiles, {60}}};
  const ViewList views(settings, {});
  REQUIRE(views.size() == 2);
  CHECK(views.values(1) == std::vector<double>{7, 5, 60});
}

TEST_CASE("views of a list come first, with their names") {
  SweepSettings settings;
  settings.views_file = "list.toml";
  settings.views = {{"north", {}}, {"", {}}, {"á-3", {}}};
  settings.views[2].view.exaggeration = 7;
  settings.axes = {{Parameter::profiles, {5, 10}}};
  const ViewList views(settings, {});
  REQUIRE(views.size() == 6);
  CHECK(views.name(0) == "view-north_profiles-05");
  CHECK(views.name(3) == "view-1_profiles-10");
  CHECK(views.name(4) == "view-á-3_profiles-05");
  const RenderSettings render = views.settings(5);
  REQUIRE(render.map.view.file);
  CHECK(render.map.view.file->exaggeration == 7);
  CHECK(render.map.view.file_name == "list.toml");
  CHECK(std::get<ProfileCount>(*render.map.style.plan).count == 10);
}

TEST_CASE("more views than anybody means are told, and drawn when they are meant") {
  SweepSettings settings;
  std::vector<double> hundred(100);
  for (std::size_t i = 0; i < hundred.size(); ++i) hundred[i] = static_cast<double>(i);
  settings.axes = {{Parameter::azimuth, hundred}, {Parameter::elevation, hundred}};
  CHECK(ViewList(settings, {}).size() == 10000);
  settings.axes.push_back({Parameter::fov, {10, 20}});
  CHECK(fault_of(settings).find("20000 views: give --yes") != std::string::npos);
  settings.many = true;
  CHECK(ViewList(settings, {}).size() == 20000);
}

TEST_CASE("a full turn ends where it begins, unless something else goes on") {
  const auto azimuths = [](std::vector<std::string> options) {
    options.insert(options.begin(), {"dem.tif", "out"});
    const auto settings = parse_sweep(options);
    REQUIRE(settings);
    for (const Axis& axis : settings->axes)
      if (axis.parameter == Parameter::azimuth || axis.parameter == Parameter::look_azimuth)
        return axis.values;
    return std::vector<double>{};
  };
  CHECK(azimuths({"--azimuth", "0:360:90"}) == std::vector<double>{0, 90, 180, 270});
  CHECK(azimuths({"--azimuth", "90:-270:-90"}) == std::vector<double>{90, 0, -90, -180});
  CHECK(azimuths({"--azimuth", "-180,0,180"}) == std::vector<double>{-180, 0});
  CHECK(azimuths({"--azimuth", "0:350:70"}).size() == 6);
  CHECK(azimuths({"--azimuth", "360"}) == std::vector<double>{360});
  CHECK(azimuths({"--eye", "1,2", "--look-azimuth", "0:360:180"}) == std::vector<double>{0, 180});
  CHECK(azimuths({"--azimuth", "0:360:90", "--elevation", "10:50:10", "--zip"}).size() == 5);
}

TEST_CASE("templates of names") {
  CHECK(names("", {}) == "view");
  CHECK(names("", {{Parameter::fov, {30}}}) == "view");
  CHECK(names("", {{Parameter::fov, {9, 10, 100}}}) == "fov-009 fov-010 fov-100");
  CHECK(names("", {{Parameter::fov, {0.5, 10, 2.25}}}) == "fov-00.50 fov-10.00 fov-02.25");
  CHECK(names("", {{Parameter::pitch, {-10, -5, 0, 5}}}) ==
        "pitch--10 pitch--05 pitch-00 pitch-05");
  CHECK(names("", kTwo) == "azimuth-005_look-azimuth--8.00 azimuth-005_look-azimuth-0.25 "
                           "azimuth-120_look-azimuth--8.00 azimuth-120_look-azimuth-0.25");
  CHECK(names("{index}", {{Parameter::fov, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}}}) ==
        "00 01 02 03 04 05 06 07 08 09 10");
  CHECK(names("a{azimuth}b{index}{index}", kTwo) == "a005b00 a005b11 a120b22 a120b33");
  CHECK(names("only", {{Parameter::fov, {30}}}) == "only");
  CHECK(names("{fov}", {{Parameter::fov, {30}}}) == "30");
  CHECK(names("{view}", {}, {{"a", {}}, {"", {}}}) == "a 1");
}

TEST_CASE("templates that can't be used") {
  const auto refused = [](const std::string& name_template, const std::string& words) {
    const std::string fault = names(name_template, kTwo);
    INFO(name_template << ": " << fault);
    CHECK(fault.find(words) != std::string::npos);
  };
  refused("{elevation}", "there is no {elevation} here: its fields may be {index}, {azimuth}, "
                         "{look-azimuth}");
  refused("{}", "there is no {} here");
  refused("{Index}", "there is no {Index} here");
  refused("{ index}", "there is no { index} here");
  refused("{index", "a brace has no partner");
  refused("index}", "a brace has no partner");
  refused("{{index}}", "a brace has no partner");
  refused("}{", "a brace has no partner");
  refused("a/{index}", "names hold no slash");
  refused("../{index}", "names hold no slash");
  refused("a\n{index}", "control character");
  refused(".{index}", "'.0' begins with a point");
  refused("only", "views 0 and 1 would both be called 'only': put what differs into --name");
  refused("{azimuth}", "views 0 and 1 would both be called '005'");
  refused(std::string(250, 'a') + "{index}", "is too long for a name");
}

TEST_CASE("names of a list can't clash, hide or lead elsewhere") {
  CHECK(names("", {}, {{"a", {}}, {"a", {}}}).find("views 0 and 1 would both be called") == 0);
  CHECK(names("", {}, {{"1", {}}, {"", {}}}).find("views 0 and 1 would both be called") == 0);
  CHECK(names("{view}", {}, {{".orograph-", {}}, {"b", {}}}).find("begins with a point") !=
        std::string::npos);
}
