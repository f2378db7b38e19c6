// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the commands in groups, so that commands share them: each group stands once.
#pragma once

#include "cli/options/option.hpp"
#include "cli/render_settings.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// The group of what a command writes, to which several add.
inline constexpr auto kOutput = "Output";

/// Of the options for the terrain.
std::vector<Conflict> terrain_conflicts();

/// Of the options for terrain, view, page and messages of a picture.
std::vector<Conflict> picture_conflicts();

/// Each appends a group; what its options store into must outlive them.
void add_input(std::vector<Option>& options, std::vector<std::string>& inputs);
void add_terrain_options(std::vector<Option>& options, ReadOptions& reading);
void add_view_options(std::vector<Option>& options, RenderSettings& settings);
void add_panorama_options(std::vector<Option>& options, RenderSettings& settings);
void add_line_options(std::vector<Option>& options, RenderSettings& settings);
void add_ground_line_options(std::vector<Option>& options, RenderSettings& settings);
void add_scene_options(std::vector<Option>& options, RenderSettings& settings);
void add_page_options(std::vector<Option>& options, RenderSettings& settings);
void add_output_options(std::vector<Option>& options, RenderSettings& settings);
void add_skyline_options(std::vector<Option>& options, RenderSettings& settings);
void add_plotting_options(std::vector<Option>& options, RenderSettings& settings);
void add_label_options(std::vector<Option>& options, RenderSettings& settings);
void add_lettering_options(std::vector<Option>& options, RenderSettings& settings);
void add_pen_time_options(std::vector<Option>& options, RenderSettings& settings);

/// Appends all that `orograph render` takes but for the terrain, the drawing's file and what every
/// command takes.
void add_drawing_options(std::vector<Option>& options, RenderSettings& settings);

// Each appends one, or a few.

void add_jobs(std::vector<Option>& options, int& jobs);
/// The default is set as well: half of what is free.
void add_memory(std::vector<Option>& options, std::optional<std::uint64_t>& bytes);
/// Of how the work is done: it decides nothing of what is drawn.
void add_index_use(std::vector<Option>& options, bool& use_index);
void add_quiet(std::vector<Option>& options, bool& quiet);
void add_help(std::vector<Option>& options);
void add_full_help(std::vector<Option>& options);
/// What is about messages, and `--help`.
void add_message_options(std::vector<Option>& options, bool& quiet, std::optional<bool>& progress);
/// These, and `--settings`.
void add_general_options(std::vector<Option>& options, std::string& settings_file, bool& quiet,
                         std::optional<bool>& progress);

} // namespace orograph
