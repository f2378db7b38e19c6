// SPDX-License-Identifier: GPL-3.0-or-later
// A call that is stopped is back at once, at whatever stage it is, and spoils nothing.
#include "tests/catch.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/library/made_ground.hpp"
#include "tests/support/random.hpp"

#include <cpl_string.h>
#include <dlfcn.h>
#include <gdal_priv.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace orograph::stop_test {

namespace {

double seconds_of(clockid_t clock) {
  timespec at{};
  ::clock_gettime(clock, &at);
  return static_cast<double>(at.tv_sec) + 1e-9 * static_cast<double>(at.tv_nsec);
}

// Sanitizers slow us down; times are looked at without them.
const bool kIsTimed = !is_slow_build();

// A tenth of a second is promised of any terrain. What is done between two looks at the stop token
// grows with a terrain's rows, or with its cells where a loop doesn't look at all. 400² is a 100th
// of 4000², of which 0.1 s would be 1 ms; there are slower and busier machines, and first looks
// at memory have their own whims. What goes over all cells, edges or lines without a look takes
// longer than that: 10 to 70 ms.
const int kSide = kIsTimed ? 400 : 120;
constexpr double kGap_s = 0.008;
// Where every edge is drawn: so small a terrain has few strips and slabs, and each has many of
// them; and a list of half a million parts moves to fresh memory as it grows, which takes 20 to
// 30 ms where pages are slow to come.
constexpr double kGapOfEdges_s = 0.05;
// With all memory given back.
constexpr double kLatency_s = 0.02;

// Of a call on one thread: its looks at the token, in their order, which is always the same. It may
// stop the call at one of them.
class Looks {
public:
  Looks() { current = this; }
  ~Looks() { current = nullptr; }
  Looks(const Looks&) = delete;
  Looks& operator=(const Looks&) = delete;

  std::stop_source stop;
  std::function<void()> before_stop; ///< is called in that look
  std::size_t stop_at = 0;           ///< the how manieth look; 0: none
  std::size_t count = 0;             ///< of all so far
  double greatest_gap_s = 0;         ///< processor time from one to the next
  double late_s = 0;                 ///< a look so long behind the one before it is late
  std::vector<std::size_t> late;     ///< the how manieth are
  const void *gap_from = nullptr, *gap_to = nullptr; ///< places in the code that look
  double stopped_at_s = 0;

  /// Before another call of the same.
  void begin() {
    count = 0;
    greatest_gap_s = 0;
    late.clear();
  }
  void take(const void* from) {
    const double now_s = seconds_of(CLOCK_THREAD_CPUTIME_ID);
    if (count > 0 && now_s - last_s_ > greatest_gap_s) {
      greatest_gap_s = now_s - last_s_;
      gap_from = last_;
      gap_to = from;
    }
    if (count > 0 && now_s - last_s_ >= late_s) late.push_back(count);
    if (++count == stop_at) {
      stopped_at_s = now_s;
      if (before_stop) before_stop();
      stop.request_stop();
    }
    last_ = from;
    // The clock is half of what a look costs.
    last_s_ = count == stop_at ? seconds_of(CLOCK_THREAD_CPUTIME_ID) : now_s;
  }

  static thread_local Looks* current;

private:
  const void* last_ = nullptr;
  double last_s_ = 0;
};
thread_local Looks* Looks::current = nullptr;

void look(const void* from) {
  if (Looks::current) Looks::current->take(from);
}

// For addr2line -Cfipe test_library.
std::string place_of(const void* in_code) {
  Dl_info info{};
  if (!::dladdr(in_code, &info)) return "the end";
  const auto* const begin = static_cast<const char*>(info.dli_fbase);
  std::ostringstream text;
  text << "0x" << std::hex << static_cast<const char*>(in_code) - begin;
  return text.str();
}

} // namespace

// The linker has what calls `throw_if_stopped`, `is_stopped` and `on_all_cores` call these instead
// (CMakeLists.txt), and gives them the true ones by another name.
using Task = std::function<void(std::size_t)>;
extern "C" {
void __real__ZN8orograph16throw_if_stoppedEv();
void __wrap__ZN8orograph16throw_if_stoppedEv();
bool __real__ZN8orograph10is_stoppedEv();
bool __wrap__ZN8orograph10is_stoppedEv();
void __real__ZN8orograph12on_all_coresEmRKSt8functionIFvmEE(std::size_t count, const Task& task);
void __wrap__ZN8orograph12on_all_coresEmRKSt8functionIFvmEE(std::size_t count, const Task& task);
}
void __wrap__ZN8orograph16throw_if_stoppedEv() {
  look(__builtin_return_address(0));
  __real__ZN8orograph16throw_if_stoppedEv();
}
bool __wrap__ZN8orograph10is_stoppedEv() {
  look(__builtin_return_address(0));
  return __real__ZN8orograph10is_stoppedEv();
}
void __wrap__ZN8orograph12on_all_coresEmRKSt8functionIFvmEE(std::size_t count, const Task& task) {
  const void* const from = __builtin_return_address(0);
  __real__ZN8orograph12on_all_coresEmRKSt8functionIFvmEE(count, [&](std::size_t i) {
    look(from); // as it does itself
    task(i);
  });
}

namespace {

// Work that can be stopped, such as a draw.
using Call = std::function<void(const Control&)>;

// Stops a call at a look; by how much later it is back, in processor time.
double latency_s(const Call& call, std::size_t stop_at) {
  Looks looks;
  looks.stop_at = stop_at;
  try {
    call({.stop = looks.stop.get_token(), .jobs = 1});
    FAIL("it wasn't stopped at look " << stop_at);
  } catch (const Error& error) {
    INFO(error.what());
    CHECK(error.code() == ErrorCode::cancelled);
  }
  return seconds_of(CLOCK_THREAD_CPUTIME_ID) - looks.stopped_at_s;
}

// A machine that does other work as well only ever adds to a time: the least of some tries counts.
constexpr int kTries = 5;

// Fails where a call looks too seldom whether it is to be stopped, or takes too long to be back.
void check_latency(const std::string& name, const Call& call, double gap_s = kGap_s) {
  Looks looks;
  looks.late_s = gap_s;
  // On one thread looks are the same in each try. Of so many some are late by what else the machine
  // does, but not the same ones each time.
  std::vector<std::size_t> always_late;
  for (int i = 0; i < kTries && (i == 0 || (kIsTimed && !always_late.empty())); ++i) {
    looks.begin();
    call({.stop = looks.stop.get_token(), .jobs = 1});
    looks.take(nullptr); // at its end
    std::vector<std::size_t> both;
    std::ranges::set_intersection(always_late, looks.late, std::back_inserter(both));
    always_late = i == 0 ? looks.late : both;
  }
  INFO(name << ": " << looks.count << " looks, at most " << 1e3 * looks.greatest_gap_s
            << " ms apart, from " << place_of(looks.gap_from) << " to " << place_of(looks.gap_to));
  REQUIRE(looks.count > 2);
  if (kIsTimed) CHECK(always_late.empty());
  for (const double share : {0.3, 1.0}) {
    const auto at = 1 + static_cast<std::size_t>(share * static_cast<double>(looks.count - 2));
    double latency = latency_s(call, at);
    for (int i = 1; i < kTries && kIsTimed && latency >= kLatency_s; ++i)
      latency = latency_s(call, at);
    INFO(1e3 * latency << " ms after look " << at);
    if (kIsTimed) CHECK(latency < kLatency_s);
  }
}

using Change = std::function<void(MapSpec&)>;

// Of a new session: the terrain's facts are sought as well.
void check_draw(const std::string& name, const Terrain& terrain, const Change& change) {
  MapSpec spec;
  change(spec);
  check_latency(
      name, [&](const Control& control) { Session(terrain).draw(spec, control); },
      spec.style.asks_for("edges") ? kGapOfEdges_s : kGap_s);
}

const std::vector<LayerSpec> kAllLayers{"profiles", "edges",       "shores",  "border",
                                        "voids",    "silhouettes", "skyline", "solids"};

// Every fifth height is missing in a third of the rows.
OwnedHeights with_holes(const OwnedHeights& heights, int side) {
  const auto out = std::make_shared<std::vector<float>>(*heights);
  for (std::size_t i = 0; i < out->size(); i += 5)
    if (i / static_cast<std::size_t>(side) % 3 == 0) (*out)[i] = std::nanf("");
  return out;
}

void write_geotiff(const OwnedHeights& heights, int side, const std::string& path) {
  GDALAllRegister();
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("BLOCKYSIZE", "4");
  const std::unique_ptr<GDALDataset> dataset(
      GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), side, side, 1,
                                                               GDT_Float32, options.List()));
  REQUIRE(dataset);
  std::array<double, 6> transform{500000, 30, 0, 5000000, 0, -30};
  dataset->SetGeoTransform(transform.data());
  REQUIRE(dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, side, side, heights->data(), side,
                                              side, GDT_Float32, 0, 0) == CE_None);
}

} // namespace

TEST_CASE("stopped at any stage, a call is back at once", "[slow]") {
  const OwnedHeights heights = rough_heights(kSide);
  const Terrain rough = Terrain::of(borrowed(heights, kSide));
  check_draw("the default view", rough, [](MapSpec&) {});
  check_draw("folds of a parallel view", rough, [](MapSpec& spec) {
    spec.view.projection = Projection::orthographic;
    spec.style.silhouette_jump = 0;
    spec.style.plan = ProfileCount{20};
  });
  check_draw("all layers on the ground", rough, [](MapSpec& spec) {
    spec.style.layers = kAllLayers;
    spec.ground_points = true;
  });
  check_draw("profiles that hide", rough, [](MapSpec& spec) {
    spec.style.occluder = Occluder::profiles;
    spec.style.plan = ProfileCount{300};
  });
  check_draw("straight down", rough, [](MapSpec& spec) {
    spec.view.from_elevation = Angle::degrees(90);
    spec.view.field_of_view = Angle::degrees(70);
  });
  check_draw("a check", rough, [](MapSpec& spec) { spec.check = 20000; });
  check_draw("gaps and their outlines", Terrain::of(borrowed(with_holes(heights, kSide), kSide)),
             [](MapSpec& spec) { spec.style.layers = kAllLayers; });
  const auto flooded = std::make_shared<std::vector<float>>(*heights);
  for (float& height : *flooded) height = std::max(height, 2000.0F);
  check_draw("lakes", Terrain::of(borrowed(flooded, kSide)), [](MapSpec&) {});
  check_draw("lines on lakes", Terrain::of(borrowed(flooded, kSide)),
             [](MapSpec& spec) { spec.style.flat = FlatGround::waterlines; });
  GridInput in_degrees = borrowed(heights, kSide);
  in_degrees.geotransform = {10, 1.0 / 3600, 0, 47, 0, -1.0 / 3600};
  in_degrees.crs = "EPSG:4326";
  check_draw("degrees", Terrain::of(in_degrees), [](MapSpec&) {});
  check_draw("triangles", Terrain::of(hill_of_triangles(kSide / 2)),
             [](MapSpec& spec) { spec.style.layers = kAllLayers; });
}

TEST_CASE("stopped while it reads, a call is back at once") {
  const TempFolder folder;
  const OwnedHeights heights = rough_heights(kSide);
  const std::string dem = folder.file("dem.tif"), holes = folder.file("holes.tif");
  write_geotiff(heights, kSide, dem);
  write_geotiff(with_holes(heights, kSide), kSide, holes);
  ReadOptions fill;
  fill.fill_voids = 20;
  const auto read = [](const std::string& path, const ReadOptions& options = {}) {
    return [=](const Control& control) { Terrain::read({path}, options, control); };
  };
  check_latency("a DEM", read(dem));
  check_latency("a DEM whose gaps are filled", read(holes, fill));
  const std::string points = folder.file("points.csv");
  {
    std::ofstream file(points);
    file << "x,y,z\n";
    for (int row = 0; row < kSide / 4; ++row)
      for (int column = 0; column < kSide / 4; ++column)
        file << 10 * column + row % 7 << ',' << 10 * row + column % 5 << ','
             << (*heights)[static_cast<std::size_t>(row * kSide + column)] << '\n';
  }
  check_latency("points", read(points));
}

// As above, by all threads: what all of them work until the call is back.
TEST_CASE("stopped at any stage, all threads are at rest at once") {
  const Session session(Terrain::of(borrowed(rough_heights(kSide), kSide)));
  MapSpec spec;
  spec.style.plan = GroundSpacing{60};
  const auto threads = std::max(1U, std::thread::hardware_concurrency());
  const auto draw_s = [&] {
    const auto begin = std::chrono::steady_clock::now();
    session.draw(spec);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }();
  constexpr int kStops = 5;
  for (int i = 0; i < kStops; ++i) {
    std::stop_source stop;
    double asked_s = 0;
    std::jthread watch([&] {
      std::this_thread::sleep_for(std::chrono::duration<double>((i + 0.5) / kStops * draw_s));
      asked_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
      stop.request_stop();
    });
    bool is_cancelled = false;
    try {
      session.draw(spec, {.stop = stop.get_token()});
    } catch (const Error& error) {
      is_cancelled = error.code() == ErrorCode::cancelled;
    }
    const double back_s = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    watch.join();
    INFO("stop " << i << ": " << 1e3 * (back_s - asked_s) << " ms by " << threads << " threads");
    if (is_cancelled && kIsTimed) CHECK(back_s - asked_s < threads * 2 * kLatency_s);
  }
}

TEST_CASE("wherever a session was stopped, it draws as before", "[unsanitized]") {
  const int kSmall = made_side(100);
  const Terrain terrain = Terrain::of(borrowed(rough_heights(kSmall), kSmall));
  for (const MapSpec& spec : enough_specs(kSmall)) {
    const std::string drawn = drawn_bytes(Session(terrain), spec);
    std::size_t count = 0; // of the looks of a session's first view
    {
      Looks looks;
      Session(terrain).draw(spec, {.stop = looks.stop.get_token(), .jobs = 1});
      count = looks.count;
    }
    // The first ones are in the search for the terrain's facts.
    const std::array<std::size_t, 5> looks{2, 4, count / 4, count - count / 4, count};
    for (const std::size_t at : std::span(looks).first(last_seed(looks.size()))) {
      const Session session(terrain);
      latency_s([&](const Control& control) { session.draw(spec, control); }, at);
      INFO("stopped at look " << at << " of " << count);
      CHECK((drawn_bytes(session, spec) == drawn));
    }
  }
}

// Facts of the terrain are sought once; whoever waits for them seeks them where that one is
// stopped.
TEST_CASE("a view isn't stopped with the one that it waits for") {
  const int kSmall = made_side(100);
  const Terrain terrain = Terrain::of(borrowed(rough_heights(kSmall), kSmall));
  const std::string drawn = drawn_bytes(Session(terrain), {});
  for (const std::size_t at : {2, 3, 4}) {
    const Session session(terrain);
    std::string waited;
    std::jthread other;
    {
      Looks looks;
      looks.stop_at = at;
      looks.before_stop = [&] {
        other = std::jthread([&] { waited = drawn_bytes(session, {}); });
        std::this_thread::sleep_for(std::chrono::milliseconds(30)); // it comes to wait
      };
      CHECK_THROWS_AS(session.draw({}, {.stop = looks.stop.get_token(), .jobs = 1}), Error);
    }
    other.join();
    CHECK((waited == drawn));
  }
}

} // namespace orograph::stop_test
