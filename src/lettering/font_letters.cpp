// SPDX-License-Identifier: GPL-3.0-or-later
// Every text is laid out at one size, without hints, and scaled: so what is measured is what is
// drawn, on any surface.
#include "lettering/font_letters.hpp"

#include "text/words.hpp"

#include <cairo.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <utility>

#include "lettering/cairo_function.hpp"

namespace orograph {
namespace {

OROGRAPH_CAIRO(cairo_copy_path_flat);
OROGRAPH_CAIRO(cairo_create);
OROGRAPH_CAIRO(cairo_destroy);
OROGRAPH_CAIRO(cairo_font_options_create);
OROGRAPH_CAIRO(cairo_font_options_destroy);
OROGRAPH_CAIRO(cairo_font_options_set_antialias);
OROGRAPH_CAIRO(cairo_font_options_set_hint_metrics);
OROGRAPH_CAIRO(cairo_font_options_set_hint_style);
OROGRAPH_CAIRO(cairo_image_surface_create);
OROGRAPH_CAIRO(cairo_move_to);
OROGRAPH_CAIRO(cairo_new_path);
OROGRAPH_CAIRO(cairo_path_destroy);
OROGRAPH_CAIRO(cairo_restore);
OROGRAPH_CAIRO(cairo_rotate);
OROGRAPH_CAIRO(cairo_save);
OROGRAPH_CAIRO(cairo_scale);
OROGRAPH_CAIRO(cairo_set_tolerance);
OROGRAPH_CAIRO(cairo_surface_destroy);
OROGRAPH_CAIRO(cairo_translate);
OROGRAPH_CAIRO(g_object_unref);
OROGRAPH_CAIRO(g_unichar_decompose);
OROGRAPH_CAIRO(pango_cairo_context_set_font_options);
OROGRAPH_CAIRO(pango_cairo_font_map_new);
OROGRAPH_CAIRO(pango_cairo_layout_line_path);
OROGRAPH_CAIRO(pango_cairo_show_layout_line);
OROGRAPH_CAIRO(pango_context_get_metrics);
OROGRAPH_CAIRO(pango_context_set_language);
OROGRAPH_CAIRO(pango_context_set_round_glyph_positions);
OROGRAPH_CAIRO(pango_font_describe);
OROGRAPH_CAIRO(pango_font_description_free);
OROGRAPH_CAIRO(pango_font_description_get_family);
OROGRAPH_CAIRO(pango_font_description_new);
OROGRAPH_CAIRO(pango_font_description_set_absolute_size);
OROGRAPH_CAIRO(pango_font_description_set_family);
OROGRAPH_CAIRO(pango_font_description_set_style);
OROGRAPH_CAIRO(pango_font_description_set_weight);
OROGRAPH_CAIRO(pango_font_map_create_context);
OROGRAPH_CAIRO(pango_font_map_load_font);
OROGRAPH_CAIRO(pango_font_metrics_get_ascent);
OROGRAPH_CAIRO(pango_font_metrics_get_descent);
OROGRAPH_CAIRO(pango_font_metrics_unref);
OROGRAPH_CAIRO(pango_language_from_string);
OROGRAPH_CAIRO(pango_layout_get_extents);
OROGRAPH_CAIRO(pango_layout_get_line_readonly);
OROGRAPH_CAIRO(pango_layout_get_unknown_glyphs_count);
OROGRAPH_CAIRO(pango_layout_line_get_resolved_direction);
OROGRAPH_CAIRO(pango_layout_new);
OROGRAPH_CAIRO(pango_layout_set_font_description);
OROGRAPH_CAIRO(pango_layout_set_single_paragraph_mode);
OROGRAPH_CAIRO(pango_layout_set_text);

constexpr double kEm = 100;          // surface units that a text is laid out at
constexpr double kFlat = 1e-3 * kEm; // of outlines

struct Unref {
  void operator()(void* object) const { g_object_unref(object); }
};
struct FreeFont {
  void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }
};
struct FreeMetrics {
  void operator()(PangoFontMetrics* metrics) const { pango_font_metrics_unref(metrics); }
};
template <class Object>
using Owned = std::unique_ptr<Object, Unref>;
using FontDescription = std::unique_ptr<PangoFontDescription, FreeFont>;

double in_ems(int pango_units) {
  return static_cast<double>(pango_units) / PANGO_SCALE / kEm;
}

FontDescription description_of(const std::string& family, bool is_bold, bool is_italic) {
  FontDescription font(pango_font_description_new());
  pango_font_description_set_family(font.get(), family.c_str());
  pango_font_description_set_absolute_size(font.get(), kEm * PANGO_SCALE);
  if (is_bold) pango_font_description_set_weight(font.get(), PANGO_WEIGHT_BOLD);
  if (is_italic) pango_font_description_set_style(font.get(), PANGO_STYLE_ITALIC);
  return font;
}

Owned<PangoContext> context_of(PangoFontMap* map) {
  Owned<PangoContext> context(pango_font_map_create_context(map));
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  pango_cairo_context_set_font_options(context.get(), options);
  cairo_font_options_destroy(options);
  pango_context_set_round_glyph_positions(context.get(), FALSE);
  // The locale must not choose letters.
  pango_context_set_language(context.get(), pango_language_from_string("en"));
  return context;
}

// Of a font, in ems.
struct FontHeights {
  double ascent, descent;
};

// Of a text in UTF-8: RFC 3629, section 3.
bool is_inside_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80;
}

// What fontconfig finds in the place of whichever font is there.
bool is_alias(const std::string& family) {
  const std::string lower = in_lower_case(family);
  return std::ranges::any_of(
      std::initializer_list<const char*>{"sans", "sans-serif", "serif", "monospace", "system-ui"},
      [&](const char* alias) { return lower == alias; });
}

} // namespace

struct FontLetters::Parts {
  std::string family;
  Owned<PangoFontMap> map{pango_cairo_font_map_new()};
  Owned<PangoContext> context = context_of(map.get());
  Owned<PangoLayout> layout{pango_layout_new(context.get())};
  std::array<std::optional<FontHeights>, 4> heights = {}; ///< by style

  void set(std::string_view text, bool is_bold, bool is_italic) {
    const FontDescription font = description_of(family, is_bold, is_italic);
    pango_layout_set_font_description(layout.get(), font.get());
    pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
  }
  // Asked once for each style: it takes Pango as long as a text does.
  const FontHeights& heights_of(bool is_bold, bool is_italic) {
    std::optional<FontHeights>& kept = heights[(is_bold ? 2U : 0U) + (is_italic ? 1U : 0U)];
    if (!kept) {
      const FontDescription font = description_of(family, is_bold, is_italic);
      const std::unique_ptr<PangoFontMetrics, FreeMetrics> metrics(
          pango_context_get_metrics(context.get(), font.get(), nullptr));
      kept = FontHeights{in_ems(pango_font_metrics_get_ascent(metrics.get())),
                         in_ems(pango_font_metrics_get_descent(metrics.get()))};
    }
    return *kept;
  }
};

FontLetters::FontLetters(const std::string& family) : parts_(std::make_unique<Parts>()) {
  parts_->family = family;
  pango_layout_set_single_paragraph_mode(parts_->layout.get(), TRUE);
}
FontLetters::~FontLetters() = default;
FontLetters::FontLetters(FontLetters&&) noexcept = default;
FontLetters& FontLetters::operator=(FontLetters&&) noexcept = default;

FontExtent FontLetters::extent(std::string_view text, bool is_bold, bool is_italic) {
  parts_->set(text, is_bold, is_italic);
  PangoRectangle logical;
  pango_layout_get_extents(parts_->layout.get(), nullptr, &logical);
  const FontHeights& heights = parts_->heights_of(is_bold, is_italic);
  return {in_ems(logical.width), heights.ascent, heights.descent,
          pango_layout_line_get_resolved_direction(
              pango_layout_get_line_readonly(parts_->layout.get(), 0)) == PANGO_DIRECTION_RTL};
}

std::vector<std::vector<Vec2>> FontLetters::outlines(std::string_view text, bool is_bold,
                                                     bool is_italic) {
  parts_->set(text, is_bold, is_italic);
  cairo_surface_t* const surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
  cairo_t* const pen = cairo_create(surface);
  cairo_set_tolerance(pen, kFlat);
  cairo_move_to(pen, 0, 0);
  pango_cairo_layout_line_path(pen, pango_layout_get_line_readonly(parts_->layout.get(), 0));
  cairo_path_t* const path = cairo_copy_path_flat(pen);
  std::vector<std::vector<Vec2>> lines;
  for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
    const cairo_path_data_t* const part = path->data + i;
    if (part->header.type == CAIRO_PATH_MOVE_TO) lines.emplace_back();
    if (part->header.type == CAIRO_PATH_CLOSE_PATH) {
      if (!lines.empty() && !lines.back().empty()) lines.back().push_back(lines.back().front());
    } else if (!lines.empty()) {
      lines.back().push_back({part[1].point.x / kEm, part[1].point.y / kEm});
    }
  }
  std::erase_if(lines, [](const auto& line) { return line.size() < 2; });
  cairo_path_destroy(path);
  cairo_destroy(pen);
  cairo_surface_destroy(surface);
  return lines;
}

void FontLetters::draw(::_cairo* pen, const PageText& text, double scale) {
  parts_->set(text.text, text.is_bold, text.is_italic);
  const Vec2 start = text.start_mm();
  cairo_save(pen);
  cairo_translate(pen, start.x * scale, start.y * scale);
  cairo_rotate(pen, -text.angle.in_radians());
  const double of_em = text.size_mm * scale / kEm;
  cairo_scale(pen, of_em, of_em);
  cairo_move_to(pen, 0, 0);
  pango_cairo_show_layout_line(pen, pango_layout_get_line_readonly(parts_->layout.get(), 0));
  cairo_restore(pen);
  cairo_new_path(pen);
}

std::string FontLetters::missing_of(std::string_view text) {
  parts_->set(text, false, false);
  if (pango_layout_get_unknown_glyphs_count(parts_->layout.get()) == 0) return {};
  std::string missing;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t bytes = 1;
    while (at + bytes < text.size() && is_inside_character(text[at + bytes])) ++bytes;
    const std::string_view one = text.substr(at, bytes);
    at += bytes;
    parts_->set(one, false, false);
    if (pango_layout_get_unknown_glyphs_count(parts_->layout.get()) > 0 &&
        missing.find(one) == std::string::npos)
      missing += one;
  }
  return missing;
}

std::string FontLetters::replaced_by() const {
  if (is_alias(parts_->family)) return {};
  const FontDescription font = description_of(parts_->family, false, false);
  const Owned<PangoFont> found(
      pango_font_map_load_font(parts_->map.get(), parts_->context.get(), font.get()));
  if (!found) return "no font";
  const FontDescription of_found(pango_font_describe(found.get()));
  const char* const name = pango_font_description_get_family(of_found.get());
  if (name == nullptr) return "no font";
  return in_lower_case(name) == in_lower_case(parts_->family) ? "" : name;
}

DecomposedCharacter decomposed(char32_t character) {
  gunichar base = 0, mark = 0;
  if (!g_unichar_decompose(character, &base, &mark)) return {character, 0};
  return {base, mark};
}

} // namespace orograph
