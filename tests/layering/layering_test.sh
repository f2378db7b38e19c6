#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The tree keeps to its layers; and scripts/check-layering sees it where a planted line doesn't.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
check=$root/scripts/check-layering

"$check" || { echo "FAILED: the tree doesn't keep to its layers"; exit 1; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

# expect RED|GREEN FILE LINE: plants that line in that file of a tree of such files, which is looked at
# once, at the end: what a line is doesn't depend on others.
colours=()
places=()
lines=()
expect() {
  local file=$scratch/tree/$2
  mkdir -p "${file%/*}"
  printf '%s\n' "$3" >>"$file"
  colours+=("$1")
  places+=("$2:$(wc -l <"$file")")
  lines+=("$3")
}

expect GREEN src/view/view.cpp '#include "geometry/vec.hpp"'
expect GREEN src/view/view.cpp '#include <vector>'
expect GREEN python/views.cpp '#include "cli/options/options.hpp"'
expect GREEN python/module.cpp '#include <pybind11/numpy.h>'
expect RED python/views.cpp '#include <pybind11/numpy.h>'
expect RED cli/render.cpp '#include "python/views.hpp"'
expect GREEN src/measure/accuracy.cpp '#include "map/draw_map.hpp"'
expect RED src/measure/accuracy.cpp '#include "orograph.hpp"'
expect RED src/map/draw_map.cpp '#include "measure/meters.hpp"'
expect RED src/map/draw_map.cpp '#include <pybind11/numpy.h>'
expect GREEN src/view/view.cpp '#include <fmt/format.h>'
expect GREEN profiles/plan.cpp '#include "dem/grid.hpp"'
expect GREEN cli/render.cpp '#include "draw/drawing.hpp"'
expect GREEN cli/render.cpp '#include <CLI/CLI.hpp>'
expect GREEN cli/options/settings_file.cpp '#include <toml++/toml.h>'
expect GREEN cli/render.cpp '#include <sys/resource.h>'
expect GREEN dem/read.cpp '#include <gdal_priv.h>'
expect GREEN dem/frame/local_frame.cpp '#include <GeographicLib/Geodesic.hpp>'
expect GREEN data_samples/make.cpp '#include "dem/grid.hpp"'
expect RED data_samples/make.cpp '#include <gdal_priv.h>'
expect RED data_samples/make.cpp '#include "cli/render.hpp"'
expect GREEN figures/draw.cpp '#include "view/pipeline.hpp"'
expect GREEN figures/draw.cpp '#include <Eigen/LU>'
expect RED figures/draw.cpp '#include "dem/grid.hpp"'
expect GREEN src/write/ogr.cpp '#include <ogrsf_frmts.h>'
expect GREEN src/write/pdf.cpp '#include <cairo-pdf.h>'
expect GREEN src/reference/exact_clip.cpp '#include <CGAL/Gmpq.h>'
expect GREEN src/view/pipeline.cpp '#include <Eigen/Core>'
expect GREEN src/view/pipeline.hpp '#include <Eigen/Core>'
expect GREEN src/solids/read_scene.cpp '#include "view/pipeline.hpp"'
expect GREEN src/solids/scene_file.hpp '#include <Eigen/Core>'
expect GREEN src/text/toml_table.cpp '#include <toml++/toml.h>'
expect GREEN src/reference/ray.cpp '#include "solids/solid.hpp"'
expect GREEN cli/render.cpp '#include "solids/read_scene.hpp"'
expect GREEN cli/render.cpp '#include "write/write_drawing.hpp"'
expect GREEN src/write/svg.cpp '#include "draw/drawing.hpp"'
expect GREEN src/draw/page.cpp '#include "text/words.hpp"'
expect GREEN src/text/text_of_file.cpp '#include "geometry/error.hpp"'

expect GREEN cli/render.cpp 'throw UsageError("too far", "give --distance");'
expect GREEN dem/read.cpp 'throw Error("no heights", "gdal_calc.py --outfile=heights.tif");'
expect GREEN src/view/view.cpp '// as --distance has it'
expect RED src/view/view.cpp 'throw Error("too far", "give a greater --distance");'

# back-includes
expect RED src/geometry/vec.hpp '#include "dem/grid.hpp"'
expect RED dem/grid.cpp '#include "view/view.hpp"'
expect RED dem/grid.cpp '#include "profiles/plan.hpp"'
expect RED src/view/view.cpp '#include "dem/grid.hpp"'
expect RED src/horizon/clip.cpp '#include "profiles/plan.hpp"'
expect RED src/horizon/clip.cpp '#include "reference/ray.hpp"'
expect RED src/text/words.cpp '#include "geometry/vec.hpp"'
expect RED src/geometry/error.hpp '#include "text/words.hpp"'
expect RED src/draw/page.cpp '#include "write/byte_sink.hpp"'
expect RED src/map/draw_map.cpp '#include "write/write_drawing.hpp"'
expect RED src/write/svg.cpp '#include "cli/report.hpp"'
expect RED src/write/svg.cpp '  #  include  "cli/report.hpp" // spread out'
expect RED src/solids/walk_scene.cpp '#include "dem/grid.hpp"'
expect RED src/view/view.cpp '#include "solids/solid.hpp"'
expect RED src/reference/ray.cpp '#include "cli/report.hpp"'
expect RED profiles/plan.cpp '#include "horizon/clip.hpp"'
# by another road
expect RED src/view/view.cpp '#include "src/draw/drawing.hpp"'
expect RED src/view/view.cpp '#include "../draw/drawing.hpp"'
expect RED src/view/view.cpp '#include <draw/drawing.hpp>'
expect RED src/view/view.cpp '#include "view.hpp"'
expect RED cli/render.cpp '#include "tests/catch.hpp"'
# foreign libraries outside their place
expect RED src/view/view.cpp '#include <gdal.h>'
expect RED profiles/plan.cpp '#include "cpl_error.h"'
expect RED cli/info.cpp '#include <ogr_spatialref.h>'
expect RED cli/render.cpp '#include <cairo.h>'
expect RED src/draw/page.cpp '#include <cairo.h>'
expect RED src/write/write_cairo.cpp '#include <dlfcn.h>'
expect RED dem/read.cpp '#include <cairo/cairo.h>'
expect RED src/horizon/clip.cpp '#include <CGAL/Gmpq.h>'
expect RED dem/mesh/walls.cpp '#include <CGAL/Gmpq.h>'
expect RED dem/read/read_points.cpp '#include <pugixml.hpp>'
expect RED src/view/frame.cpp '#include <GeographicLib/Geodesic.hpp>'
expect RED dem/frame/local_frame.hpp '#include <GeographicLib/Geodesic.hpp>'
expect RED dem/frame/earth_lattice.cpp '#include <GeographicLib/Math.hpp>'
expect RED src/write/svg.cpp '#include <CLI/CLI.hpp>'
expect RED profiles/plan.cpp '#include <Eigen/Core>'
expect RED src/view/view.cpp '#include <toml++/toml.h>'
expect RED src/text/toml_table.hpp '#include <toml++/toml.h>'
expect RED cli/options/settings_file.hpp '#include <toml++/toml.h>'
expect RED cli/view_file.cpp '#include <toml++/toml.h>'
expect RED src/geometry/homography.hpp '#include <Eigen/Core>'
expect RED dem/read.cpp '#include <nlohmann/json.hpp>'
expect RED dem/read/read_raster.hpp '#include <gdal.h>'
expect RED cli/render.cpp '#include <boost/optional.hpp>'
expect RED src/write/png.cpp '#include <png.h>'

if "$check" "$scratch/tree" >"$scratch/said"; then
  echo 'FAILED: planted lines pass'
  failures=1
fi
cut -d: -f1,2 "$scratch/said" >"$scratch/named"
for i in "${!places[@]}"; do
  colour=GREEN
  ! grep --quiet --line-regexp --fixed-strings "${places[i]}" "$scratch/named" || colour=RED
  if [[ $colour != "${colours[i]}" ]]; then
    echo "FAILED: ${lines[i]} at ${places[i]} is $colour, should be ${colours[i]}"
    failures=$((failures + 1))
  fi
done
[[ $failures -eq 0 ]]
