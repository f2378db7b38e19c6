// SPDX-License-Identifier: GPL-3.0-or-later
// What one option alone can't tell: values and paths that don't go together.
#pragma once

#include "cli/options/option.hpp"
#include "cli/render_settings.hpp"

#include <string>
#include <vector>

namespace orograph {

/// Settles the output's format (by `--of`, else by OUTPUT's extension) and throws UsageError where
/// settings contradict each other, an output is an input, or the page has no room. What only a
/// settings file says, and what has no meaning here, is left out instead.
void check_settings(RenderSettings& settings, const GivenOptions& given);

/// The same of view and page alone.
void check_picture_settings(RenderSettings& settings, const GivenOptions& given);

/// Of names and labels, once layers and view are settled.
void check_labels(RenderSettings& settings, const GivenOptions& given);

/// Reads the template, if there is one, and settles what letters texts have, once format, pens and
/// sheets are known. Throws Error.
void check_lettering(RenderSettings& settings, const GivenOptions& given);

/// Throws UsageError where options of panoramas are given for another projection, or the other way
/// round, and where a panorama has no eye.
void check_panorama(const RenderSettings& settings, const GivenOptions& given);

/// Settles the order of strokes, device and pens, as the format wants them, how light shows, and
/// the page of several sheets. Throws UsageError where what is asked has no meaning in the format,
/// and what `read_device` and `read_pens` throw. REQUIRES a format.
void check_plotting(RenderSettings& settings, const GivenOptions& given);

/// Throws UsageError where dots per inch are given for vectors.
void check_dpi(const RenderSettings& settings, const GivenOptions& given);

/// Throws UsageError where the skyline's table or its step has no meaning, or the table replaces an
/// input or another output.
void check_skyline(const RenderSettings& settings, const GivenOptions& given);

/// Throws UsageError where a file that `option` names to be written is an input, the OUTPUT or the
/// report.
void check_output_file(const RenderSettings& settings, const std::string& path,
                       const std::string& option);

/// Throws UsageError where an input is a scene.
void refuse_scenes(const std::vector<std::string>& inputs);

/// Throws UsageError where one of the files PREFIX + ending, for each ending, is an input.
void check_prefix(const RenderSettings& settings, const std::string& prefix,
                  const std::vector<std::string>& endings);

} // namespace orograph
