// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/stages/allocations.hpp"
#include "bench/stages/meter.hpp"
#include "tests/catch.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <latch>
#include <memory>
#include <new>
#include <thread>
#include <vector>

using namespace orograph;

namespace {

struct alignas(256) Aligned {
  std::array<char, 300> bytes; // 512 with the padding
};

// By threads that begin together, 24 bytes at a time.
void allocate(int threads, int times) {
  std::vector<std::thread> all;
  std::latch begin(threads);
  for (int i = 0; i < threads; ++i)
    all.emplace_back([times, &begin] {
      begin.arrive_and_wait();
      for (int k = 0; k < times; ++k) ::operator delete(::operator new(24));
    });
  for (std::thread& thread : all) thread.join();
}

} // namespace

TEST_CASE("allocations are counted, each with its bytes", "[bench]") {
  Meter meter;
  std::vector<double> values;
  meter.measure([&] { values.reserve(1000); });
  CHECK(meter.allocations.count == 1);
  CHECK(meter.allocations.bytes == 8000);

  std::unique_ptr<Aligned> aligned;
  meter.measure([&] { aligned = std::make_unique<Aligned>(); });
  CHECK(meter.allocations.count == 2);
  CHECK(meter.allocations.bytes == 8000 + sizeof(Aligned));
  CHECK(reinterpret_cast<std::uintptr_t>(aligned.get()) % 256 == 0);

  values.resize(500);
  meter.measure([&] { values.resize(1000); }); // within what is there
  CHECK(meter.allocations.count == 2);
  aligned.reset(); // not measured
  std::make_unique<Aligned>();
  CHECK(meter.allocations.count == 2);
}

TEST_CASE("allocations of several threads are all counted", "[bench]") {
  const auto counted = [](int times) {
    const Allocations before = allocations_so_far();
    allocate(4, times);
    return allocations_so_far() - before;
  };
  const Allocations none = counted(0), all = counted(1000000); // threads themselves need some
  CHECK(all.count - none.count == 4000000);
  CHECK(all.bytes - none.bytes == 96000000);
}

#ifndef __SANITIZE_ADDRESS__ // which ends the program then
TEST_CASE("too much memory is refused as it was", "[bench]") {
  volatile std::size_t bytes = SIZE_MAX / 4;
  CHECK_THROWS_AS(::operator new(bytes), std::bad_alloc);
}
#endif
