// SPDX-License-Identifier: GPL-3.0-or-later
// PDF, PostScript and PNG through Cairo. Coordinates are scaled here and not by Cairo's matrix,
// which would be written out for each stroke.
#include "write/cairo_filters.hpp"
#include "write/format_text.hpp"
#include "write/writers.hpp"

#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "lettering/cairo_function.hpp"
#include "lettering/font_letters.hpp"

namespace orograph {
namespace {

OROGRAPH_CAIRO(cairo_create);
OROGRAPH_CAIRO(cairo_destroy);
OROGRAPH_CAIRO(cairo_image_surface_create);
OROGRAPH_CAIRO(cairo_line_to);
OROGRAPH_CAIRO(cairo_new_sub_path);
OROGRAPH_CAIRO(cairo_paint);
OROGRAPH_CAIRO(cairo_pdf_surface_create_for_stream);
OROGRAPH_CAIRO(cairo_pdf_surface_set_metadata);
OROGRAPH_CAIRO(cairo_ps_surface_create_for_stream);
OROGRAPH_CAIRO(cairo_ps_surface_dsc_comment);
OROGRAPH_CAIRO(cairo_ps_surface_set_eps);
OROGRAPH_CAIRO(cairo_set_line_cap);
OROGRAPH_CAIRO(cairo_set_line_join);
OROGRAPH_CAIRO(cairo_set_line_width);
OROGRAPH_CAIRO(cairo_set_operator);
OROGRAPH_CAIRO(cairo_set_source_rgb);
OROGRAPH_CAIRO(cairo_set_source_rgba);
OROGRAPH_CAIRO(cairo_status);
OROGRAPH_CAIRO(cairo_status_to_string);
OROGRAPH_CAIRO(cairo_stroke);
OROGRAPH_CAIRO(cairo_surface_destroy);
OROGRAPH_CAIRO(cairo_surface_finish);
OROGRAPH_CAIRO(cairo_surface_show_page);
OROGRAPH_CAIRO(cairo_surface_status);
OROGRAPH_CAIRO(cairo_surface_write_to_png_stream);

constexpr double kMmPerInch = 25.4;
constexpr double kPointsPerMm = 72 / kMmPerInch;
// Cairo keeps a page until it is shown, 1 kB for each path and 9 bytes for each point: with a path
// for each stroke, 400 MB for 400,000 strokes of six points; with these paths, 25 MB.
constexpr std::size_t kMostPointsInPath = 500;
constexpr double kLargestPixels = 1e8;      // a byte each, or four with colours
constexpr double kLargestPixelSide = 32767; // Cairo's own limit

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Context = std::unique_ptr<cairo_t, Destroy>;
using Append = std::function<bool(std::string_view)>;

cairo_status_t call_append(void* append, const unsigned char* data, unsigned int size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  return (*static_cast<Append*>(append))(bytes) ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

// A write error is the sink's to tell, with the system's reason.
void check(cairo_status_t status, const ByteSink& out) {
  if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_WRITE_ERROR)
    throw Error(fmt::format("{} can't be written ({})", out.name(), cairo_status_to_string(status)),
                "room in memory and in /tmp, or another format", ErrorCode::output);
}

// Short neighbouring strokes share a path. `ink` sets a layer's colour.
void draw(cairo_surface_t* surface, const Drawing& drawing, double scale,
          void (*ink)(cairo_t*, const Layer& layer), const ByteSink& out) {
  const Context context(cairo_create(surface));
  cairo_t* const pen = context.get();
  cairo_set_line_cap(pen, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
  std::optional<FontLetters> letters;
  for (const Layer& layer : drawing.layers) {
    ink(pen, layer);
    double width_mm = 0;
    std::size_t points_in_path = 0;
    for (const Stroke& stroke : layer.strokes) {
      const double own_mm = stroke.width_mm > 0 ? stroke.width_mm : layer.pen_width_mm;
      if (own_mm != width_mm || points_in_path + stroke.point_count > kMostPointsInPath) {
        cairo_stroke(pen);
        cairo_set_line_width(pen, own_mm * scale);
        width_mm = own_mm;
        points_in_path = 0;
      }
      cairo_new_sub_path(pen);
      for (const Vec2 p : layer.points(stroke)) cairo_line_to(pen, p.x * scale, p.y * scale);
      points_in_path += stroke.point_count;
    }
    cairo_stroke(pen);
    if (!layer.texts.empty() && !letters) letters.emplace(drawing.letters.family);
    for (const PageText& text : layer.texts) letters->draw(pen, text, scale);
  }
  check(cairo_status(pen), out);
}

void finish(cairo_surface_t* surface, const ByteSink& out) {
  cairo_surface_show_page(surface);
  cairo_surface_finish(surface);
  check(cairo_surface_status(surface), out);
}

void set_colour(cairo_t* pen, const Layer& layer) {
  const auto ink = layer.ink();
  if (!ink) return cairo_set_source_rgb(pen, layer.grey, layer.grey, layer.grey);
  const auto [red, green, blue] = *ink;
  cairo_set_source_rgb(pen, red / 255.0, green / 255.0, blue / 255.0);
}

void write_pdf(const Drawing& drawing, ByteSink& out) {
  Append append = [&](std::string_view bytes) { return out.append(bytes); };
  const Surface surface(cairo_pdf_surface_create_for_stream(call_append, &append,
                                                            drawing.page.width_mm * kPointsPerMm,
                                                            drawing.page.height_mm * kPointsPerMm));
  const auto set = [&](cairo_pdf_metadata_t key, const std::string& text) {
    cairo_pdf_surface_set_metadata(surface.get(), key, text.c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, clean_utf8(drawing.title));
  set(CAIRO_PDF_METADATA_SUBJECT, clean_utf8(drawing.description));
  set(CAIRO_PDF_METADATA_CREATOR, "orograph");
  set(CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z"); // the same bytes on any day
  draw(surface.get(), drawing, kPointsPerMm, set_colour, out);
  finish(surface.get(), out);
}

void write_postscript(const Drawing& drawing, bool is_eps, ByteSink& out) {
  PostscriptFilter filter(out);
  Append append = [&](std::string_view bytes) { return filter.append(bytes); };
  const Surface surface(cairo_ps_surface_create_for_stream(call_append, &append,
                                                           drawing.page.width_mm * kPointsPerMm,
                                                           drawing.page.height_mm * kPointsPerMm));
  cairo_ps_surface_set_eps(surface.get(), is_eps);
  cairo_ps_surface_dsc_comment(surface.get(), postscript_title(drawing.title).c_str());
  draw(surface.get(), drawing, kPointsPerMm, set_colour, out);
  finish(surface.get(), out);
  filter.finish();
}

void check_pixels(const Page& page, double dpi, double width, double height) {
  const bool fits =
      width * height <= kLargestPixels && width <= kLargestPixelSide && height <= kLargestPixelSide;
  if (dpi > 0 && width >= 1 && height >= 1 && fits) return;
  const double longer_mm = std::max(page.width_mm, page.height_mm);
  const double most_dpi =
      kMmPerInch * std::min(std::sqrt(kLargestPixels / (page.width_mm * page.height_mm)),
                            (kLargestPixelSide - 1) / longer_mm);
  throw Error(fmt::format("{} dpi on a page of {} x {} mm is no PNG that can be made", dpi,
                          page.width_mm, page.height_mm),
              fmt::format("from 1 to {} dpi for this page, or SVG or PDF", std::floor(most_dpi)),
              ErrorCode::request);
}

// Bytes of an alpha-only image are written to a PNG as they are, as levels of grey, at a quarter of
// the memory of a colour image. SOURCE mixes the old level with the new by how much of a pixel the
// pen covers, which is what painting with an opaque grey does.
void set_level(cairo_t* pen, const Layer& layer) {
  const auto ink = layer.ink();
  cairo_set_operator(pen, CAIRO_OPERATOR_SOURCE);
  cairo_set_source_rgba(pen, 0, 0, 0, ink ? (*ink)[0] / 255.0 : layer.grey);
}

void write_png(const Drawing& drawing, double dpi, ByteSink& out) {
  const double scale = dpi / kMmPerInch;
  const double width = std::round(drawing.page.width_mm * scale);
  const double height = std::round(drawing.page.height_mm * scale);
  check_pixels(drawing.page, dpi, width, height);
  const bool has_levels = is_all_grey(drawing);
  const auto set_ink = has_levels ? set_level : set_colour;
  const Surface surface(
      cairo_image_surface_create(has_levels ? CAIRO_FORMAT_A8 : CAIRO_FORMAT_RGB24,
                                 static_cast<int>(width), static_cast<int>(height)));
  check(cairo_surface_status(surface.get()), out);
  {
    const Context paper(cairo_create(surface.get()));
    Layer white;
    white.grey = 1;
    set_ink(paper.get(), white);
    cairo_paint(paper.get());
  }
  draw(surface.get(), drawing, scale, set_ink, out);
  PngResolution png(out, dpi);
  Append append = [&](std::string_view bytes) { return png.append(bytes); };
  check(cairo_surface_write_to_png_stream(surface.get(), call_append, &append), out);
}

} // namespace

void write_by_cairo(const Drawing& drawing, const WriteOptions& options, ByteSink& out) {
  switch (options.format) {
  case Format::pdf:
    return write_pdf(drawing, out);
  case Format::png:
    return write_png(drawing, options.dpi, out);
  default:
    return write_postscript(drawing, options.format == Format::eps, out);
  }
}

} // namespace orograph
