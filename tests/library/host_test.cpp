// SPDX-License-Identifier: GPL-3.0-or-later
// What a program has set for itself (in GDAL, for signals, in the language's settings) is as it was
// after all that the library does, well or in vain.
#include "tests/catch.hpp"
#include "tests/dem/temp_folder.hpp"
#include "tests/library/made_ground.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <fcntl.h>
#include <gdal.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cfenv>
#include <clocale>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <locale>
#include <string>
#include <thread>
#include <vector>

namespace orograph::host_test {

namespace {

std::atomic<int> heard = 0;

void CPL_STDCALL hear(CPLErr severity, CPLErrorNum, const char*) {
  if (severity >= CE_Warning) ++heard;
}
void CPL_STDCALL hear_in_thread(CPLErr severity, CPLErrorNum, const char*) {
  if (severity >= CE_Warning) heard += 100;
}
void catch_signal(int) {}

const std::string kData = std::string(OROGRAPH_SOURCE_DIR) + "/data_samples/";

// All that the face has, right and wrong, in every format.
void use_all(const TempFolder& folder) {
  const auto refused = [](const auto& work) {
    try {
      work();
      FAIL("it should have been refused");
    } catch (const Error& error) {
      CHECK(!error.wrong().empty());
    }
  };
  refused([&] { Terrain::read({folder.file("none.tif")}); });
  refused([&] { Terrain::read({folder.file("broken.tif")}); });
  refused([&] { Solids::read(folder.file("none.toml")); });
  ReadOptions filled;
  filled.fill_voids = 3;
  const Session session(Terrain::read({kData + "volcano.tif"}, filled),
                        Solids::read(kData + "scenes/village.toml"));
  MapSpec spec;
  spec.view.eye_lonlat = GivenPlace(0, 0); // on the other side of the earth
  refused([&] { session.draw(spec); });
  std::stop_source stop;
  stop.request_stop();
  refused([&] { session.draw({}, {.stop = stop.get_token()}); });
  spec = {};
  spec.ground_points = true;
  const Drawing drawing = session.draw(spec).drawing;
  for (const std::string& name : format_names()) {
    const WriteOptions options{.format = format_of_name(name), .overwrite = true};
    write_drawing(drawing, folder.file("map." + name), options);
    refused([&] { write_drawing(drawing, folder.file("none/map." + name), options); });
  }
  static_cast<void>(Session(Terrain::read({kData + "archipelago.tif"})).draw({}, {.jobs = 2}));
  GridInput input = borrowed(rough_heights(20), 20);
  input.crs = "no CRS";
  refused([&] { Terrain::of(input); });
}

TempFolder& with_broken_files(TempFolder& folder) {
  std::filesystem::copy_file(kData + "volcano.tif", folder.file("broken.tif"));
  std::filesystem::resize_file(folder.file("broken.tif"), 1000);
  return folder;
}

std::array<struct sigaction, 32> signal_actions() {
  std::array<struct sigaction, 32> actions{};
  for (int number = 1; number < 32; ++number) ::sigaction(number, nullptr, &actions[number]);
  return actions;
}

// Of a stream of the process, what is written to it while this lives.
class Overheard {
public:
  Overheard(int stream, const std::string& path) : stream_(stream), path_(path) {
    std::fflush(nullptr); // what was said before isn't meant
    std::cout.flush();
    before_ = ::dup(stream);
    const int file = ::open(path.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
    ::dup2(file, stream_);
    ::close(file);
  }
  ~Overheard() { end(); }
  Overheard(const Overheard&) = delete;
  Overheard& operator=(const Overheard&) = delete;

  std::uintmax_t end() {
    if (before_ < 0) return 0;
    std::fflush(nullptr);
    ::dup2(before_, stream_);
    ::close(before_);
    before_ = -1;
    return std::filesystem::file_size(path_);
  }

private:
  int stream_;
  std::string path_;
  int before_ = -1;
};

} // namespace

TEST_CASE("a program's settings in GDAL are its own") {
  TempFolder folder;
  with_broken_files(folder);
  GDALAllRegister();
  const GIntBig cache = GDALGetCacheMax64();
  const CPLErrorHandler before = CPLSetErrorHandler(hear);
  GDALSetCacheMax64(77 << 20);
  CPLPushErrorHandler(hear_in_thread);
  const std::vector<const char*> names{"GDAL_PAM_ENABLED", "OGR_CURRENT_DATE", "GDAL_NUM_THREADS",
                                       "OGR_SQLITE_SYNCHRONOUS"};
  for (const char* name : names) {
    CPLSetConfigOption(name, "1999-12-31T00:00:00.000Z");
    CPLSetThreadLocalConfigOption(name, "2001-01-01T00:00:00.000Z");
  }
  char** const options = CPLGetConfigOptions();
  char** const thread_options = CPLGetThreadLocalConfigOptions();
  CPLErrorSetState(CE_Warning, 77, "the program's own");
  heard = 0;

  use_all(folder);

  CHECK(heard == 0);
  CHECK(CPLGetLastErrorType() == CE_Warning);
  CHECK(CPLGetLastErrorNo() == 77);
  CHECK(std::string(CPLGetLastErrorMsg()) == "the program's own");
  CHECK(GDALGetCacheMax64() == 77 << 20);
  const auto are_same = [](char** one, char** other) {
    const int count = CSLCount(one);
    CHECK(count == CSLCount(other));
    for (int i = 0; i < count; ++i) CHECK(CSLFindString(other, one[i]) >= 0);
  };
  char** const found = CPLGetConfigOptions();
  char** const thread_found = CPLGetThreadLocalConfigOptions();
  are_same(options, found);
  are_same(thread_options, thread_found);
  for (char** list : {options, thread_options, found, thread_found}) CSLDestroy(list);
  CPLError(CE_Warning, CPLE_AppDefined, "to the thread's handler");
  CHECK(heard == 100);
  CPLPopErrorHandler();
  CPLError(CE_Warning, CPLE_AppDefined, "to the program's handler");
  CHECK(heard == 101);
  CHECK(CPLSetErrorHandler(before) == hear);
  for (const char* name : names) {
    CPLSetConfigOption(name, nullptr);
    CPLSetThreadLocalConfigOption(name, nullptr);
  }
  GDALSetCacheMax64(cache);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    CHECK(entry.path().extension() != ".xml");
}

TEST_CASE("signals, locale, rounding, folder and file mode stay as they are; nothing is printed") {
  TempFolder folder;
  with_broken_files(folder);
  struct sigaction own {};
  own.sa_handler = catch_signal;
  own.sa_flags = SA_RESTART;
  std::array<struct sigaction, 32> first = signal_actions();
  for (const int number : {SIGINT, SIGTERM, SIGXFSZ, SIGUSR1}) ::sigaction(number, &own, nullptr);
  sigset_t blocked{};
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGUSR2);
  sigset_t unblocked{};
  ::pthread_sigmask(SIG_BLOCK, &blocked, &unblocked);
  const std::array<struct sigaction, 32> actions = signal_actions();
  std::setlocale(LC_ALL,
                 "C.UTF-8"); // no other name for C, so that a part that is set to that shows
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  const std::locale cpp_locale;
  const std::string place = std::filesystem::current_path().string();
  const mode_t mode = ::umask(0027);
  const int rounding = std::fegetround();

  Overheard out(STDOUT_FILENO, folder.file("out")), err(STDERR_FILENO, folder.file("err"));
  use_all(folder);
  CHECK(out.end() == 0);
  CHECK(err.end() == 0);

  const std::array<struct sigaction, 32> found = signal_actions();
  for (std::size_t number = 1; number < found.size(); ++number) {
    INFO("signal " << number);
    CHECK(found[number].sa_handler == actions[number].sa_handler);
    CHECK(found[number].sa_flags == actions[number].sa_flags);
  }
  sigset_t mask{};
  ::pthread_sigmask(SIG_SETMASK, &unblocked, &mask);
  CHECK(::sigismember(&mask, SIGUSR2) == 1);
  for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGUSR1})
    CHECK(::sigismember(&mask, number) == 0);
  CHECK(std::setlocale(LC_ALL, nullptr) == locale);
  std::setlocale(LC_ALL, "C");
  CHECK(std::locale() == cpp_locale);
  CHECK(std::filesystem::current_path().string() == place);
  CHECK(::umask(mode) == 0027);
  CHECK(std::fegetround() == rounding);
  for (const int number : {SIGINT, SIGTERM, SIGXFSZ, SIGUSR1})
    ::sigaction(number, &first[static_cast<std::size_t>(number)], nullptr);
}

TEST_CASE("GDAL's errors of one thread don't come from another's use of the library") {
  TempFolder folder;
  with_broken_files(folder);
  const CPLErrorHandler before = CPLSetErrorHandler(hear);
  heard = 0;
  std::jthread library([&] { use_all(folder); });
  for (int i = 0; i < 200; ++i) {
    CPLError(CE_Warning, 5, "mine, %d", i);
    CHECK(CPLGetLastErrorNo() == 5);
    CHECK(CPLGetLastErrorMsg() == "mine, " + std::to_string(i));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  library.join();
  CHECK(heard == 200);
  CPLSetErrorHandler(before);
}

} // namespace orograph::host_test
