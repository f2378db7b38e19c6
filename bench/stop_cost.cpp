// SPDX-License-Identifier: GPL-3.0-or-later
// How long it takes until a call that is told to stop is back: views of a terrain in memory are
// stopped at even shares of the time that they take whole, and reading a file and making a TIN as
// well. A line a call: its seconds, the median and the greatest latency, and at which share of the
// call that was. Latency is time on the clock.
//
//   stop_cost smooth|rough [VERTICES [STOPS [VIEW]]]     rough, 1500, 100 and all views
#include "bench/grounds.hpp"
#include "orograph.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace orograph;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct Call {
  std::string name;
  std::function<void(const Control&)> run;
};

// The latency of a stop after so many seconds, or NaN where the call was done before.
double latency_s(const Call& call, double after_s) {
  std::stop_source stop;
  Control control;
  control.stop = stop.get_token();
  Clock::time_point asked;
  std::jthread alarm([&](const std::stop_token&) {
    std::this_thread::sleep_for(std::chrono::duration<double>(after_s));
    asked = Clock::now();
    stop.request_stop();
  });
  try {
    call.run(control);
    return std::nan("");
  } catch (const Error& error) {
    const Clock::time_point back = Clock::now();
    alarm.join();
    if (error.code() != ErrorCode::cancelled) throw;
    return std::chrono::duration<double>(back - asked).count();
  }
}

void measure(const Call& call, int stops) {
  std::stop_source never;
  Control control;
  control.stop = never.get_token();
  const Clock::time_point begin = Clock::now();
  call.run(control);
  const double whole_s = seconds_since(begin);
  struct Stop {
    double latency_ms, share;
  };
  std::vector<Stop> found;
  for (int i = 0; i < stops; ++i) {
    const double share = (i + 0.5) / stops;
    const double latency = latency_s(call, share * whole_s);
    if (!std::isnan(latency)) found.push_back({1e3 * latency, share});
  }
  std::sort(found.begin(), found.end(),
            [](const Stop& a, const Stop& b) { return a.latency_ms < b.latency_ms; });
  if (found.empty())
    std::printf("%-22s %7.3f s whole\n", call.name.c_str(), whole_s);
  else
    std::printf("%-22s %7.3f s whole; stopped %3zu times: median %5.1f ms, greatest %5.1f ms at "
                "%2.0f %%\n",
                call.name.c_str(), whole_s, found.size(), found[found.size() / 2].latency_ms,
                found.back().latency_ms, 100 * found.back().share);
  std::fflush(stdout);
}

GridInput input_of(int side, const std::shared_ptr<std::vector<float>>& heights) {
  GridInput input;
  input.columns = input.rows = side;
  input.heights = std::span<const float>(*heights);
  input.owner = heights;
  input.geotransform = {500000, 30, 0, 5000000, 0, -30};
  input.crs = "EPSG:32632";
  return input;
}

TinInput triangles_of(int side, const std::vector<float>& heights) {
  TinInput input;
  const auto n = static_cast<std::uint32_t>(side);
  for (std::uint32_t row = 0; row < n; ++row)
    for (std::uint32_t column = 0; column < n; ++column)
      input.points.push_back({30.0 * column, -30.0 * row, heights[row * n + column]});
  for (std::uint32_t row = 0; row + 1 < n; ++row)
    for (std::uint32_t column = 0; column + 1 < n; ++column) {
      const std::uint32_t at = row * n + column;
      input.triangles.push_back({at, at + n, at + n + 1});
      input.triangles.push_back({at, at + n + 1, at + 1});
    }
  return input;
}

void write_geotiff(const GridInput& input, const char* path) {
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> dataset(
      GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path, input.columns, input.rows, 1,
                                                               GDT_Float32, nullptr));
  std::array<double, 6> transform = input.geotransform;
  OGRSpatialReference crs;
  crs.importFromEPSG(32632);
  dataset->SetGeoTransform(transform.data());
  dataset->SetSpatialRef(&crs);
  const auto heights = std::get<std::span<const float>>(input.heights);
  if (dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, input.columns, input.rows,
                                          const_cast<float*>(heights.data()), input.columns,
                                          input.rows, GDT_Float32, 0, 0) != CE_None)
    std::exit(1);
}

} // namespace

int main(int argc, char** argv) {
  const bool smooth = argc > 1 && std::strcmp(argv[1], "smooth") == 0;
  const int side = argc > 2 ? std::atoi(argv[2]) : 1500;
  const int stops = argc > 3 ? std::atoi(argv[3]) : 100;
  const std::string only = argc > 4 ? argv[4] : "";
  const Grid made = kGrounds[smooth ? 0 : 1].made(side);
  const auto& values = std::get<Heights<float>>(made.heights_m);
  const auto heights = std::make_shared<std::vector<float>>(values.begin(), values.end());
  const auto with_holes = std::make_shared<std::vector<float>>(*heights);
  for (std::size_t i = 0; i < with_holes->size(); i += 5)
    if (i / 97 % 3 == 0) (*with_holes)[i] = std::nanf("");
  const auto with_lakes = std::make_shared<std::vector<float>>(*heights);
  for (float& height : *with_lakes) height = std::max(height, 2000.0F);

  const auto measure_draw = [&](const char* name, const GridInput& input, const auto& change) {
    if (!only.empty() && only != name) return;
    MapSpec spec;
    change(spec);
    const Terrain terrain = Terrain::of(input);
    measure(
        {name,
         [&](const Control& control) { static_cast<void>(Session(terrain).draw(spec, control)); }},
        stops);
  };
  const GridInput plain = input_of(side, heights);
  const std::vector<LayerSpec> all{"profiles", "edges",       "shores",  "border",
                                   "voids",    "silhouettes", "skyline", "solids"};
  measure_draw("default", plain, [](MapSpec&) {});
  measure_draw("one-a-cell", plain, [](MapSpec& s) { s.style.plan = GroundSpacing{30}; });
  measure_draw("low", plain, [](MapSpec& s) { s.view.from_elevation = Angle::degrees(5); });
  measure_draw("plan", plain, [](MapSpec& s) {
    s.view.from_elevation = Angle::degrees(90);
    s.view.projection = Projection::orthographic;
  });
  measure_draw("eye", plain, [&](MapSpec& s) {
    s.view.eye_map = GivenPlace(500000 + 15.0 * side, 5000000 - 15.0 * side);
    s.view.look_azimuth = Angle::degrees(40);
  });
  measure_draw("down", plain, [](MapSpec& s) {
    s.view.from_elevation = Angle::degrees(90);
    s.view.field_of_view = Angle::degrees(70);
  });
  measure_draw("silhouettes", plain, [](MapSpec& s) {
    s.style.plan = GroundSpacing{30};
    s.style.silhouette_jump = 0;
    s.view.projection = Projection::orthographic;
  });
  measure_draw("all-layers", plain, [&](MapSpec& s) {
    s.style.layers = all;
    s.ground_points = true;
  });
  measure_draw("occluder-profiles", plain, [](MapSpec& s) {
    s.style.occluder = Occluder::profiles;
    s.style.plan = GroundSpacing{30};
  });
  measure_draw("check", plain, [](MapSpec& s) { s.check = 100000; });
  measure_draw("holes", input_of(side, with_holes), [&](MapSpec& s) { s.style.layers = all; });
  measure_draw("lakes", input_of(side, with_lakes), [&](MapSpec&) {});
  GridInput degrees = plain;
  degrees.geotransform = {10, 1.0 / 3600, 0, 47, 0, -1.0 / 3600};
  degrees.crs = "EPSG:4326";
  measure_draw("degrees", degrees, [](MapSpec&) {});
  if (only.empty() || only == "read") {
    const std::string path = "stop_cost.tif";
    write_geotiff(plain, path.c_str());
    measure({"read", [&](const Control& control) { Terrain::read({path}, {}, control); }}, stops);
    ReadOptions fill;
    fill.fill_voids = 20;
    write_geotiff(input_of(side, with_holes), path.c_str());
    measure({"fill voids", [&](const Control& control) { Terrain::read({path}, fill, control); }},
            stops);
    std::remove(path.c_str());
  }
  if (only.empty() || only == "tin") {
    const Terrain tin = Terrain::of(triangles_of(side, *heights));
    measure({"tin", [&](const Control& control) { Session(tin).draw({}, control); }}, stops);
    MapSpec layers;
    layers.style.layers = all;
    measure(
        {"tin, all layers", [&](const Control& control) { Session(tin).draw(layers, control); }},
        stops);
  }
}
