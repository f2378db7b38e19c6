// SPDX-License-Identifier: GPL-3.0-or-later
// Formats by name, and the way from a drawing to its place.
#include "write/write_drawing.hpp"

#include "geometry/error.hpp"
#include "text/words.hpp"
#include "write/output_file.hpp"
#include "write/writers.hpp"

#include <cairo.h>
#include <fmt/format.h>
#include <gdal.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>

#include "lettering/cairo_function.hpp"
#include "lettering/lettering.hpp"

namespace orograph {
namespace {

OROGRAPH_CAIRO(cairo_version_string);

constexpr std::string_view kStandardOutput = "-";

std::optional<Format> format_called(std::string_view name) {
  const std::string lower = in_lower_case(name);
  const auto found = std::ranges::find(format_names(), lower);
  if (found == format_names().end()) return {};
  return static_cast<Format>(found - format_names().begin());
}

void check_map_points(const Drawing& drawing, Format format) {
  if (!is_tied_to_ground(format)) return;
  for (const Layer& layer : drawing.layers)
    if (layer.map.size() != layer.page_mm.size())
      throw Error(fmt::format("layer {} has no map points", layer.name),
                  "a drawing tied to the ground, or a format such as SVG", ErrorCode::request);
}

bool has_texts(const Drawing& drawing) {
  return std::ranges::any_of(drawing.layers,
                             [](const Layer& layer) { return !layer.texts.empty(); });
}

void write_to_sink(const Drawing& drawing, const WriteOptions& options, ByteSink& out) {
  if (has_one_width(options.format) && has_texts(drawing)) { // what a pen or a CAD draws
    Drawing lettered = drawing;
    lettered.letters.kind = LetterKind::stroke;
    Lettering lettering(lettered.letters);
    texts_to_strokes(lettered, lettering);
    return write_to_sink(lettered, options, out);
  }
  if (language_of(options.format)) {
    const Device device = device_of(options);
    const OnDevice on_device(drawing, device);
    const bool is_hpgl = device.language == Device::Language::hpgl;
    (is_hpgl ? write_hpgl : write_gcode)(drawing, device, on_device, out);
  } else if (options.format == Format::svg) {
    write_svg(drawing, out);
  } else if (options.format == Format::geojson) {
    write_geojson(drawing, out);
  } else if (options.format == Format::dxf) {
    write_dxf(drawing, out);
  } else {
    write_by_cairo(drawing, options, out);
  }
  out.finish();
}

// Beside the path.
void write_to_file(const Drawing& drawing, const std::string& path, const WriteOptions& options,
                   const OutputFile& file) {
  if (options.format == Format::gpkg) {
    write_geopackage(drawing, file.temporary_path(), path);
    prove_geopackage(drawing, file.temporary_path(), path);
  } else {
    ByteSink out(file.temporary_path(), path);
    write_to_sink(drawing, options, out);
  }
}

} // namespace

bool is_tied_to_ground(Format format) {
  return format == Format::geojson || format == Format::gpkg;
}

std::optional<Device::Language> language_of(Format format) {
  if (format == Format::hpgl) return Device::Language::hpgl;
  if (format == Format::gcode) return Device::Language::gcode;
  return std::nullopt;
}

bool has_one_width(Format format) {
  return format == Format::hpgl || format == Format::gcode || format == Format::dxf;
}

Device device_of(const WriteOptions& options) {
  const auto language = language_of(options.format);
  if (!options.device)
    return read_device(language == Device::Language::gcode ? "grbl-servo" : "generic");
  if (options.device->language != language)
    throw UsageError(fmt::format("the {} speaks another language than {}", options.device->name,
                                 format_names()[static_cast<std::size_t>(options.format)]),
                     "another `device`, or another `format`");
  return *options.device;
}

PenOrder pen_order_for(Format format) {
  const bool is_for_pen = format == Format::svg || format == Format::ps || format == Format::eps ||
                          has_one_width(format);
  return is_for_pen ? PenOrder::sorted : PenOrder::drawing;
}

bool is_text(Format format) {
  return format == Format::svg || format == Format::ps || format == Format::eps ||
         format == Format::geojson || has_one_width(format);
}

const std::vector<std::string>& format_names() {
  static const std::vector<std::string> names{"svg",     "pdf",  "ps",   "eps",   "png",
                                              "geojson", "gpkg", "hpgl", "gcode", "dxf"};
  return names;
}

Format format_of_name(std::string_view name) {
  if (const auto format = format_called(name)) return *format;
  throw UsageError(fmt::format("unknown format '{}'", name),
                   fmt::format("one of {}", joined(format_names(), ", ")));
}

Format format_of_path(std::string_view path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (const auto format = format_called(extension.empty() ? extension : extension.substr(1)))
    return *format;
  throw UsageError(
      fmt::format("'{}' doesn't tell its format", path),
      fmt::format("a name that ends with .{}, or `format`", joined(format_names(), ", .")));
}

double rounding_mm(const WriteOptions& options) {
  const double half_diagonal = 0.5 * std::numbers::sqrt2;
  constexpr double kCairoStep_mm = 25.4 / 72 / 256; // fixed point with 8 bits after the point
  switch (options.format) {
  case Format::svg:
  case Format::dxf:
    return page_rounding_mm();
  case Format::hpgl:
  case Format::gcode:
    return page_rounding_mm() + half_diagonal * device_of(options).step_mm();
  case Format::pdf:
  case Format::ps:
  case Format::eps:
    return page_rounding_mm() + half_diagonal * kCairoStep_mm;
  case Format::png:
    return page_rounding_mm() + half_diagonal * 25.4 / options.dpi;
  case Format::geojson:
  case Format::gpkg:
    return 0; // on the ground in full precision
  }
  return page_rounding_mm();
}

void check_writable(const std::string& path, const WriteOptions& options) {
  if (path != kStandardOutput)
    const OutputFile tried(path, options.overwrite); // and removed again
  else if (!is_text(options.format))
    throw UsageError(fmt::format("{} can't go to standard output",
                                 format_names()[static_cast<std::size_t>(options.format)]),
                     "the name of a file, or one of svg, ps, eps, geojson, hpgl, gcode, dxf");
}

void write_drawing(const Drawing& drawing, const std::string& path, const WriteOptions& options) {
  check_map_points(drawing, options.format);
  if (path == kStandardOutput) {
    check_writable(path, options);
    ByteSink out = ByteSink::standard_output();
    return write_to_sink(drawing, options, out);
  }
  OutputFile file(path, options.overwrite);
  write_to_file(drawing, path, options, file);
  file.commit();
}

std::string text_of_drawing(const Drawing& drawing, const WriteOptions& options) {
  check_map_points(drawing, options.format);
  check_writable(std::string(kStandardOutput), options);
  std::string text;
  ByteSink out = ByteSink::into(text);
  write_to_sink(drawing, options, out);
  return text;
}

void write_drawings(const std::vector<Drawing>& drawings, const std::vector<std::string>& paths,
                    const WriteOptions& options) {
  std::vector<std::unique_ptr<OutputFile>> files;
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    check_map_points(drawings[i], options.format);
    files.push_back(std::make_unique<OutputFile>(paths[i], options.overwrite));
    write_to_file(drawings[i], paths[i], options, *files.back());
  }
  commit_together(files);
}

std::map<std::string, std::string> library_versions() {
  return {{"gdal", GDALVersionInfo("RELEASE_NAME")}, {"cairo", cairo_version_string()}};
}

} // namespace orograph
