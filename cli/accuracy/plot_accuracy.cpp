// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/accuracy/plot_accuracy.hpp"

#include "cli/report/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace orograph {
namespace {

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

constexpr const char* kStyle = R"(
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

std::string accuracy_plot_script(const std::vector<AccuracyRow>& rows, const std::string& title,
                                 const std::string& path) {
  Points surface{"surface", ""}, profiles{"profiles", ""}, overview{"overview", ""};
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
    if (row.group == "profiles" || row.group == "overview" || row.group == "simplify") {
      fastest = std::min(fastest, seconds);
      slowest = std::max(slowest, seconds);
    }
    if (row.group == "profiles" || row.group == "overview")
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
  for (const Points* points : {&surface, &profiles, &overview, &measured, &promised})
    script += points->block();
  script += kStyle;
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
  if (!overview.lines.empty())
    script += ", \\\n $overview using 1:2 with points pt 5 ps 0.8 lc rgb '#6a9a3b' title "
              "'overviews', \\\n $overview " +
              labels;
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
