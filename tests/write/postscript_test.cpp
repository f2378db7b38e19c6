// SPDX-License-Identifier: GPL-3.0-or-later
// What is taken out of Cairo's PostScript, and what is asked of it.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/cairo_filters.hpp"
#include "write/write_drawing.hpp"

using namespace orograph;

namespace {

std::string filtered(const std::vector<std::string>& parts) {
  const TemporaryFolder folder;
  fill_file(folder.file("out"), "");
  ByteSink out(folder.file("out"), "out");
  PostscriptFilter filter(out);
  for (const std::string& part : parts) filter.append(part);
  filter.finish();
  out.finish();
  return content_of(folder.file("out"));
}

} // namespace

TEST_CASE("the creation date goes, however the lines arrive") {
  CHECK(filtered({"%!PS\n%%Crea", "tionDate: today", "\n%%Pages: 1\nshow", "page\n%%EOF"}) ==
        "%!PS\n%%Pages: 1\nshowpage\n%%EOF");
}

TEST_CASE("a page cut off is an error") {
  CHECK_THROWS_AS(filtered({"%!PS\n1 2 m 3 4", "\n%%Trailer\n%%EOF\n"}), Error);
}

TEST_CASE("titles become one line of ASCII") {
  CHECK(postscript_title("Höhe\n%%EOF") == "%%Title: H?he?%%EOF");
  CHECK(postscript_title(std::string(1000, 'x')).size() < 255);
}

TEST_CASE("EPS has a bounding box and the strokes' round pen, and no date") {
  const TemporaryFolder folder;
  Drawing drawing;
  drawing.layers = {empty_layer("profiles", 0.5)};
  add_stroke(drawing.layers[0], {{25.4, 25.4}, {50.8, 25.4}, {50.8, 76.2}});
  write_drawing(drawing, folder.file("map.eps"), {.format = Format::eps});
  const std::string eps = content_of(folder.file("map.eps"));
  CHECK(eps.find("%!PS-Adobe-3.0 EPSF-3.0\n") == 0);
  CHECK(eps.find("CreationDate") == std::string::npos);
  // 1 to 2 inches from the left, 841.89 - 72 to 841.89 - 216 points up, and half a pen around it
  CHECK(eps.find("\n%%BoundingBox: 71 625 145 771\n") != std::string::npos);
  CHECK(eps.find("1 J\n1 j\n") != std::string::npos);
}
