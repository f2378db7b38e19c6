// SPDX-License-Identifier: GPL-3.0-or-later
// Formats by name, and outputs that can't be written.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/write_drawing.hpp"

#include <unistd.h>

#include <filesystem>

using namespace orograph;

namespace {

std::string message_of(const auto& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

} // namespace

TEST_CASE("formats by name and by path") {
  REQUIRE(format_names().size() == 10);
  for (const std::string& name : format_names()) {
    CHECK(format_names()[static_cast<std::size_t>(format_of_name(name))] == name);
    CHECK(format_of_path("/some.where/map." + name) == format_of_name(name));
  }
  CHECK(format_of_name("GeoJSON") == Format::geojson);
  CHECK(format_of_path("MAP.SVG") == Format::svg);
  CHECK(message_of([] { format_of_name("dwg"); }) ==
        "unknown format 'dwg': one of svg, pdf, ps, eps, png, geojson, gpkg, hpgl, gcode, dxf");
  CHECK_THROWS_AS(format_of_name(""), UsageError);
  CHECK_THROWS_AS(format_of_path("map"), UsageError);
  CHECK_THROWS_AS(format_of_path("map."), UsageError);
  CHECK_THROWS_AS(format_of_path("map.svg/"), UsageError);
  CHECK_THROWS_AS(format_of_path(".svg"), UsageError);
}

TEST_CASE("an existing file stays unless it may be replaced") {
  const TemporaryFolder folder;
  for (const std::string& name : format_names()) {
    const std::string path = folder.file("map." + name);
    WriteOptions options{.format = format_of_name(name), .dpi = 20};
    fill_file(path, "old");
    CHECK(message_of([&] { write_drawing(made_drawing(), path, options); }) ==
          path + " exists already: another name, or `overwrite`");
    CHECK_THROWS_AS(check_writable(path, options), Error);
    CHECK(content_of(path) == "old");
    options.overwrite = true;
    CHECK_NOTHROW(check_writable(path, options));
    CHECK(content_of(path) == "old");
    write_drawing(made_drawing(), path, options);
    CHECK(content_of(path) != "old");
  }
  CHECK(folder.names().size() == format_names().size());
}

TEST_CASE("places that can't be written to are refused before any work") {
  const TemporaryFolder folder;
  fill_file(folder.file("file"), "");
  std::filesystem::create_directory(folder.file("folder.svg"));
  const auto refusal = [](const std::string& path) {
    return message_of([&] { check_writable(path, {.overwrite = true}); });
  };
  CHECK(refusal(folder.file("none/map.svg")) ==
        folder.file("none/map.svg") +
            " can't be written (No such file or directory): a folder that exists");
  CHECK(refusal(folder.file("file/map.svg")) ==
        folder.file("file/map.svg") + " can't be written (Not a directory): a folder that exists");
  CHECK(refusal(folder.file("folder.svg")) ==
        folder.file("folder.svg") + " is not an ordinary file: the name of a file to write");
  CHECK(refusal("/dev/null") == "/dev/null is not an ordinary file: the name of a file to write");
  CHECK(refusal(folder.file("")).find("names no file") != std::string::npos);
  CHECK(refusal("").find("names no file") != std::string::npos);
  CHECK(refusal(folder.file(std::string(300, 'a') + ".svg")).find("a shorter name") !=
        std::string::npos);
  CHECK(folder.names() == std::vector<std::string>{"file", "folder.svg"});
}

TEST_CASE("a folder without permission is refused") {
  if (::geteuid() == 0) return; // root may write everywhere
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("closed"));
  std::filesystem::permissions(folder.file("closed"), std::filesystem::perms::owner_read |
                                                          std::filesystem::perms::owner_exec);
  CHECK(message_of([&] { check_writable(folder.file("closed/map.svg"), {}); }) ==
        folder.file("closed/map.svg") +
            " can't be written (Permission denied): a folder that you may write to");
}

TEST_CASE("binary formats don't go to standard output") {
  for (const std::string& name : format_names()) {
    const WriteOptions options{.format = format_of_name(name)};
    if (is_text(options.format))
      CHECK_NOTHROW(check_writable("-", options));
    else
      CHECK_THROWS_AS(check_writable("-", options), UsageError);
  }
}

TEST_CASE("formats tied to the ground want map points") {
  const TemporaryFolder folder;
  Drawing drawing = made_drawing();
  drawing.layers[1].map.clear();
  for (const Format format : {Format::geojson, Format::gpkg}) {
    REQUIRE(is_tied_to_ground(format));
    CHECK_THROWS_AS(write_drawing(drawing, folder.file("map"), {.format = format}), Error);
  }
  CHECK(folder.names().empty());
}

TEST_CASE("a drawing without strokes is written in every format") {
  const TemporaryFolder folder;
  Drawing empty;
  SECTION("without layers") {}
  SECTION("with a layer") {
    empty.layers.resize(1);
  }
  for (const std::string& name : format_names()) {
    const std::string path = folder.file("map." + name);
    INFO(name);
    CHECK_NOTHROW(write_drawing(empty, path, {.format = format_of_name(name), .dpi = 20}));
    CHECK_FALSE(content_of(path).empty());
  }
}
