// SPDX-License-Identifier: GPL-3.0-or-later
// The run report.
#include "cli/report/run_report.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/cli/made_files.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

using namespace orograph;
using Json = nlohmann::ordered_json;

TEST_CASE("a report's words and values") {
  RunReport report;
  report.input.paths = {"a.tif", "b.tif"};
  report.view.projection = "perspective";
  report.view.eye = Vec3{1, 2, 3};
  report.view.homography.m = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  report.profiles = {.spacing = "0.6mm", .depths_m = {10, 20.5}};
  report.counts.strokes = 7;
  report.seconds.read = 0.25;
  report.libraries = {{"gdal", "3.6.2"}};
  report.error_budget.simplification_mm = 0.02;
  report.error_budget.rounding_mm = 0.001;
  const Json json = Json::parse(report_text(report));
  CHECK(json["schema"] == 1);
  CHECK(json["input"]["paths"] == Json{"a.tif", "b.tif"});
  CHECK(json["program"]["name"] == "orograph");
  CHECK(json["program"].contains("commit"));
  CHECK(json["view"]["eye"] == Json({1, 2, 3}));
  CHECK(json["view"]["homography"] == Json({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
  CHECK(json["view"]["exaggeration_auto"] == false);
  CHECK(json["profiles"]["count"] == 2);
  CHECK(json["profiles"]["depths"] == Json({10, 20.5}));
  CHECK(json["counts"]["strokes"] == 7);
  CHECK(json["seconds"]["read"] == 0.25);
  CHECK(json["libraries"]["gdal"] == "3.6.2");
  // The sum of two decimal numbers, to rounding.
  CHECK(std::abs(json["error_budget_mm"]["total"].get<double>() - 0.021) < 1e-15);
  CHECK(report_text(report).starts_with("{\n  \"schema\": 1,\n"));
}

TEST_CASE("what isn't known is null, or unknown, and never 0") {
  RunReport report;
  report.error_budget.level_of_detail_mm.reset();
  const Json json = Json::parse(report_text(report));
  CHECK(json["view"]["eye"].is_null());
  CHECK(json["view"]["distance_m"].is_null());
  CHECK(json["seconds"]["clip"].is_null());
  CHECK(json["error_budget_mm"]["level_of_detail"] == "unknown");
  CHECK(json["error_budget_mm"]["total"] == "unknown");
}

TEST_CASE("a path that isn't UTF-8 still gives JSON") {
  RunReport report;
  report.input.paths = {"caf\xe9.tif"};
  CHECK(Json::accept(report_text(report)));
}

TEST_CASE("a report is written whole, and over another only when told") {
  const MadeFolder folder;
  const std::string path = folder.write("r.json", "old");
  CHECK_THROWS_AS(write_report({}, path, false), Error);
  CHECK(folder.read("r.json") == "old");
  write_report({}, path, true);
  CHECK(folder.read("r.json") == report_text({}));
  CHECK_THROWS_AS(write_report({}, folder.path("nowhere/r.json"), true), Error);
  CHECK(folder.names() == std::vector<std::string>{"r.json"});
}
