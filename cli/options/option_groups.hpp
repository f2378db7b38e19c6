// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the commands in groups, so that commands share them: each group stands once.
#pragma once

#include "cli/accuracy/accuracy.hpp"
#include "cli/fragmentation/fragmentation.hpp"
#include "cli/options/option.hpp"
#include "cli/render_settings.hpp"
#include "cli/tin.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// Of the options for the terrain.
std::vector<Conflict> terrain_conflicts();

/// Of the options for terrain, view, page and messages of a picture.
std::vector<Conflict> picture_conflicts();

/// Each appends a group; what its options store into must outlive them.
void add_terrain_options(std::vector<Option>& options, std::vector<std::string>& inputs,
                         ReadOptions& reading);
void add_view_options(std::vector<Option>& options, RenderSettings& settings);
/// A part of the view's: where the eye is, and where it looks.
void add_eye_options(std::vector<Option>& options, RenderSettings& settings);
void add_line_options(std::vector<Option>& options, RenderSettings& settings);
void add_scene_options(std::vector<Option>& options, RenderSettings& settings);
void add_page_options(std::vector<Option>& options, RenderSettings& settings);
/// What `accuracy` measures, and where it writes.
void add_accuracy_options(std::vector<Option>& options, AccuracySettings& settings);
/// What `fragmentation` measures, and where it writes.
void add_fragmentation_options(std::vector<Option>& options, FragmentationSettings& settings);
void add_output_options(std::vector<Option>& options, RenderSettings& settings);
/// With `--help`.
void add_general_options(std::vector<Option>& options, bool& quiet, std::optional<bool>& progress);

/// What `tin` makes, with `--help`.
void add_tin_options(std::vector<Option>& options, TinSettings& settings);

Option help_option();
Option quiet_option(bool& quiet);
Option jobs_option(int& jobs);

} // namespace orograph
