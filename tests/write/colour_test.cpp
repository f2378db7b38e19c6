// SPDX-License-Identifier: GPL-3.0-or-later
// A layer's colour in every format that has colours, as other programs read it.
#include "draw/colour.hpp"
#include "tests/catch.hpp"
#include "tests/draw/made_drawing.hpp"
#include "write/write_drawing.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

using namespace orograph;

namespace {

using Dataset = std::unique_ptr<GDALDataset>;

constexpr Colour kBlue{0x2a, 0x6f, 0xa8}, kBrown{0x9c, 0x62, 0x33};
constexpr int kDpi = 254; // ten dots a millimetre

// A stroke of 2 mm in each layer: grey, blue and brown, one below the other.
Drawing three_strokes() {
  Drawing drawing;
  drawing.page = {40, 40, 1};
  drawing.layers = {empty_layer("border", 2, 0.5), empty_layer("shores", 2),
                    empty_layer("contours", 2)};
  drawing.layers[1].colour = kBlue;
  drawing.layers[2].colour = kBrown;
  add_stroke(drawing.layers[0], {{5, 10}, {35, 10}});
  add_stroke(drawing.layers[1], {{5, 20}, {35, 20}});
  add_stroke(drawing.layers[2], {{5, 30}, {35, 30}});
  return drawing;
}

Dataset open(const std::string& path, unsigned int kind) {
  GDALAllRegister();
  Dataset dataset(GDALDataset::Open(path.c_str(), kind));
  REQUIRE(dataset);
  return dataset;
}

struct Image {
  int bands = 0;
  std::vector<Colour> pixels;
  int width = 0;

  Colour at_mm(int x, int y) const {
    return pixels[static_cast<std::size_t>(10 * y * width + 10 * x)];
  }
};

Image read_image(const std::string& path) {
  const Dataset dataset = open(path, GDAL_OF_RASTER);
  Image image{dataset->GetRasterCount(), {}, dataset->GetRasterXSize()};
  const int height = dataset->GetRasterYSize();
  image.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(height));
  for (int band = 0; band < 3; ++band) {
    const CPLErr read = dataset->GetRasterBand(std::min(band, image.bands - 1) + 1)
                            ->RasterIO(GF_Read, 0, 0, image.width, height,
                                       reinterpret_cast<std::uint8_t*>(image.pixels.data()) + band,
                                       image.width, height, GDT_Byte, 3, 3 * image.width, nullptr);
    REQUIRE(read == CE_None);
  }
  return image;
}

int farthest(const Colour& a, const Colour& b) {
  int most = 0;
  for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

void check_strokes(const Image& image) {
  CHECK(image.bands == 3);
  CHECK(image.at_mm(2, 2) == Colour{255, 255, 255});
  CHECK(farthest(image.at_mm(20, 10), {128, 128, 128}) <= 1); // 0.5 is between two levels
  CHECK(farthest(image.at_mm(20, 20), kBlue) == 0);
  CHECK(farthest(image.at_mm(20, 30), kBrown) == 0);
}

} // namespace

TEST_CASE("a PNG has a layer's colour, and levels of grey alone where no layer has one") {
  const TemporaryFolder folder;
  const WriteOptions options{.format = Format::png, .dpi = kDpi, .overwrite = true};
  Drawing drawing = three_strokes();
  write_drawing(drawing, folder.file("map.png"), options);
  check_strokes(read_image(folder.file("map.png")));

  for (Layer& layer : drawing.layers) layer.colour = std::nullopt;
  write_drawing(drawing, folder.file("grey.png"), options);
  CHECK(read_image(folder.file("grey.png")).bands == 1);
  drawing.layers[1].colour = Colour{0, 0, 0}; // a grey is no colour, whoever asks for it
  write_drawing(drawing, folder.file("black.png"), options);
  CHECK(content_of(folder.file("black.png")) == content_of(folder.file("grey.png")));
  drawing.layers[1].pen = Pen{.colour = kBlue};
  write_drawing(drawing, folder.file("pen.png"), options);
  CHECK(read_image(folder.file("pen.png")).at_mm(20, 20) == kBlue);
}

TEST_CASE("a PDF has a layer's colour") {
  const TemporaryFolder folder;
  write_drawing(three_strokes(), folder.file("map.pdf"), {.format = Format::pdf});
  const std::string command = "pdftoppm -singlefile -r " + std::to_string(kDpi) + " " +
                              folder.file("map.pdf") + " " + folder.file("seen");
  REQUIRE(std::system(command.c_str()) == 0);
  check_strokes(read_image(folder.file("seen.ppm")));
}

TEST_CASE("SVG and PostScript have a layer's colour") {
  const TemporaryFolder folder;
  write_drawing(three_strokes(), folder.file("map.svg"), {});
  const std::string svg = content_of(folder.file("map.svg"));
  const std::size_t shores = svg.find("2 shores"), contours = svg.find("3 contours");
  CHECK(svg.find("stroke=\"#2a6fa8\"", shores) < contours);
  CHECK(svg.find("stroke:#2a6fa8", shores) < contours);
  CHECK(svg.find("stroke=\"#9c6233\"", contours) != std::string::npos);
  CHECK(svg.find("stroke=\"#808080\"") < shores);
  write_drawing(three_strokes(), folder.file("map.ps"), {.format = Format::ps});
  // 0x2a / 255 and so on.
  CHECK(content_of(folder.file("map.ps")).find("0.164706 0.435294 0.658824 rg") !=
        std::string::npos);
}

TEST_CASE("DXF has a layer's colour itself behind the nearest of AutoCAD's") {
  const TemporaryFolder folder;
  Drawing drawing = three_strokes();
  // What a name can't be taken for.
  drawing.layers[0].name = "LWPOLYLINE";
  drawing.layers[1].name = "AcDbPolyline";
  drawing.layers[2].name = " 62";
  write_drawing(drawing, folder.file("map.dxf"), {.format = Format::dxf});
  const std::string dxf = content_of(folder.file("map.dxf"));
  CHECK(dxf.find("420\n" + std::string("  2781096") + "\n") != std::string::npos); // 0x2a6fa8
  const Dataset dataset = open(folder.file("map.dxf"), GDAL_OF_VECTOR);
  OGRLayer& lines = *dataset->GetLayer(0);
  for (const Colour& colour : {Colour{128, 128, 128}, kBlue, kBrown}) {
    const OGRFeatureUniquePtr feature(lines.GetNextFeature());
    REQUIRE(feature);
    INFO(feature->GetStyleString());
    // The nearest grey of the table is 0x7f.
    const std::string expected = is_grey(colour) ? "#7f7f7f" : hex_of(colour);
    CHECK(std::string(feature->GetStyleString()).find(expected) != std::string::npos);
  }
  for (Layer& layer : drawing.layers) layer.colour = std::nullopt;
  write_drawing(drawing, folder.file("grey.dxf"), {.format = Format::dxf});
  CHECK(content_of(folder.file("grey.dxf")).find("\n420\n") == std::string::npos);
}

TEST_CASE("GeoJSON and GeoPackage tell the colours of lines where a layer has one") {
  Drawing drawing = made_drawing(3, 5); // border and profiles
  drawing.layers[1].features = {{{"Stroke", std::int64_t{7}}}};
  drawing.layers[1].strokes[0].feature = 0;
  for (const char* name : {"map.geojson", "map.gpkg"}) {
    INFO(name);
    const TemporaryFolder folder;
    const WriteOptions options{.format = format_of_path(name), .overwrite = true};
    drawing.layers[1].colour = std::nullopt;
    write_drawing(drawing, folder.file(name), options);
    {
      const Dataset dataset = open(folder.file(name), GDAL_OF_VECTOR);
      CHECK(dataset->GetLayer(0)->FindFieldIndex("Stroke_", TRUE) == -1);
    }
    drawing.layers[1].colour = kBrown;
    write_drawing(drawing, folder.file(name), options);
    const Dataset dataset = open(folder.file(name), GDAL_OF_VECTOR);
    OGRLayer& read = *dataset->GetLayer(0);
    for (const char* colour : {"#999999", "#999999", "#999999", "#9c6233", "#9c6233", "#9c6233"}) {
      const OGRFeatureUniquePtr feature(read.GetNextFeature());
      REQUIRE(feature);
      CHECK(feature->GetFieldAsString("stroke") == std::string(colour));
      if (feature->GetFieldAsInteger("profile") == 0) // its own field goes beside it
        CHECK(feature->GetFieldAsInteger("Stroke_") == 7);
    }
  }
}
