// SPDX-License-Identifier: GPL-3.0-or-later
// PNG: ink where the strokes are, as wide and as grey as the pen.
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/write_drawing.hpp"

#include <gdal_priv.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>

using namespace orograph;

namespace {

struct GreyImage {
  int width = 0, height = 0, bands = 0;
  std::vector<std::uint8_t> levels;
  int level(int x, int y) const { return levels[static_cast<std::size_t>(y * width + x)]; }
};

GreyImage read_png(const std::string& path) {
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> file(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
  REQUIRE(file);
  GreyImage image{file->GetRasterXSize(), file->GetRasterYSize(), file->GetRasterCount(), {}};
  image.levels.resize(static_cast<std::size_t>(image.width) *
                      static_cast<std::size_t>(image.height));
  const CPLErr read = file->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, image.width, image.height,
                                                       image.levels.data(), image.width,
                                                       image.height, GDT_Byte, 0, 0, nullptr);
  REQUIRE(read == CE_None);
  return image;
}

std::string number_of(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
  return bytes;
}

} // namespace

TEST_CASE("strokes in a PNG have their pens' width and grey, later ones on top") {
  const TemporaryFolder folder;
  Drawing drawing;
  drawing.page = {50.8, 25.4, 1};
  drawing.layers = {empty_layer("black", 2), empty_layer("grey", 1, 0.5)};
  add_stroke(drawing.layers[0], {{5, 10}, {45, 10}});
  add_stroke(drawing.layers[1], {{25.4, 4}, {25.4, 22}});
  write_drawing(drawing, folder.file("map.png"), {.format = Format::png, .dpi = 254});
  const GreyImage image = read_png(folder.file("map.png"));
  REQUIRE(image.width == 508);
  REQUIRE(image.height == 254);
  CHECK(image.bands == 1);
  CHECK(image.level(0, 0) == 255);
  CHECK(image.level(507, 253) == 255);

  double black_pixels = 0; // across the black stroke, 10 pixels a mm
  for (int y = 0; y < image.height; ++y) black_pixels += (255 - image.level(150, y)) / 255.0;
  CHECK(std::abs(black_pixels - 20) <= 0.1); // Cairo's coverage is in 1/256 at best
  double grey_pixels = 0;
  for (int x = 0; x < image.width; ++x) grey_pixels += (255 - image.level(x, 200)) / 127.0;
  CHECK(std::abs(grey_pixels - 10) <= 0.1);
  CHECK(std::abs(image.level(254, 100) - 128) <= 1); // grey over black is grey
}

TEST_CASE("a PNG knows its size on paper") {
  const TemporaryFolder folder;
  write_drawing(made_drawing(), folder.file("map.png"), {.format = Format::png, .dpi = 100});
  const std::string png = content_of(folder.file("map.png"));
  // 3937 pixels a metre; the check sum is zlib's
  CHECK(png.substr(33, 21) ==
        number_of(9) + "pHYs" + number_of(3937) + number_of(3937) + '\1' + number_of(0xa83fa769));
}

TEST_CASE("images of absurd size are refused with what would fit") {
  const TemporaryFolder folder;
  const auto write = [&](double dpi) {
    write_drawing(made_drawing(), folder.file("map.png"), {.format = Format::png, .dpi = dpi});
  };
  for (const double dpi : {0.0, -300.0, 0.01, 1e4, 1e300, double{NAN}, double{INFINITY}})
    CHECK_THROWS_AS(write(dpi), Error);
  try {
    write(5000);
  } catch (const Error& error) {
    const std::string text = error.what();
    const std::string marker = "from 1 to ";
    REQUIRE(text.find(marker) != std::string::npos);
    const double most = std::atof(text.c_str() + text.find(marker) + marker.size());
    CHECK(most == 1017); // 1e8 pixels on A4
  }
  CHECK(folder.names().empty());
}
