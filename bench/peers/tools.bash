# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2034,SC2154
# What compare knows of each tool. Sourced by it; uses its $programs, $built, $orograph, $work,
# $elevation and, of the DEM at hand, $dem, $name, $columns, $rows, $column_m, $row_m, $lowest_m and
# $highest_m.

# In the order of the table.
all_tools=(orograph orograph-default orograph-start plplot plplot-svg plplot-null ncar gle gmt-qm
  gmt-qmx r-persp gnuplot occ-poly occ-exact)

declare -A titles=(
  [orograph]='orograph (profiles)'
  [orograph-default]='orograph (default layers)'
  [orograph-start]='orograph (start-up alone)'
  [plplot]='PLplot plot3d (xfig)'
  [plplot-svg]='PLplot plot3d (svg)'
  [plplot-null]='PLplot plot3d (nothing written)'
  [ncar]='NCAR srface (ncgm)'
  [gle]='GLE surface (eps)'
  [gmt-qm]='GMT grdview -Qm (ps)'
  [gmt-qmx]='GMT grdview -Qmx (ps)'
  [r-persp]='R persp (ps)'
  [gnuplot]='gnuplot hidden3d (svg)'
  [occ-poly]='OpenCASCADE PolyAlgo (text)'
  [occ-exact]='OpenCASCADE exact HLR (text)')

# What becomes of hidden lines.
declare -A hidden=(
  [orograph]=removed [orograph-default]=removed [plplot]=removed [plplot-svg]=removed
  [plplot-null]=removed [ncar]=removed [gle]=removed [gmt-qm]='painted over'
  [gmt-qmx]='painted over' [r-persp]='painted over' [gnuplot]=removed [occ-poly]=removed
  [occ-exact]=removed [orograph-start]=-)

# Debian's package that says the version.
declare -A packages=(
  [plplot]=libplplot17 [plplot-svg]=libplplot17 [plplot-null]=libplplot17 [ncar]=libncarg-dev
  [gle]=gle-graphics [gmt-qm]=gmt [gmt-qmx]=gmt [r-persp]=r-base-core [gnuplot]=gnuplot-nox
  [occ-poly]=libocct-modeling-algorithms-7.6 [occ-exact]=libocct-modeling-algorithms-7.6)

# How far ink may be from where it should be, mm on a picture of 277 mm, and still be right: 0.03, or
# more where the tool's own raster is coarser. A tool that isn't here isn't read back.
declare -A tolerances_mm=(
  [orograph]=0.03 [plplot]=0.03 [ncar]=0.3 [gle]=0.03 [gmt-qm]=0.03 [gmt-qmx]=0.03 [r-persp]=0.03
  [gnuplot]=0.03 [occ-poly]=0.03 [occ-exact]=0.03)

# command_of TOOL: sets `output` and `run`, the command that is measured.
command_of() {
  local heights=$work/$name.heights shape=("$columns" "$rows" "$column_m" "$row_m")
  local orthographic=(--projection orthographic --view-from "180/$elevation" --spacing "${row_m}m"
    --exaggeration 1 --quiet --overwrite)
  output=$work/$name-$1
  case $1 in
    orograph)
      output+=.svg
      run=("$orograph" render "$dem" "$output" "${orthographic[@]}" --layers profiles
        --settings data_samples/settings/plain.toml)
      ;;
    orograph-default) output+=.svg && run=("$orograph" render "$dem" "$output" "${orthographic[@]}") ;;
    orograph-start) output=/dev/null && run=("$orograph" --version) ;;
    plplot) output+=.fig && run=("$built/plplot" xfig "$heights" "$output" "$elevation") ;;
    plplot-svg) output+=.svg && run=("$built/plplot" svg "$heights" "$output" "$elevation") ;;
    plplot-null) output=/dev/null && run=("$built/plplot" null "$heights" "$output" "$elevation") ;;
    ncar) output+=.ncgm && run=("$built/ncar" "$heights" "$output" "$elevation") ;;
    gle)
      output+=.eps
      run=("$programs/gle.sh" "$work/$name.z" "$output" "$elevation" "${shape[@]}" "$lowest_m"
        "$highest_m")
      ;;
    gmt-qm) output+=.ps && run=("$programs/gmt.sh" m "$dem" "$output" "$elevation" "${shape[@]}") ;;
    gmt-qmx) output+=.ps && run=("$programs/gmt.sh" mx "$dem" "$output" "$elevation" "${shape[@]}") ;;
    r-persp) output+=.ps && run=(Rscript "$programs/persp.R" "$heights" "$output" "$elevation") ;;
    gnuplot)
      output+=.svg
      run=(gnuplot -c "$programs/gnuplot.gp" "$heights" "$output" "$elevation" "${shape[@]}")
      ;;
    occ-poly) output+=.txt && run=("$built/occ" poly "$heights" "$output" "$elevation") ;;
    occ-exact) output+=.txt && run=("$built/occ" exact "$heights" "$output" "$elevation") ;;
  esac
}

# readable_of TOOL: after command_of and a run, sets `drawing`, which wrong_ink can read.
readable_of() {
  drawing=$output
  case $1 in
    ncar) # the same calls, written as PostScript
      drawing=${output%.ncgm}.ps
      "$built/ncar" "$work/$name.heights" "$drawing" "$elevation"
      ;;
    gmt-qmx) # every row's line goes back along the base, which is no profile
      drawing=${output%.ps}.txt
      gs -q -dBATCH -dNOPAUSE -dNODISPLAY -dNOBIND -dNOSAFER "$programs/../judge/strokes.ps" \
        "$output" | awk 'BEGIN { RS = ""; FS = "\n" } { for (i = 1; i <= NF - 3; ++i) print $i
          print "" }' >"$drawing"
      ;;
  esac
}
