// SPDX-License-Identifier: GPL-3.0-or-later
// many_views DEM FOLDER [SECONDS]: the terrain from all around, 36 views, with progress; after so
// many seconds it stops in the midst of whatever it does, and what was written stays.
#include <orograph.hpp>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>

namespace {

// Asks for a stop after a time, unless it is destroyed before.
class Alarm {
public:
  Alarm(double seconds, std::stop_source stop)
      : thread_([this, seconds, stop](const std::stop_token& done) mutable {
          std::unique_lock lock(mutex_);
          if (!wake_.wait_for(lock, done, std::chrono::duration<double>(seconds),
                              [] { return false; }) &&
              !done.stop_requested())
            stop.request_stop();
        }) {}

private:
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;
};

} // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4)
    return std::fprintf(stderr, "usage: many_views DEM FOLDER [SECONDS]\n"), 2;
  constexpr int kViews = 36;
  std::stop_source stop;
  const Alarm alarm(argc == 4 ? std::atof(argv[3]) : 3600, stop);
  int view = 0;
  try {
    // What placing and facing need of the terrain is found by the first view, for all of them.
    const orograph::Session session(orograph::Terrain::read({argv[1]}));
    orograph::Control control;
    control.stop = stop.get_token();
    control.progress = [&](double share) {
      std::fprintf(stderr, "\r%3.0f %%", 100 * (view + share) / kViews);
    };
    orograph::MapSpec spec;
    for (; view < kViews; ++view) {
      spec.view.from_azimuth = orograph::Angle::degrees(10 * view);
      const orograph::Map map = session.draw(spec, control);
      const std::string path =
          std::string(argv[2]) + "/view-" + std::to_string(100 + view).substr(1) + ".svg";
      orograph::write_drawing(map.drawing, path, {.overwrite = true});
    }
  } catch (const orograph::Error& error) {
    std::fprintf(stderr, "\n%d views are written; %s\n", view, error.what());
    return error.code() == orograph::ErrorCode::cancelled ? 0 : 1;
  }
  std::fprintf(stderr, "\n%d views are written\n", view);
}
