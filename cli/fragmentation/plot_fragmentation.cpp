// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a fragmentation study.
#include "cli/fragmentation/fragmentation_report.hpp"
#include "cli/report/measurements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

namespace orograph {
namespace {

using Rows = std::vector<const FragmentationRow*>;

// Colour tells the curve, and line or point who keeps the horizon.
constexpr std::array kColours{"#440154", "#3b6fb6", "#1f9e89", "#7fb52e", "#d8a200", "#e0561b"};
constexpr const char* kWithout = "with lines lw 1.2 dt 2";
constexpr const char* kWith = "with lines lw 2.2";
constexpr const char* kLeast = "with points pt 6 ps 0.6";
constexpr const char* kBlack = "#333333";

constexpr const char* kStyle = R"(
set border 3 lc rgb '#888888'
set tics nomirror textcolor rgb '#333333'
set grid lc rgb '#e4e4e4' lt 1 lw 1
set logscale xy
set key below Left reverse maxrows 5 textcolor rgb '#333333' samplen 2 spacing 0.95 font ',11'
set format x '%g'
set xlabel offset 0,0.6
)";
constexpr const char* kPieces = "set ylabel 'pieces of the horizon'\nset format y '10^{%T}'\n";
constexpr const char* kSeconds = "set ylabel 'clipping, ms (fastest run)'\nset format y '%g'\n";

/// Rows that are one curve.
struct Curve {
  std::string label;
  Rows rows;
};

// The numbers of a curve's points: x, then without collapse, with it, and least; NaN: none.
struct Numbers {
  double x, without, with, least;
};
using NumbersOf = std::function<double(const FragmentationRun&)>;

double most_of(const FragmentationRun& run) {
  return static_cast<double>(run.at_most);
}
double milliseconds_of(const FragmentationRun& run) {
  return 1e3 * run.seconds;
}

std::vector<Numbers> numbers_of(const Curve& curve, const NumbersOf& of) {
  std::vector<Numbers> out;
  const auto number = [&](const FragmentationRun* run) { return run ? of(*run) : -1; };
  for (const FragmentationRow* row : curve.rows)
    out.push_back({static_cast<double>(row->profiles), number(row->without_collapse()),
                   of(row->collapsed), number(row->least_run())});
  return out;
}

// Pieces after each profile of a row; as far apart as can be seen on a logarithmic axis.
std::vector<Numbers> series_of(const FragmentationRow& row) {
  std::vector<Numbers> out;
  const std::size_t count = row.collapsed.after.size();
  const auto at = [](const FragmentationRun* run, std::size_t i) {
    return run ? static_cast<double>(run->after[i]) : -1;
  };
  for (std::size_t i = 0; i < count; i += 1 + i / 12)
    out.push_back({static_cast<double>(i + 1), at(row.without_collapse(), i),
                   static_cast<double>(row.collapsed.after[i]), at(row.least_run(), i)});
  return out;
}

// Of what a logarithmic axis shows.
class AxisRange {
public:
  void take(double value) {
    if (!(value > 0)) return;
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  // With some room: gnuplot wants more than one value.
  std::string axis() const { return fmt::format("{:.4g}:{:.4g}", 0.8 * low_, 1.25 * high_); }

private:
  double low_ = 1e300, high_ = 1e-300;
};

/// A panel's script: blocks of data first, then `plot`.
class Panel {
public:
  Panel(std::string name, const std::string& title, const std::string& x_label, std::string axis)
      : name_(std::move(name)),
        head_(fmt::format("set title {}\nset xlabel {}\n{}", quoted_for_gnuplot(title),
                          quoted_for_gnuplot(x_label), axis)) {}

  void add(const std::string& label, const std::vector<Numbers>& points) {
    const std::string block = fmt::format("${}{}", name_, curves_);
    const char* colour = kColours[curves_++ % kColours.size()];
    data_ += block + " << EOD\n";
    const auto cell = [](double x) { return x >= 0 ? fmt::format(" {:.6g}", x) : " ?"; };
    for (const Numbers& p : points) {
      data_ += fmt::format("{:.6g}{}{}{}\n", p.x, cell(p.without), cell(p.with), cell(p.least));
      x_.take(p.x);
      for (const double y : {p.without, p.with, p.least}) y_.take(y);
      has_without_ = has_without_ || p.without >= 0;
      has_least_ = has_least_ || p.least >= 0;
    }
    data_ += "EOD\n";
    const auto curve = [&](int column, const char* style, const std::string& title) {
      return fmt::format("{} using 1:{} {} lc rgb '{}' {}", block, column, style, colour, title);
    };
    const auto has = [&](double Numbers::*member) {
      return std::any_of(points.begin(), points.end(),
                         [&](const Numbers& p) { return p.*member >= 0; });
    };
    if (has(&Numbers::without)) plots_.push_back(curve(2, kWithout, "notitle"));
    plots_.push_back(curve(3, kWith, "title " + quoted_for_gnuplot(label)));
    if (has(&Numbers::least)) plots_.push_back(curve(4, kLeast, "notitle"));
  }

  std::string script() const {
    if (plots_.empty()) return "set multiplot next\n";
    std::string out = data_ + head_;
    out += fmt::format("set xrange [{}]\nset yrange [{}]\nplot ", x_.axis(), y_.axis());
    for (const std::string& plot : plots_) out += plot + ", \\\n ";
    const auto key = [](const char* style, const char* title) {
      return fmt::format("NaN {} lc rgb '{}' title '{}'", style, kBlack, title);
    };
    // In black, what all curves have in common.
    if (has_without_) out += key(kWithout, "without collapse") + ", \\\n ";
    out += key(kWith, "with collapse");
    if (has_least_) out += ", \\\n " + key(kLeast, "least, in exact arithmetic");
    return out + "\n";
  }

private:
  std::string name_, head_, data_;
  std::vector<std::string> plots_;
  std::size_t curves_ = 0;
  bool has_without_ = false, has_least_ = false;
  AxisRange x_, y_;
};

// Curves of the terrain from one azimuth, by elevation; that across a grid's columns if there is
// one.
std::vector<Curve> by_elevation(const std::vector<FragmentationRow>& rows, Occluder occluder,
                                double azimuth_deg) {
  std::vector<Curve> curves;
  for (const FragmentationRow& row : rows) {
    if (row.scene != "terrain" || row.occluder != occluder || row.azimuth_deg != azimuth_deg)
      continue;
    const std::string label = fmt::format("{}°", row.elevation_deg);
    if (curves.empty() || curves.back().label != label) curves.push_back({label, {}});
    curves.back().rows.push_back(&row);
  }
  return curves;
}

double shown_azimuth_deg(const std::vector<FragmentationRow>& rows) {
  for (const FragmentationRow& row : rows)
    if (row.azimuth_deg == 180) return 180;
  return rows.front().azimuth_deg;
}

std::vector<Curve> worst_cases(const std::vector<FragmentationRow>& rows) {
  std::vector<Curve> curves;
  for (const FragmentationRow& row : rows) {
    if (row.scene == "terrain") continue;
    const std::string label = fmt::format(
        "{}, {}", row.scene, row.occluder == Occluder::surface ? "surface" : "profiles");
    if (curves.empty() || curves.back().label != label) curves.push_back({label, {}});
    curves.back().rows.push_back(&row);
  }
  return curves;
}

// The row with most profiles that was run without collapse, or else with most profiles.
const FragmentationRow& longest(const Curve& curve) {
  return **std::max_element(curve.rows.begin(), curve.rows.end(),
                            [](const FragmentationRow* a, const FragmentationRow* b) {
                              return std::pair(a->fragmented.has_value(), a->profiles) <
                                     std::pair(b->fragmented.has_value(), b->profiles);
                            });
}

} // namespace

std::string fragmentation_plot_script(const std::vector<FragmentationRow>& rows,
                                      const std::string& title, const std::string& path) {
  const double azimuth_deg = shown_azimuth_deg(rows);
  constexpr const char* kProfiles = "number of profiles";
  constexpr const char* kAfter = "profile, from the front";
  std::vector<Panel> panels;
  const auto add_row = [&](const std::string& name, const std::string& who,
                           const std::vector<Curve>& curves) {
    Panel pieces(name + "_pieces", who + ": largest horizon", kProfiles, kPieces);
    Panel after(name + "_after", who + ": horizon after each profile", kAfter, kPieces);
    Panel seconds(name + "_seconds", who + ": time", kProfiles, kSeconds);
    for (const Curve& curve : curves) {
      pieces.add(curve.label, numbers_of(curve, most_of));
      const FragmentationRow& row = longest(curve);
      after.add(fmt::format("{}, {} profiles", curve.label, row.profiles), series_of(row));
      seconds.add(curve.label, numbers_of(curve, milliseconds_of));
    }
    panels.insert(panels.end(), {pieces, after, seconds});
  };
  add_row("profiles", "Profiles hide", by_elevation(rows, Occluder::profiles, azimuth_deg));
  add_row("surface", "The surface hides", by_elevation(rows, Occluder::surface, azimuth_deg));
  if (const auto worst = worst_cases(rows); !worst.empty()) add_row("worst", "Worst cases", worst);

  const std::size_t rows_of_panels = panels.size() / 3;
  std::string script = "set encoding utf8\nset datafile missing '?'\n";
  script += fmt::format("set terminal svg size 1350,{} dynamic background rgb '#ffffff' font "
                        "'sans-serif,13'\nset output {}\n",
                        470 * rows_of_panels + 30, quoted_for_gnuplot(path));
  script += kStyle;
  script += fmt::format("set multiplot layout {},3 title {} noenhanced\n", rows_of_panels,
                        quoted_for_gnuplot(fmt::format("Fragmentation of the horizon: {}, seen "
                                                       "from {}°",
                                                       title, azimuth_deg)));
  for (const Panel& panel : panels) script += panel.script();
  return script + "unset multiplot\nunset output\n";
}

void plot_fragmentation(const std::vector<FragmentationRow>& rows, const std::string& title,
                        const std::string& path) {
  run_gnuplot(fragmentation_plot_script(rows, title, path), path, "the plots");
}

} // namespace orograph
