// SPDX-License-Identifier: GPL-3.0-or-later
// The same drawing gives the same bytes, also a second later and under another name.
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/write_drawing.hpp"

#include <chrono>
#include <thread>

using namespace orograph;

TEST_CASE("the same drawing gives the same bytes in every format") {
  const TemporaryFolder folder;
  const Drawing drawing = made_drawing(100, 50);
  const auto write_all = [&](const std::string& name) {
    for (const std::string& format : format_names())
      write_drawing(drawing, folder.file(name + "." + format),
                    {.format = format_of_name(format), .dpi = 50});
  };
  write_all("first");
  // Dates in files count seconds.
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  write_all("the second one");
  for (const std::string& format : format_names()) {
    const std::string first = content_of(folder.file("first." + format));
    const bool same = first == content_of(folder.file("the second one." + format));
    INFO(format);
    CHECK(first.size() > 1000);
    CHECK(same);
  }
  CHECK(folder.names().size() == 2 * format_names().size()); // nothing beside them
}
