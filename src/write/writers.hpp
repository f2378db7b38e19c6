// SPDX-License-Identifier: GPL-3.0-or-later
// One writer for each family of formats; `write_drawing` chooses. All throw Error.
#pragma once

#include "draw/drawing.hpp"
#include "write/byte_sink.hpp"
#include "write/device.hpp"
#include "write/place_on_device.hpp"
#include "write/write_drawing.hpp"

#include <string>

namespace orograph {

/// Streamed: no memory beyond the sink's buffer.
void write_svg(const Drawing& drawing, ByteSink& out);

/// PDF, PS, EPS or PNG.
void write_by_cairo(const Drawing& drawing, const WriteOptions& options, ByteSink& out);

// Streamed too. Where strokes touch, the pen stays down. Throw UsageError where the pens don't fit
// the device.
void write_hpgl(const Drawing& drawing, const Device& device, const OnDevice& on_device,
                ByteSink& out);
void write_gcode(const Drawing& drawing, const Device& device, const OnDevice& on_device,
                 ByteSink& out);

/// In millimetres, with what shows a pen's way on a layer of its own. Made in memory: about 100
/// bytes a point.
void write_dxf(const Drawing& drawing, ByteSink& out);

/// Streamed. REQUIRES map points.
void write_geojson(const Drawing& drawing, ByteSink& out);
/// Replaces the file at `path`; messages call it `name`. REQUIRES map points.
void write_geopackage(const Drawing& drawing, const std::string& path, const std::string& name);
/// Opens the file again and throws unless all strokes are there.
void prove_geopackage(const Drawing& drawing, const std::string& path, const std::string& name);

} // namespace orograph
