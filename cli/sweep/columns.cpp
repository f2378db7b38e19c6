// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/columns.hpp"

#include "geometry/vec.hpp"
#include "map/line_on_page.hpp"
#include "profiles/profile.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orograph {
namespace {

struct Picture {
  Vec2 mm;
  bool in_frame = false; ///< and in front of the picture plane
};

Picture picture_of(ProfilePoint p, const Sector& sector, const Box2& frame_mm) {
  const Vec3 h = sector.to_page.of(project_homogeneous(sector.view, p));
  const Vec2 mm{h.x / h.z, h.y / h.z};
  return {mm, h.z > 0 && mm.x >= frame_mm.low.x && mm.x <= frame_mm.high.x &&
                  mm.y >= frame_mm.low.y && mm.y <= frame_mm.high.y};
}

// What of a line is in front of the picture plane; beyond it nothing has a picture.
std::optional<ProfileLine> in_front(const ProfileLine& line, const View& view,
                                    const Homography& to_page) {
  const auto w_of = [&](ProfilePoint p) { return to_page.of(project_homogeneous(view, p)).z; };
  const double w_from = w_of(line.from), w_to = w_of(line.to);
  if (w_from <= 0 && w_to <= 0) return std::nullopt;
  if (w_from > 0 && w_to > 0) return line;
  constexpr double kNear = 1e-9; // of the greater; its picture is far outside of any frame
  const double w = kNear * std::max(w_from, w_to);
  const ProfilePoint cut = point_between(line.from, line.to, (w - w_from) / (w_to - w_from));
  return w_from > 0 ? ProfileLine{line.from, cut} : ProfileLine{cut, line.to};
}

Value cell(double number) {
  return std::isfinite(number) ? Value(number) : Value();
}
Value cell(std::optional<double> number) {
  return number ? cell(*number) : Value();
}
Value cell(std::uint64_t count) {
  return count;
}

// The columns before those that are measured.
const std::vector<Column>& leading_columns() {
  static const std::vector<Column> columns{
      {"view", "", "number of the view, from 0"},
      {"name", "", "what the drawing is called"},
      {"file", "", "the drawing"},
      {"error", "", "why there is no drawing; empty where there is one"}};
  return columns;
}

// What a parameter was where it isn't varied.
Value of_report(Parameter parameter, const RunReport& report) {
  const ViewFacts& view = report.view;
  switch (parameter) {
  case Parameter::view:
  case Parameter::eye:
    return {};
  case Parameter::azimuth:
    return cell(view.view_from_azimuth_deg);
  case Parameter::elevation:
    return cell(view.elevation_deg);
  case Parameter::look_azimuth:
    return cell(std::isfinite(view.look_azimuth_true_deg) ? view.look_azimuth_true_deg
                                                          : view.look_azimuth_deg);
  case Parameter::pitch:
    return cell(0 - view.elevation_deg); // level is 0, not -0
  case Parameter::distance:
    return cell(view.distance_m);
  case Parameter::fov:
    return cell(view.field_of_view_deg);
  case Parameter::exaggeration:
    return cell(view.exaggeration);
  case Parameter::profiles:
    return cell(std::uint64_t{report.profiles.depths_m.size()});
  }
  return {};
}

// Views and eyes have numbers only where they are varied.
bool is_shown(Parameter parameter, const std::vector<Axis>& axes) {
  if (parameter != Parameter::view && parameter != Parameter::eye) return true;
  return std::any_of(axes.begin(), axes.end(),
                     [&](const Axis& axis) { return axis.parameter == parameter; });
}

} // namespace

double GroundMeter::width_m(const Sector& sector, double depth_m) const {
  const std::vector<PlannedProfile>& profiles = sector.profiles;
  const auto at =
      std::lower_bound(profiles.begin(), profiles.end(), depth_m,
                       [](const PlannedProfile& p, double depth) { return p.depth_m < depth; });
  const bool first = at == profiles.begin(), last = at + 1 == profiles.end();
  const double nearest_m = sector.view.is_perspective()
                               ? std::max(sector.nearest_m, sector.view.near_m)
                               : sector.nearest_m;
  if (first && last) return std::max(sector.farthest_m - nearest_m, 0.0);
  // The ground at the eye's feet isn't the first profile's: it may be far from it, and unseen.
  const double behind_m = (last ? depth_m - (at - 1)->depth_m : (at + 1)->depth_m - depth_m) / 2;
  const double before_m = first ? behind_m : (depth_m - (at - 1)->depth_m) / 2;
  const double from = std::max(depth_m - before_m, nearest_m),
               to = std::min(depth_m + behind_m, sector.farthest_m);
  return std::max(to - from, 0.0);
}

void GroundMeter::see(const SeenProfile& seen) {
  const auto& [sector, clipped, profile, segments, visible] = seen;
  double ground_m = 0;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    if (profile.after[i] != Span::gap) ground_m += profile.u_m[i + 1] - profile.u_m[i];
  const View& view = sector.view;
  const auto at = [&](std::uint32_t left, double t) {
    return ProfilePoint{profile.u_m[left] + t * (profile.u_m[left + 1] - profile.u_m[left]),
                        profile.depth_m,
                        profile.z_m[left] + t * (profile.z_m[left + 1] - profile.z_m[left])};
  };
  double visible_m = 0;
  ProfilePoint end{};
  Picture ends;
  for (const Piece& piece : visible) {
    const std::uint32_t left = left_vertex(segments[piece.segment]);
    const ProfilePoint begin = at(left, piece.t_begin);
    const bool joined = begin.u == end.u && begin.z == end.z && &piece != visible.data();
    const Picture begins = joined ? ends : picture_of(begin, sector, scene_.frame_mm);
    end = at(left, piece.t_end);
    ends = picture_of(end, sector, scene_.frame_mm);
    if (begins.in_frame && ends.in_frame) {
      visible_m += std::abs(end.u - begin.u);
      visible_mm_ += plain_length(ends.mm - begins.mm);
      continue;
    }
    const auto part = in_front({begin, end}, view, sector.to_page);
    if (!part) continue;
    if (const auto line = LineOnPage::of(*part, view, sector.to_page, scene_.frame_mm)) {
      const double length_mm = line->length_mm();
      visible_m +=
          std::abs(part->to.u - part->from.u) * (line->share_at(length_mm) - line->share_at(0));
      visible_mm_ += length_mm;
    }
  }
  const double width = width_m(sector, profile.depth_m);
  ground_m2_ += width * ground_m;
  visible_m2_ += width * visible_m;
}

std::optional<double> GroundMeter::visible_share() const {
  if (!(ground_m2_ > 0)) return std::nullopt;
  return visible_m2_ / ground_m2_;
}

Columns::Columns(const SweepSettings& settings, const ViewList& views)
    : settings_(settings), views_(views) {
  const auto add = [&](Column column, std::function<Value(const DrawnView&)> of) {
    measured_.push_back({std::move(column), std::move(of)});
  };
  const auto eye = [](double Vec3::*coordinate) {
    return [coordinate](const DrawnView& f) {
      const auto& place = f.report.view.eye;
      return place ? cell((*place).*coordinate) : Value();
    };
  };
  add({"eye_x", "", "the eye's place, in the terrain's CRS"}, eye(&Vec3::x));
  add({"eye_y", "", "the eye's place, in the terrain's CRS"}, eye(&Vec3::y));
  add({"eye_z", "", "the eye's height, in the unit of the terrain's heights"}, eye(&Vec3::z));
  add({"eye_height_m", "m", "the eye above the ground, where there is ground"},
      [](const DrawnView& f) { return cell(f.report.view.eye_height_m); });
  const auto count = [&](const std::string& name, const std::string& about,
                         std::uint64_t Counts::*of) {
    add({name, "", about}, [of](const DrawnView& f) { return cell(f.report.counts.*of); });
  };
  count("cut_vertices", "vertices of all profiles", &Counts::cut_vertices);
  count("segments", "projected pieces of profiles", &Counts::segments);
  count("horizon_pieces_made", "before pieces of one source were joined, over all profiles",
        &Counts::pieces_before_collapse);
  count("horizon_pieces_kept", "after that, over all profiles", &Counts::pieces_after_collapse);
  count("horizon_largest", "pieces of the largest horizon", &Counts::largest_horizon);
  count("ties", "pieces that lie along the horizon", &Counts::ties);
  count("strokes", "lines of the drawing", &Counts::strokes);
  count("points", "of these lines", &Counts::points);
  add({"visible_mm", "mm", "visible length of the profiles on the page, before simplification"},
      [](const DrawnView& f) { return cell(f.ground.visible_mm()); });
  add({"visible_share", "", "of the ground that profiles cut, what the picture shows"},
      [](const DrawnView& f) { return cell(f.ground.visible_share()); });
  add({"pen_down_mm", "mm", "length of all lines"},
      [](const DrawnView& f) { return cell(f.report.pen_down_mm); });
  add({"pen_up_mm", "mm", "between lines"},
      [](const DrawnView& f) { return cell(f.report.pen_up_mm); });
  if (!settings.render.labels.path.empty()) {
    const auto named = [&](const std::string& name, const std::string& about, NameState state) {
      add({name, "", about}, [state](const DrawnView& f) {
        return f.report.names ? cell(std::uint64_t{f.report.names->count(state)}) : Value();
      });
    };
    named("names", "printed", NameState::chosen);
    named("names_hidden", "of summits that aren't seen", NameState::hidden);
    named("names_without_room", "of summits that are seen", NameState::crowded_out);
    add({"names_printed", "", "those that are printed, the first that counts most, with ; between"},
        [](const DrawnView& f) {
          return f.report.names ? Value(f.report.names->chosen()) : Value();
        });
  }
  if (settings.render.map.check > 0) {
    const auto checked = [&](const std::string& name, const std::string& about,
                             std::uint64_t CheckCounts::*of) {
      add({name, "", about}, [of](const DrawnView& f) {
        return f.report.check ? cell((*f.report.check).*of) : Value();
      });
    };
    checked("check_asked", "points asked of the ray walk", &CheckCounts::asked);
    checked("check_ties", "of these, not judged", &CheckCounts::ties);
    checked("check_hidden", "of these, drawn but hidden", &CheckCounts::hidden);
    checked("check_missing", "of these, visible but not drawn", &CheckCounts::missing);
  }
  if (settings.render.map.check_of_file > 0)
    add({"check_of_file_hidden", "",
         "points drawn that the file's surface hides by more than twice the level's error"},
        [](const DrawnView& f) {
          return f.report.check_of_file ? cell(f.report.check_of_file->counts.hidden) : Value();
        });
  add({"error_bound_mm", "mm", "the farthest that a line may be from its place on paper"},
      [](const DrawnView& f) { return cell(f.report.error_budget.total_mm()); });
  if (settings.seconds)
    add({"seconds", "s", "to place, draw and write the view"},
        [](const DrawnView& f) { return cell(f.seconds); });
}

std::vector<Column> Columns::columns() const {
  std::vector<Column> columns = leading_columns();
  for (const ParameterNames& names : all_parameters())
    if (is_shown(names.parameter, views_.axes()))
      columns.push_back({names.column, names.unit, names.about});
  for (const Measured& measured : measured_) columns.push_back(measured.column);
  return columns;
}

std::vector<Value> Columns::row(std::size_t number, const std::string& file,
                                const std::string& error, const DrawnView* facts) const {
  std::vector<Value> row{std::uint64_t{number}, views_.name(number), file,
                         error.empty() ? Value() : Value(error)};
  const std::vector<Axis>& axes = views_.axes();
  const std::vector<double> values = views_.values(number);
  for (const ParameterNames& names : all_parameters()) {
    if (!is_shown(names.parameter, axes)) continue;
    const auto axis = std::find_if(axes.begin(), axes.end(),
                                   [&](const Axis& a) { return a.parameter == names.parameter; });
    if (axis != axes.end())
      row.push_back(cell(values[static_cast<std::size_t>(axis - axes.begin())]));
    else
      row.push_back(facts ? of_report(names.parameter, facts->report) : Value());
  }
  for (const Measured& measured : measured_) row.push_back(facts ? measured.of(*facts) : Value());
  return row;
}

} // namespace orograph
