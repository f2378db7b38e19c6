// SPDX-License-Identifier: GPL-3.0-or-later
// Several sessions, and several draws of each, at once in one process: each gives the bytes that it
// would have given alone. Cases have the tag [threads] for scripts/test-threads.
#include "tests/catch.hpp"
#include "tests/library/made_ground.hpp"

#include <atomic>
#include <latch>
#include <string>
#include <thread>
#include <vector>

namespace orograph::threads_test {

namespace {

const int kSide = made_side(160);

// Threads that begin together, each with its number; what one throws is told, and fails.
template <class Work>
void on_threads(int count, const Work& work) {
  std::latch begin(count);
  std::atomic<int> failed = 0;
  std::vector<std::jthread> threads;
  for (int i = 0; i < count; ++i)
    threads.emplace_back([&, i] {
      begin.arrive_and_wait();
      try {
        work(i);
      } catch (const std::exception&) {
        ++failed;
      }
    });
  threads.clear(); // which waits
  CHECK(failed == 0);
}

std::vector<std::string> drawn_alone(const Terrain& terrain, const std::vector<MapSpec>& specs) {
  std::vector<std::string> drawn;
  for (const MapSpec& spec : specs) drawn.push_back(drawn_bytes(Session(terrain), spec));
  return drawn;
}

} // namespace

TEST_CASE("views of one session drawn at once have the bytes that each has alone",
          "[threads][unsanitized]") {
  const Terrain terrain = Terrain::of(borrowed(rough_heights(kSide), kSide));
  const std::vector<MapSpec> specs = many_specs(kSide);
  const std::vector<std::string> alone = drawn_alone(terrain, specs);
  for (std::size_t i = 0; i < alone.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) CHECK((alone[i] != alone[k])); // what is compared differs
  // Of a new session all look for the facts of the terrain at once.
  for (int round = 0; round < 3; ++round) {
    const Session session(terrain);
    std::atomic<int> same = 0;
    on_threads(8, [&](int i) {
      const auto of_spec = static_cast<std::size_t>((i + round) % 8);
      Control control;
      control.jobs = i % 4; // 0 is all cores
      same += drawn_bytes(session, specs[of_spec], control) == alone[of_spec];
    });
    CHECK(same == 8);
  }
}

TEST_CASE("so have those of several sessions, with terrains of their own and shared ones",
          "[threads]") {
  const Terrain rough = Terrain::of(borrowed(rough_heights(kSide), kSide));
  const Terrain hill = Terrain::of(hill_of_triangles(30));
  GridInput in_degrees = borrowed(rough_heights(80), 80);
  in_degrees.geotransform = {10, 1.0 / 3600, 0, 47, 0, -1.0 / 3600};
  in_degrees.crs = "EPSG:4326";
  const std::vector<Terrain> terrains{rough, hill, Terrain::of(in_degrees), rough};
  MapSpec tied;
  tied.ground_points = true;
  tied.style.flat = FlatGround::draw;
  const std::vector<MapSpec> specs{{}, tied};
  std::vector<std::vector<std::string>> alone;
  std::vector<Session> sessions;
  for (const Terrain& terrain : terrains) {
    alone.push_back(drawn_alone(terrain, specs));
    sessions.emplace_back(terrain);
  }
  std::atomic<int> same = 0;
  on_threads(8, [&](int i) {
    const auto of_session = static_cast<std::size_t>(i) % sessions.size();
    const auto of_spec = static_cast<std::size_t>(i) / sessions.size();
    same += drawn_bytes(sessions[of_session], specs[of_spec], {.jobs = 1 + i % 3}) ==
            alone[of_session][of_spec];
  });
  CHECK(same == 8);
}

TEST_CASE("views on the earth, of one frame and of others, have the bytes that each has alone",
          "[threads]") {
  const int side = made_side(90);
  GridInput in_degrees = borrowed(rough_heights(side), side);
  in_degrees.geotransform = {10, 1.0 / 3600, 0, 47, 0, -1.0 / 3600};
  in_degrees.crs = "EPSG:4326";
  const Terrain terrain = Terrain::of(in_degrees);
  std::vector<MapSpec> specs(8);
  specs[1].view.from_azimuth = Angle::degrees(217);
  specs[2].view.from_azimuth = Angle::degrees(30);
  specs[3].view.exaggeration = 3;
  for (const std::size_t larger : {1U, 2U, 3U}) specs[larger].style.detail.cell_mm = 5;
  for (const std::size_t from_eye : {4U, 5U, 6U}) {
    specs[from_eye].view.eye_map = GivenPlace(10 + 0.5 * side / 3600, 47 - 0.5 * side / 3600);
    specs[from_eye].view.eye_height_m = 150;
    specs[from_eye].view.look_azimuth = Angle::degrees(30.0 * static_cast<double>(from_eye));
  }
  specs[6].view.eye_map = GivenPlace(10 + 0.3 * side / 3600, 47 - 0.5 * side / 3600);
  specs[7].view.exaggeration = 0.7;
  const std::vector<std::string> alone = drawn_alone(terrain, specs);
  for (std::size_t i = 0; i < alone.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) CHECK((alone[i] != alone[k]));
  const Session session(terrain);
  for (const std::size_t i : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 0U}) // some frames several times
    CHECK((drawn_bytes(session, specs[i]) == alone[i]));
  std::atomic<int> same = 0;
  on_threads(8, [&](int i) {
    const auto of_spec = static_cast<std::size_t>(i);
    same += drawn_bytes(session, specs[of_spec], {.jobs = i % 4}) == alone[of_spec];
  });
  CHECK(same == 8);
}

TEST_CASE("terrains are read at once, with views drawn meanwhile", "[threads]") {
  const std::string folder = std::string(OROGRAPH_SOURCE_DIR) + "/data_samples/";
  const std::vector<std::string> names{"volcano.tif", "archipelago.tif"};
  std::vector<std::string> alone;
  for (const std::string& name : names)
    alone.push_back(drawn_bytes(Session(Terrain::read({folder + name})), {}));
  std::atomic<int> same = 0;
  on_threads(6, [&](int i) {
    const auto of_name = static_cast<std::size_t>(i) % names.size();
    const Control control{.jobs = i % 3};
    const Session session(Terrain::read({folder + names[of_name]}, {}, control));
    same += drawn_bytes(session, {}, control) == alone[of_name];
  });
  CHECK(same == 6);
}

TEST_CASE("a draw that is stopped leaves those beside it alone", "[threads]") {
  const Terrain terrain = Terrain::of(borrowed(rough_heights(kSide), kSide));
  const std::vector<MapSpec> specs = many_specs(kSide);
  const std::vector<std::string> alone = drawn_alone(terrain, {specs[0], specs[4]});
  const Session session(terrain);
  std::atomic<int> same = 0, stopped = 0;
  // Even ones are stopped: the first before it begins, the others while profiles are drawn.
  on_threads(8, [&](int i) {
    if (i % 2 == 1) {
      same += drawn_bytes(session, specs[i % 4 == 1 ? 0 : 4]) == alone[i % 4 == 1 ? 0 : 1];
      return;
    }
    std::stop_source stop;
    Control control;
    control.stop = stop.get_token();
    if (i == 0) stop.request_stop();
    control.progress = [&](double share) {
      if (share > 0.1 * i) stop.request_stop();
    };
    try {
      session.draw(specs[0], control);
    } catch (const Error& error) {
      stopped += error.code() == ErrorCode::cancelled;
    }
  });
  CHECK(same == 4);
  CHECK(stopped == 4);
}

} // namespace orograph::threads_test
