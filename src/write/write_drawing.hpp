// SPDX-License-Identifier: GPL-3.0-or-later
// Writing a drawing to a file, whole or not at all.
#pragma once

#include "draw/drawing.hpp"
#include "draw/pen_order.hpp"
#include "geometry/api.hpp"
#include "write/device.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

enum class Format { svg, pdf, ps, eps, png, geojson, gpkg, hpgl, gcode, dxf };

struct WriteOptions {
  Format format = Format::svg;
  double dpi = 300;       ///< PNG only
  bool overwrite = false; ///< may replace an existing file
  /// What HPGL and G-code are for; none: "generic" and "grbl-servo".
  std::optional<Device> device = std::nullopt;
};

/// Whether the format holds map points: the drawing must have them then.
OROGRAPH_API bool is_tied_to_ground(Format format);
/// The language of devices that the format speaks; none: no device's.
OROGRAPH_API std::optional<Device::Language> language_of(Format format);
/// What HPGL or G-code is for by these options. Throws UsageError for a device of another language.
/// REQUIRES such a format.
OROGRAPH_API Device device_of(const WriteOptions& options);
/// Whether a pen of one width draws all of it: light shows by how close lines are then.
OROGRAPH_API bool has_one_width(Format format);
/// `sorted` for formats that a pen may draw, else `drawing`: what the command takes by default.
OROGRAPH_API PenOrder pen_order_for(Format format);
/// Whether the format may be written to standard output (path "-"): text formats only.
OROGRAPH_API bool is_text(Format format);
/// By short name ("svg", "geojson", …), whatever the case. Throws UsageError that lists the names.
OROGRAPH_API Format format_of_name(std::string_view name);
/// By the path's extension. Throws UsageError that lists the extensions.
OROGRAPH_API Format format_of_path(std::string_view path);
/// Lower-case names, in the order of the enumeration.
OROGRAPH_API const std::vector<std::string>& format_names();

/// How far the format moves a point of a drawing from where it should be, at most, in mm on paper:
/// what the page's step and the format's own rounding do.
OROGRAPH_API double rounding_mm(const WriteOptions& options);

/// Refuses, with an Error, what could not be written, before any work is done: the folder is
/// missing or not writable, or the file exists and `overwrite` is off, or it is no ordinary file.
OROGRAPH_API void check_writable(const std::string& path, const WriteOptions& options);

/// Writes beside the place (same folder, temporary name with the same extension), proves it whole,
/// then renames; nothing is left behind where it throws Error (disk full, no permission, …).
/// Path "-" writes to standard output. The same drawing gives the same bytes.
OROGRAPH_API void write_drawing(const Drawing& drawing, const std::string& path,
                                const WriteOptions& options);

/// What `write_drawing` would write, of a text format. Throws UsageError of another.
OROGRAPH_API std::string text_of_drawing(const Drawing& drawing, const WriteOptions& options);

/// Writes several to a path each, whole; where one can't be written, none appears.
OROGRAPH_API void write_drawings(const std::vector<Drawing>& drawings,
                                 const std::vector<std::string>& paths,
                                 const WriteOptions& options);

/// Name to version of the libraries that stand behind reading and writing, as found at run time.
std::map<std::string, std::string> library_versions();

} // namespace orograph
