// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/accuracy/accuracy_report.hpp"

#include "cli/report/measurements.hpp"
#include "text/aligned_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

using Cells = std::vector<std::string>;

std::string number(double x) {
  return fmt::format("{:.3g}", x);
}

std::string number_or_dash(const std::optional<double>& x) {
  return x ? number(*x) : "-";
}

// "0.31 ±0.04", or what would have been seen: "0 (<0.015)".
std::string percent(const InkSample& ink) {
  if (ink.asked == 0) return "-";
  if (ink.hidden + ink.missing == 0) return fmt::format("0 (<{:.2g})", 100 * ink.smallest_seen());
  return fmt::format("{:.3g} ±{:.2g}", 100 * ink.error(), 100 * ink.standard_error());
}

Cells cells_of(const AccuracyRow& row) {
  const StageSeconds& s = row.seconds;
  const auto promised_percent =
      row.promise.ink_error ? number(100 * *row.promise.ink_error) : std::string("-");
  return {name_of(row),
          milliseconds(s.facing, 1),
          milliseconds(s.cut, 1),
          milliseconds(s.project, 1),
          milliseconds(s.clip, 1),
          milliseconds(s.layout, 1),
          milliseconds(s.total, 1),
          std::to_string(row.counts.segments),
          row.simplified ? std::to_string(row.counts.strokes) : "-",
          std::to_string(row.counts.largest_horizon),
          percent(row.profiles),
          percent(row.lines),
          promised_percent,
          row.ends.asked > 0 ? number(row.ends.largest_mm) : "-",
          row.simplified ? number(row.simplified->largest_mm) : "-",
          number_or_dash(row.arithmetic_mm),
          number_or_dash(row.detail_mm),
          number_or_dash(row.promise.displacement_mm)};
}

// What every row holds.
Record record_of(const AccuracyRow& row) {
  const RowSettings& s = row.settings;
  const InkSample ink = row.profiles + row.lines;
  constexpr std::array<const char*, 3> kArithmetics{"float", "double", "exact"};
  const auto whole = [](std::optional<int> x) {
    return x ? Value(static_cast<std::uint64_t>(*x)) : Value();
  };
  return {{"name", name_of(row)},
          {"varied", row.group},
          {"occluder", s.occluder == Occluder::surface ? "surface" : "profiles"},
          {"profiles", row.profile_count},
          {"simplify_mm", s.simplify_mm},
          {"collapse", s.collapse},
          {"overview", whole(s.overview)},
          {"level_error_mm", s.level_error_mm ? Value(*s.level_error_mm) : Value()},
          {"arithmetic", kArithmetics[static_cast<std::size_t>(s.arithmetic)]},
          {"facing_s", row.seconds.facing},
          {"cut_s", row.seconds.cut},
          {"project_s", row.seconds.project},
          {"clip_s", row.seconds.clip},
          {"layout_s", row.seconds.layout},
          {"total_s", row.seconds.total},
          {"segments", row.counts.segments},
          {"strokes", row.simplified ? Value(row.counts.strokes) : Value()},
          {"largest_horizon", row.counts.largest_horizon},
          {"probes", ink.asked},
          {"ties", ink.ties},
          {"drawn_but_hidden", ink.hidden},
          {"visible_but_missing", ink.missing},
          {"ink_error", ink.error()},
          {"ink_standard_error", ink.standard_error()},
          {"ink_smallest_seen", ink.smallest_seen()},
          {"profiles_ink_error", row.profiles.error()},
          {"lines_ink_error", row.lines.asked > 0 ? Value(row.lines.error()) : Value()},
          {"promised_ink_error", known(row.promise.ink_error)},
          {"ends_asked", row.ends.asked},
          {"ends_tied", row.ends.tied},
          {"ends_astray", row.ends.astray},
          {"ends_mm", row.ends.asked > 0 ? Value(row.ends.largest_mm) : Value()},
          {"simplified_mm", row.simplified ? Value(row.simplified->largest_mm) : Value()},
          {"strokes_compared", row.simplified ? Value(row.simplified->strokes) : Value()},
          {"arithmetic_mm", known(row.arithmetic_mm)},
          {"level_of_detail_mm", known(row.detail_mm)},
          {"displacement_mm", row.displacement_mm()},
          {"promised_displacement_mm", known(row.promise.displacement_mm)},
          {"promised_simplified_mm", known(row.promise.simplified_mm)},
          {"keeps_promise", broken_promise(row).empty()}};
}

std::vector<Record> records_of(const std::vector<AccuracyRow>& rows) {
  std::vector<Record> records;
  for (const AccuracyRow& row : rows) records.push_back(record_of(row));
  return records;
}

// A block of data: time in ms, a value, a label.
struct Points {
  std::string name, lines;

  void add(double seconds, double value, const std::string& label) {
    lines += fmt::format("{:.6g} {:.6g} \"{}\"\n", 1e3 * seconds, value, label);
  }
  std::string block() const { return fmt::format("${} << EOD\n{}EOD\n", name, lines); }
};

// A logarithmic axis has no zero: where no point was wrong, the place is what would have been seen.
double shown_percent(const InkSample& ink) {
  return 100 * (ink.hidden + ink.missing == 0 ? ink.smallest_seen() : ink.error());
}

// Displacements below this are shown as this: it is the arithmetic's.
constexpr double kLeastShown_mm = 1e-9;

constexpr const char* kCurveStyle = R"(
set border 3 lc rgb '#888888'
set tics nomirror textcolor rgb '#333333'
set grid lc rgb '#e4e4e4' lt 1 lw 1
set logscale xy
set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, '1 s' 1e3, '2 s' 2e3, '5 s' 5e3, \
  '10 s' 1e4, '20 s' 2e4, '50 s' 5e4, '100 s' 1e5, '1000 s' 1e6)
set key top left Left reverse textcolor rgb '#333333' samplen 1.5
set xlabel 'time to draw, ms (fastest run; reading and writing apart)'
)";

} // namespace

std::string accuracy_table(const std::vector<AccuracyRow>& rows) {
  std::vector<Cells> table{{"", "facing", "cut", "project", "clip", "layout", "total", "segments",
                            "strokes", "largest", "ink error, %", "", "promised", "ends",
                            "simplified", "arithmetic", "detail", "promised"},
                           {"settings", "ms", "ms", "ms", "ms", "ms", "ms", "", "", "horizon",
                            "profiles", "other lines", "%", "mm", "mm", "mm", "mm", "mm"}};
  for (const AccuracyRow& row : rows) table.push_back(cells_of(row));
  return aligned_table(table);
}

std::string accuracy_csv(const std::vector<AccuracyRow>& rows) {
  return csv_of(records_of(rows));
}

std::string accuracy_json(const std::vector<AccuracyRow>& rows, const std::string& terrain) {
  return json_of(terrain, {{"rows", records_of(rows)}});
}

std::string accuracy_plot_script(const std::vector<AccuracyRow>& rows, const std::string& title,
                                 const std::string& path) {
  Points surface{"surface", ""}, profiles{"profiles", ""}, overview{"overview", ""},
      level{"level", ""};
  Points measured{"measured", ""}, promised{"promised", ""};
  double fastest = 1e9, slowest = 0, smallest_percent = 100, smallest_mm = 1;
  bool found_on_surface = false;
  std::size_t varied = 0; // the number of profiles at which simplification is varied
  for (const AccuracyRow& row : rows)
    if (row.group == "simplify") varied = row.profile_count;
  for (const AccuracyRow& row : rows) {
    const InkSample ink = row.profiles + row.lines;
    const double seconds = row.seconds.total;
    const std::string count = std::to_string(row.profile_count);
    const bool of_surface = row.settings.occluder == Occluder::surface;
    if (of_surface && row.group == "profiles" && ink.error() > 0) found_on_surface = true;
    if (row.group == "profiles")
      (of_surface ? surface : profiles).add(seconds, shown_percent(ink), count);
    else if (row.group == "overview")
      overview.add(seconds, shown_percent(ink), fmt::format("overview {}", *row.settings.overview));
    else if (row.group == "level error")
      level.add(seconds, shown_percent(ink), fmt::format("{} mm", *row.settings.level_error_mm));
    if (row.group == "profiles" || row.group == "overview" || row.group == "level error" ||
        row.group == "simplify") {
      fastest = std::min(fastest, seconds);
      slowest = std::max(slowest, seconds);
    }
    if (row.group == "profiles" || row.group == "overview" || row.group == "level error")
      smallest_percent = std::min(smallest_percent, shown_percent(ink));
    if (of_surface && row.profile_count == varied && row.promise.displacement_mm) {
      const double mm = std::max(row.displacement_mm(), kLeastShown_mm);
      smallest_mm = std::min(smallest_mm, mm);
      measured.add(seconds, mm, fmt::format("simplify {} mm", row.settings.simplify_mm));
      promised.add(seconds, *row.promise.displacement_mm, "");
    }
  }

  std::string script = "set encoding utf8\n";
  script +=
      "set terminal svg size 1000,460 dynamic background rgb '#ffffff' font 'sans-serif,13'\n";
  script += fmt::format("set output {}\n", quoted_for_gnuplot(path));
  for (const Points* points : {&surface, &profiles, &overview, &level, &measured, &promised})
    script += points->block();
  script += kCurveStyle;
  script += fmt::format("set xrange [{:.4g}:{:.4g}]\n", 600 * fastest, 1600 * slowest);
  script += fmt::format("set multiplot layout 1,2 title {} noenhanced\n",
                        quoted_for_gnuplot("Speed and accuracy: " + title));
  const std::string labels =
      "using 1:2:3 with labels offset 0,0.9 font ',11' textcolor rgb '#333333' notitle";
  script += "set title 'Ink error: drawn but hidden, or visible but missing'\n"
            "set ylabel 'percent of the visible length'\n"
            "set format y '%g'\n";
  script += fmt::format("set yrange [{:.3g}:1000]\n", smallest_percent / 3);
  script += "plot $profiles using 1:2 with linespoints pt 7 ps 0.8 lw 2 lc rgb '#c0504d' title "
            "'profiles hide', \\\n $profiles " +
            labels +
            ", \\\n $surface using 1:2 with linespoints pt 11 ps 1.1 lw 2 lc rgb '#1f5f99' title "
            "'the surface hides" +
            (found_on_surface ? "" : ": none found, at most this") + "', \\\n $surface " + labels;
  const auto add_if_any = [&](const Points& points, const std::string& name,
                              const std::string& look) {
    if (!points.lines.empty())
      script +=
          fmt::format(", \\\n ${0} using 1:2 with points {1}, \\\n ${0} {2}", name, look, labels);
  };
  add_if_any(overview, "overview", "pt 5 ps 0.8 lc rgb '#6a9a3b' title 'overviews'");
  add_if_any(level, "level", "pt 9 ps 0.9 lc rgb '#8a5fb0' title 'larger cells, by --level-error'");
  script += fmt::format("\nset title 'Displacement, surface, {} profiles'\n", varied);
  script += "set ylabel 'mm on paper'\n"
            "set format y '10^{%T}'\n";
  script += fmt::format("set yrange [{:.3g}:100]\n", smallest_mm / 10);
  script +=
      "plot $promised using 1:2 with points pt 1 ps 1.2 lw 2 lc rgb '#888888' title "
      "'promised by the error budget', \\\n $measured using 1:2 with points pt 7 ps 0.8 lc "
      "rgb '#1f5f99' title 'measured', \\\n $measured using 1:2:3 with labels right offset -1.2,0 "
      "font ',11' textcolor rgb '#333333' notitle\n";
  return script + "unset multiplot\nunset output\n";
}

void plot_accuracy(const std::vector<AccuracyRow>& rows, const std::string& title,
                   const std::string& path) {
  run_gnuplot(accuracy_plot_script(rows, title, path), path, "the curve");
}

} // namespace orograph
