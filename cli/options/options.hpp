// SPDX-License-Identifier: GPL-3.0-or-later
// The commands and their options: one table, from which parsing, `--help`, range checks and the man
// page come.
#pragma once

#include "cli/accuracy/accuracy.hpp"
#include "cli/fragmentation/fragmentation.hpp"
#include "cli/index.hpp"
#include "cli/info.hpp"
#include "cli/options/option.hpp"
#include "cli/render_settings.hpp"
#include "cli/sweep/sweep.hpp"
#include "cli/tin.hpp"
#include "cli/visible.hpp"

#include <optional>
#include <string>
#include <vector>

namespace orograph {

/// The options store into `settings`, which must outlive the command.
Command render_command(RenderSettings& settings);
Command sweep_command(SweepSettings& settings);
Command merge_command(MergeSettings& settings);
Command accuracy_command(AccuracySettings& settings);
Command fragmentation_command(FragmentationSettings& settings);
Command info_command(InfoSettings& settings);
/// What `read` takes of a terrain's files, for programs; INPUT is one or several.
InfoSettings take_reading(const NamedValues& options);
Command index_command(IndexSettings& settings);
Command tin_command(TinSettings& settings);
Command visible_command(VisibleSettings& settings);

/// What `orograph render` takes but for the terrain, the drawing's file, report and messages: for
/// programs that have these in ways of their own.
Command drawing_command(RenderSettings& settings);

/// What `orograph visible` takes but for the terrain, the points, files and messages, of points or
/// of the skyline all round: for the same programs.
Command sights_command(VisibleSettings& settings);
Command skyline_command(VisibleSettings& settings);

/// The settings that these options of one of the two ask for. Throws the Errors of `parse_visible`.
VisibleSettings take_sights(const NamedValues& options);
VisibleSettings take_skyline(const NamedValues& options);

/// Gives `settings`, whose inputs and output (which may be empty beside `of`) are set, what these
/// options of `drawing_command` say. Throws the Errors of `parse_render`.
void take_drawing(RenderSettings& settings, const NamedValues& options);

/// The settings that a command line (without "orograph render") asks for; nothing where it asks
/// for help. Opens no file, but looks whether two of its paths are the same file.
/// Throws UsageError.
std::optional<RenderSettings> parse_render(const std::vector<std::string>& arguments);
std::optional<SweepSettings> parse_sweep(const std::vector<std::string>& arguments);
std::optional<MergeSettings> parse_merge(const std::vector<std::string>& arguments);
std::optional<AccuracySettings> parse_accuracy(const std::vector<std::string>& arguments);
std::optional<FragmentationSettings> parse_fragmentation(const std::vector<std::string>& arguments);
std::optional<InfoSettings> parse_info(const std::vector<std::string>& arguments);
std::optional<IndexSettings> parse_index(const std::vector<std::string>& arguments);
std::optional<TinSettings> parse_tin(const std::vector<std::string>& arguments);
std::optional<VisibleSettings> parse_visible(const std::vector<std::string>& arguments);

} // namespace orograph
