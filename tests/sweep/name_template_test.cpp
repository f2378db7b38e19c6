// SPDX-License-Identifier: GPL-3.0-or-later
// What drawings of a sweep are called.
#include "cli/sweep/view_list.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"

using namespace orograph;

namespace {

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
