// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a house through the whole view pipeline, stage by stage, in a perspective and in an oblique
// parallel view (docs/pipeline.md). usage: draw_house OUT_DIR
#include "figures/stage_pictures.hpp"
#include "geometry/error.hpp"
#include "view/pipeline.hpp"

#include <cstdio>
#include <string>

using namespace orograph;

namespace {

// From the south-east and above, with a plate that is tilted and a window that isn't centred before
// the eye, so that the pyramid is oblique. The back plane cuts the house's end off.
const PhigsView kPerspective{.projection = PhigsProjection::perspective,
                             .vrp_m = {9, -6, 1},
                             .vpn = {0.55, -1, 0.3},
                             .vup = {0, 0, 1},
                             .prp_m = {2.5, 3, 15},
                             .window_m = {{-4.2, 0.3}, {6.2, 8.1}},
                             .front_m = 7,
                             .back_m = -11.6};

// The gable in its true shape, and lines to the north 0.6 times as long, at 30 degrees. The front
// plane is the view plane.
const PhigsView kParallel{.projection = PhigsProjection::parallel,
                          .vrp_m = {-4, -4, 1},
                          .vpn = {0, -1, 0},
                          .vup = {0, 0, 1},
                          .prp_m = {12 + 0.6 * 0.866 * 12, 5.4 + 0.6 * 0.5 * 12, 12},
                          .window_m = {{4, -0.6}, {20, 11.4}},
                          .front_m = 0,
                          .back_m = -11.7};

// Writes FOLDER/NAME-*.svg. `viewer` sees the first of them, the world, from aside.
void draw(const PhigsView& view, const std::string& folder, const std::string& name, Vec3 viewer) {
  const Stages stages = stages_of(view);
  const auto write = [&](const LinePicture& picture, const std::string& stage) {
    const std::string title = name + "-" + stage;
    picture.write(folder + "/" + title + ".svg", title, picture.box());
  };
  write(world_picture(stages, look_at(viewer, {4, 6, 4}, {})), "world");
  write(canonical_picture(stages), "canonical");
  if (view.projection == PhigsProjection::perspective) write(straight_picture(stages), "straight");
  write(page_picture(stages), "page");
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: draw_house OUT_DIR\n", stderr);
    return 2;
  }
  try {
    draw(kPerspective, argv[1], "house-perspective", {60, -12, 26});
    draw(kParallel, argv[1], "house-parallel", {60, -40, 30});
  } catch (const Error& error) {
    std::fprintf(stderr, "draw_house: error: %s\n", error.what());
    return 1;
  }
  return 0;
}
