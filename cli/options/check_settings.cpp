// SPDX-License-Identifier: GPL-3.0-or-later
// What one option alone can't tell.
#include "cli/options/check_settings.hpp"

#include "cli/report/run_report.hpp"
#include "geometry/error.hpp"
#include "map/check_spec.hpp"
#include "map/layer_table.hpp"
#include "solids/read_scene.hpp"
#include "write/same_file.hpp"
#include "write/write_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

namespace orograph {
namespace {

void check_no_input(const RenderSettings& settings, const std::string& path,
                    const std::string& option, const std::string& its_name) {
  const ReadOptions& reading = settings.reading;
  std::vector<std::pair<std::string, const char*>> inputs{{reading.breaklines, "--breaklines"},
                                                          {reading.boundary, "--boundary"},
                                                          {settings.map.view.file_name, "--view"},
                                                          {settings.scene_file, "--scene"},
                                                          {settings.settings_file, "--settings"}};
  inputs.emplace_back(settings.pens_file, "--pens");
  inputs.emplace_back(settings.template_file, "--template");
  if (is_device_file(settings.device)) inputs.emplace_back(settings.device, "--device");
  for (const std::string& input : settings.inputs) inputs.emplace_back(input, "INPUT");
  for (const OverlayInput& overlay : settings.overlays)
    inputs.emplace_back(overlay.path, "--drape");
  inputs.emplace_back(settings.labels.path, "--labels");
  for (const auto& [input, name] : inputs)
    if (!input.empty() && replaces_input(input, path))
      throw UsageError(fmt::format("{} '{}' is the {}", option, path, name),
                       fmt::format("give {} another name", its_name));
}

void check_output(RenderSettings& settings, const GivenOptions& given) {
  const bool to_stdout = settings.output == "-";
  if (!given.contains("--of")) {
    if (to_stdout)
      throw UsageError("OUTPUT '-' (standard output) says no format",
                       "name a text format, as in --of svg");
    if (!settings.output.empty()) settings.write.format = format_of_path(settings.output);
  }
  if (to_stdout && !is_text(settings.write.format))
    throw UsageError("this format can't go to standard output",
                     "use a text format, as in --of svg, or give OUTPUT a file name");
  if (!to_stdout && !settings.output.empty())
    check_no_input(settings, settings.output, "OUTPUT", "OUTPUT");
  check_dpi(settings, given);
}

void check_report(const RenderSettings& settings, const GivenOptions& given) {
  if (!given.contains("--report")) return;
  check_no_input(settings, settings.report, "--report", "the report");
  if (settings.output != "-" && same_file(settings.report, settings.output))
    throw UsageError(fmt::format("--report '{}' is the OUTPUT too", settings.report),
                     "give the report another name");
}

void check_eye(RenderSettings& settings, const GivenOptions& given) {
  if (!settings.map.view.has_eye()) {
    refuse(given, "--eye-height --eye-summit --look-azimuth --pitch", "without an eye",
           "give --eye X,Y or --eye-lonlat LON,LAT too");
    settings.map.view.eye_height_m.reset();
    settings.map.view.eye_summit_m.reset();
    settings.map.view.look_azimuth.reset();
    settings.map.view.pitch = {};
  }
  if (insists_on(given, "--pitch") && !settings.map.view.look_azimuth)
    throw UsageError("--pitch needs a direction to look in", "give --look-azimuth DEG too");
  const bool by_lonlat = settings.map.view.eye_lonlat.has_value();
  const auto& eye = by_lonlat ? settings.map.view.eye_lonlat : settings.map.view.eye_map;
  if (eye && eye->z && !insists_on(given, "--eye-height")) settings.map.view.eye_height_m.reset();
  if (eye && eye->z && settings.map.view.eye_height_m)
    throw UsageError(fmt::format("--eye-height is for an eye on the ground, and {} has a height",
                                 by_lonlat ? "--eye-lonlat" : "--eye"),
                     by_lonlat ? "give --eye-lonlat LON,LAT, or leave --eye-height out"
                               : "give --eye X,Y, or leave --eye-height out");
  if (eye && eye == (by_lonlat ? settings.map.view.look_at_lonlat : settings.map.view.look_at_map))
    throw UsageError("the eye and what it looks at are the same point", "look at another point");
}

// A layer that has a switch of its own may be named in the list of layers as well.
void add_layers(RenderSettings& settings, const GivenOptions& given) {
  Style& style = settings.map.style;
  if (settings.void_edges && !style.asks_for("voids")) style.layers.push_back("voids");
  for (OverlayInput& overlay : settings.overlays) {
    overlay.where = settings.overlays_where;
    overlay.allow_network = settings.reading.allow_network;
  }
  for (const std::string& layer : settings.added_layers)
    if (!style.asks_for(layer)) style.layers.push_back(layer);
  if (!style.asks_for("contours") && !style.draws_index_contours())
    refuse(given, "--contour-offset --index-every --contour-ticks", "without contours",
           "give --contours INTERVAL too");
  if (!style.asks_for("mesh"))
    refuse(given, "--mesh-lines --mesh-along", "without a mesh", "give --mesh SPACING too");
  if (settings.overlays.empty()) {
    refuse(given, "--drape-where --drape-offset", "without vectors", "give --drape FILE too");
    if (insists_on(given, "--layers") && style.layers.size() == 1 && style.asks_for("drape"))
      throw UsageError("--layers names 'drape' alone, and there is nothing to drape",
                       "give --drape FILE too");
  }
  if (!style.asks_for("hachures"))
    refuse(given, "--hachure-spacing --hachure-slope", "without hachures", "give --hachures too");
  if (!style.asks_for("block"))
    refuse(given, "--block-sides", "without a block", "give --block too");
}

// Those of layers that are drawn.
void add_hidden_layers(RenderSettings& settings, const GivenOptions& given) {
  if (settings.hidden_layers.empty() && settings.dashes_hidden.value_or(false))
    settings.hidden_layers = {"solids"};
  if (!settings.dashes_hidden.value_or(true)) {
    if (insists_on(given, "--hidden"))
      refuse(given, "--hidden-layers", "where hidden lines are left out",
             "leave --hidden omit out");
    settings.hidden_layers.clear();
  }
  Style& style = settings.map.style;
  for (const std::string& name : settings.hidden_layers) {
    const auto row = std::ranges::find(layer_table(), name, &LayerRow::hidden_of);
    if (name != "solids" && !layer_of(layer_row(name), style)) {
      if (!insists_on(given, "--hidden-layers")) continue;
      throw UsageError(fmt::format("--hidden-layers names '{}', which isn't drawn", name),
                       fmt::format("add {} to --layers, or leave it out", name));
    }
    style.layers.emplace_back(std::string(row->name));
  }
}

void check_view(RenderSettings& settings, const GivenOptions& given) {
  // What a settings file says of the projection gives way to the command line.
  const bool is_oblique = given.contains("--oblique") &&
                          (insists_on(given, "--oblique") || !insists_on(given, "--projection"));
  if (is_oblique) {
    if (given.contains("--projection") && settings.map.view.projection != Projection::oblique &&
        insists_on(given, "--oblique") == insists_on(given, "--projection"))
      throw UsageError("--oblique is a projection of its own", "leave --projection out");
    settings.map.view.projection = Projection::oblique;
  }
  if (settings.map.view.from_auto && settings.map.view.projection == Projection::oblique)
    throw UsageError("--view-from auto chooses an elevation, and an oblique view has its own",
                     "give --view-from AZ/EL, or use --projection orthographic");
  if (!is_panorama(settings.map.view.projection) &&
      settings.map.view.projection != Projection::perspective) {
    for (const auto& [option, right] :
         {std::pair{"--distance", "leave it out"}, std::pair{"--fov", "leave it out"},
          std::pair{"--eye", "give --view-from AZ/EL"},
          std::pair{"--eye-lonlat", "give --view-from AZ/EL"},
          std::pair{"--eye-height", "leave it out"}, std::pair{"--eye-summit", "leave it out"},
          std::pair{"--look-azimuth", "give --view-from AZ/EL"},
          std::pair{"--pitch", "give --view-from AZ/EL"}})
      if (insists_on(given, option) || (std::string_view(option).starts_with("--eye") &&
                                        settings.map.view.has_eye() && given.contains(option)))
        throw UsageError(fmt::format("{} has no meaning in a parallel view", option),
                         fmt::format("{}, or use --projection perspective", right));
    refuse(given, "--refraction --curvature-coefficient", "in a parallel view, which has no eye",
           "leave it out, or use --projection perspective");
    settings.map.view.distance_m.reset();
    settings.map.view.field_of_view.reset();
  }
  check_eye(settings, given);
  check_panorama(settings, given);
}

void check_tone(const Style& style, const GivenOptions& given) {
  if (!style.light)
    refuse(given,
           style.haze > 0.0 ? "--light-contrast --light-smooth --light-by --haze"
                            : "--light-contrast --light-smooth --light-by",
           "without light", "leave it out, or leave --light off out");
  const bool is_on_page = !style.plan || std::holds_alternative<PageSpacing>(*style.plan);
  if (!is_on_page && style.spread == Spread::even && insists_on(given, "--spread"))
    throw UsageError("--spread even is for a spacing on the page, and these profiles are planes on "
                     "the ground",
                     "give --spacing in mm, or leave --spread out");
}

void check_page(const RenderSettings& settings, const GivenOptions& given) {
  const auto& page = settings.map.page;
  const double height_mm = page.height_mm.value_or(page.width_mm);
  const std::string size = page.height_mm ? fmt::format("{} x {} mm", page.width_mm, height_mm)
                                          : fmt::format("{} mm wide", page.width_mm);
  const double shorter_mm = std::min(page.width_mm, height_mm);
  const double longer_mm = std::max(page.width_mm, height_mm);
  if (shorter_mm - 2 * page.margin_mm < 1)
    throw UsageError(
        fmt::format("margins of {} mm leave no room on a page of {}", page.margin_mm, size),
        shorter_mm > 1 ? fmt::format("give --margin {} or less", (shorter_mm - 1) / 2)
                       : "give a larger --page");
  constexpr double kLargestSide_px = 32767; // Cairo's images
  if (settings.write.format == Format::png &&
      std::ceil(longer_mm / 25.4 * settings.write.dpi) > kLargestSide_px)
    throw UsageError(
        fmt::format("{} dots per inch make a page of {} too large for PNG", settings.write.dpi,
                    size),
        fmt::format("give --dpi {} or less", std::floor(kLargestSide_px * 25.4 / longer_mm)));
  for (const char* option : {"--portrait", "--landscape"})
    if (!page.height_mm && given.contains(option))
      throw UsageError(fmt::format("{} has no meaning on a page as high as its picture", option),
                       "leave it out, or give --page a height");
  if (page.scale && settings.map.view.projection == Projection::perspective &&
      settings.map.view.file_name.empty() && !given.contains("--views"))
    throw UsageError("--scale has no meaning in perspective, where what is near is larger",
                     "give --projection orthographic too, or leave it out");
}

// What is said of the ground, where there is none.
void check_scene_alone(const RenderSettings& settings, const GivenOptions& given) {
  refuse(given,
         "--band --oo --bbox --bbox-lonlat --overview --fill-voids --height-unit --input-layer "
         "--repair --columns --height-field --breaklines --boundary --max-edge --profiles "
         "--spacing --visibility-tolerance --silhouette-jump --flat --void-edges --check",
         "without a terrain", "leave it out, or give a DEM as INPUT and the scene as --scene");
  const Style& style = settings.map.style;
  if (!style.asks_for("hidden") && !style.asks_for("solids"))
    throw UsageError("--layers leaves nothing to draw of a scene without a terrain",
                     "leave it out, or give --layers solids");
}

void take_scene(RenderSettings& settings, const GivenOptions& given) {
  const auto scene = std::find_if(settings.inputs.begin(), settings.inputs.end(), is_scene);
  if (scene != settings.inputs.end()) {
    if (settings.inputs.size() > 1 || !settings.scene_file.empty())
      throw UsageError(fmt::format("INPUT '{}' is a scene, which stands alone", *scene),
                       "give it as --scene, beside a terrain");
    settings.scene_file = *scene;
    check_scene_alone(settings, given);
  }
  if (settings.scene_file.empty()) {
    if (!settings.map.style.asks_for("hidden")) return;
    if (insists_on(given, "--hidden-layers"))
      throw UsageError("--hidden-layers names 'solids', and there are none",
                       "give --scene FILE too, or leave solids out");
    refuse(given, "--hidden", "without solids",
           "give --scene FILE too, or --hidden-layers for other lines");
    std::erase(settings.map.style.layers, LayerSpec("hidden"));
    std::erase(settings.hidden_layers, "solids");
    return;
  }
  if (settings.map.style.occluder == Occluder::profiles)
    throw UsageError("solids stand in front of the surface and behind it, not of profiles",
                     "leave --occluder profiles out");
  settings.solids = std::make_shared<const SceneFile>(read_scene(settings.scene_file));
}

// The scene's own files are known when it is read.
void check_no_shape_file(const RenderSettings& settings) {
  if (!settings.solids) return;
  for (const std::string& file : settings.solids->shape_files)
    for (const auto& [path, option] :
         {std::pair{settings.output, "OUTPUT"}, {settings.report, "--report"}})
      if (!path.empty() && path != "-" && replaces_input(file, path))
        throw UsageError(fmt::format("{} '{}' is a file of the scene", option, path),
                         fmt::format("give {} another name", option));
}

} // namespace

void check_dpi(const RenderSettings& settings, const GivenOptions& given) {
  if (settings.write.format != Format::png)
    refuse(given, "--dpi", "in a vector format", "leave it out, or write PNG with --of png");
}

void check_output_file(const RenderSettings& settings, const std::string& path,
                       const std::string& option) {
  check_no_input(settings, path, option, option);
  for (const auto& [other, what] :
       {std::pair{settings.output, "OUTPUT"}, std::pair{settings.report, "report"}})
    if (!other.empty() && other != "-" && other != path && same_file(other, path))
      throw UsageError(fmt::format("{} '{}' is the {} too", option, path, what),
                       fmt::format("give {} another name", option));
}

void check_settings(RenderSettings& settings, const GivenOptions& given) {
  check_output(settings, given);
  check_report(settings, given);
  check_picture_settings(settings, given);
  check_skyline(settings, given);
  check_plotting(settings, given);
  check_lettering(settings, given);
  check_labels(settings, given);
  check_no_shape_file(settings);
}

void check_picture_settings(RenderSettings& settings, const GivenOptions& given) {
  add_layers(settings, given);
  add_hidden_layers(settings, given);
  settings.map.ground_points = is_tied_to_ground(settings.write.format);
  check_view(settings, given);
  check_tone(settings.map.style, given);
  check_page(settings, given);
  take_scene(settings, given);
  check_underside(settings.map);
  if (!settings.map.view.file_name.empty())
    settings.map.view.file = read_view(settings.map.view.file_name);
  if (settings.map.view.curvature == Curvature::on && settings.map.view.file &&
      settings.map.view.file->cuts())
    throw UsageError("--curvature on bends the terrain away from the view's front and back plane",
                     "leave it out, or leave the planes out of " + settings.map.view.file_name);
}

void refuse_scenes(const std::vector<std::string>& inputs) {
  const auto scene = std::find_if(inputs.begin(), inputs.end(), is_scene);
  if (scene != inputs.end())
    throw UsageError(fmt::format("INPUT '{}' is a scene, not a terrain", *scene),
                     "give a DEM or a TIN; render and sweep draw scenes");
}

void check_prefix(const RenderSettings& settings, const std::string& prefix,
                  const std::vector<std::string>& endings) {
  if (prefix.empty()) return;
  for (const std::string& ending : endings)
    check_no_input(settings, prefix + ending, "--output", "the output");
}

} // namespace orograph
