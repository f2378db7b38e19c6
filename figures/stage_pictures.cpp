// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/stage_pictures.hpp"

#include "figures/house.hpp"
#include "view/pipeline.hpp"

#include <Eigen/LU>

#include <array>
#include <optional>

namespace orograph {
namespace {

constexpr std::array<Vec2, 4> kAround{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
constexpr CanonicalVolume kParallelVolume{PhigsProjection::parallel, 0};

bool is_perspective(const CanonicalVolume& volume) {
  return volume.projection == PhigsProjection::perspective;
}

struct Segment {
  Vec3 from, to;
};

Eigen::Vector4d homogeneous(Vec3 p) {
  return {p.x, p.y, p.z, 1};
}

// REQUIRES an affine matrix.
Vec3 moved(const Eigen::Matrix4d& matrix, Vec3 p) {
  const Eigen::Vector4d image = matrix * homogeneous(p);
  return {image.x(), image.y(), image.z()};
}

// The corner of a canonical volume's section at z.
Vec3 corner(const CanonicalVolume& volume, Vec2 direction, double z) {
  const double reach = is_perspective(volume) ? -z : 1;
  return {reach * direction.x, reach * direction.y, z};
}

// The edges of a canonical volume, and the rays from the eye to its front plane.
void add_volume(LinePicture& picture, const CanonicalVolume& volume,
                const Eigen::Matrix4d& to_picture) {
  const double front = volume.z_min;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 a = kAround[i], b = kAround[(i + 1) % 4];
    for (const double z : {-1.0, front})
      picture.add(to_picture, corner(volume, a, z), corner(volume, b, z), LineOf::volume);
    picture.add(to_picture, corner(volume, a, -1), corner(volume, a, front), LineOf::volume);
    if (is_perspective(volume)) picture.add(to_picture, {}, corner(volume, a, front), LineOf::ray);
  }
}

bool shows(const Face& face, const Eigen::Matrix4d& to_picture) {
  const Vec2 a = picture_of(to_picture, face[0]), b = picture_of(to_picture, face[1]),
             c = picture_of(to_picture, face[2]);
  return cross(b - a, c - a) > 1e-9; // the stages mirror nothing
}

// A part of a line from t_begin to t_end, if that has a length.
void add_part(LinePicture& picture, const Eigen::Matrix4d& to_picture, const Segment& line,
              double t_begin, double t_end, LineOf pen) {
  const auto at = [&](double t) { return line.from + t * (line.to - line.from); };
  if (t_begin < t_end) picture.add(to_picture, at(t_begin), at(t_end), pen);
}

void add_clipped(LinePicture& picture, const CanonicalVolume& volume,
                 const Eigen::Matrix4d& to_picture, const Segment& line, LineOf pen,
                 bool also_cut_away) {
  const auto part = clip_to_volume(homogeneous(line.from), homogeneous(line.to), volume);
  const double begin = part ? part->t_begin : 1, end = part ? part->t_end : 1;
  add_part(picture, to_picture, line, begin, end, pen);
  if (!also_cut_away) return;
  add_part(picture, to_picture, line, 0, begin, LineOf::cut_away);
  add_part(picture, to_picture, line, end, 1, LineOf::cut_away);
}

// A line of the house in the canonical volume.
Segment mapped(const Stages& stages, const HouseLine& line) {
  const Eigen::Matrix4d canonical = stages.mapping * stages.orientation;
  return {moved(canonical, line.from), moved(canonical, line.to)};
}

// Where the back plane cuts a face: between the two edges that it meets.
std::optional<Segment> section(const Stages& stages, const House& model, std::size_t face) {
  std::vector<Vec3> ends;
  for (const HouseLine& line : model.lines) {
    const bool is_its_edge =
        line.faces[0] != line.faces[1] && (line.faces[0] == face || line.faces[1] == face);
    const auto [from, to] = mapped(stages, line);
    if (!is_its_edge || (from.z < -1) == (to.z < -1)) continue;
    const Vec3 at = from + ((from.z + 1) / (from.z - to.z)) * (to - from);
    ends.push_back({at.x, at.y, -1});
  }
  if (ends.size() != 2) return std::nullopt;
  return Segment{ends[0], ends[1]};
}

// The house in the picture that a matrix makes of the canonical volume.
void add_house(LinePicture& picture, const Stages& stages, const Eigen::Matrix4d& to_picture,
               bool also_cut_away) {
  const House model = house();
  const Eigen::Matrix4d from_world = to_picture * stages.mapping * stages.orientation;
  std::vector<bool> seen;
  for (const Face& face : model.faces) seen.push_back(shows(face, from_world));
  for (const HouseLine& line : model.lines)
    add_clipped(picture, stages.volume, to_picture, mapped(stages, line),
                seen[line.faces[0]] || seen[line.faces[1]] ? LineOf::house : LineOf::turned_away,
                also_cut_away);
  for (std::size_t face = 0; face < model.faces.size(); ++face)
    if (const auto line = section(stages, model, face))
      add_clipped(picture, stages.volume, to_picture, *line,
                  seen[face] ? LineOf::section : LineOf::turned_away, false);
}

void add_axes(LinePicture& picture, const Eigen::Matrix4d& to_picture, double reach) {
  for (const Vec3 end : {Vec3{reach, 0, 0}, Vec3{0, reach, 0}, Vec3{0, 0, reach}})
    picture.add(to_picture, {}, end, LineOf::axis, true);
}

// In a canonical volume that a matrix maps the view's own one to.
LinePicture volume_picture(const Stages& stages, const CanonicalVolume& volume,
                           const Eigen::Matrix4d& to_volume) {
  const Eigen::Matrix4d aside = view_orientation({}, {1, 0.4, 0.6}, {0, 1, 0});
  LinePicture picture;
  add_house(picture, stages, aside * to_volume, true);
  add_volume(picture, volume, aside);
  add_axes(picture, aside, 0.4);
  if (is_perspective(volume)) picture.mark(picture_of(aside, {}));
  return picture;
}

} // namespace

Stages stages_of(const PhigsView& view) {
  Stages stages{view, canonical_volume(view), view_orientation(view.vrp_m, view.vpn, view.vup),
                view_mapping(view), Eigen::Matrix4d::Identity()};
  if (is_perspective(stages.volume))
    stages.to_parallel = perspective_transformation(stages.volume.z_min);
  return stages;
}

LinePicture world_picture(const Stages& stages, const Eigen::Matrix4d& aside) {
  const PhigsView& view = stages.view;
  const Eigen::Matrix4d from_uvn = aside * stages.orientation.inverse();
  const Eigen::Matrix4d from_canonical = from_uvn * stages.mapping.inverse();
  LinePicture picture;
  add_house(picture, stages, from_canonical, true);
  add_volume(picture, stages.volume, from_canonical);

  const Vec2 centre = view.window_m.centre();
  const Vec2 half{view.window_m.width() / 2, view.window_m.height() / 2};
  const auto on_window = [&](Vec2 direction) {
    return Vec3{centre.x + direction.x * half.x, centre.y + direction.y * half.y, 0};
  };
  for (std::size_t i = 0; i < 4; ++i)
    picture.add(from_uvn, on_window(kAround[i]), on_window(kAround[(i + 1) % 4]), LineOf::window);
  add_axes(picture, from_uvn, 3.5);
  picture.mark(picture_of(from_uvn, view.prp_m));
  if (!is_perspective(stages.volume))
    picture.add(from_uvn, view.prp_m, on_window({0, 0}), LineOf::ray, true);
  return picture;
}

LinePicture canonical_picture(const Stages& stages) {
  return volume_picture(stages, stages.volume, Eigen::Matrix4d::Identity());
}

LinePicture straight_picture(const Stages& stages) {
  return volume_picture(stages, kParallelVolume, stages.to_parallel);
}

LinePicture page_picture(const Stages& stages) {
  const double width = stages.view.window_m.width(), height = stages.view.window_m.height();
  // A picture plane has y up, a page down.
  Eigen::Matrix4d upright = Eigen::Matrix4d::Identity();
  upright(1, 1) = -1;
  const Eigen::Matrix4d to_page =
      workstation_transformation(kWholeWindow, {{0, 0}, {width, height}});
  LinePicture picture;
  add_house(picture, stages, upright * to_page * stages.to_parallel, false);
  const std::array<Vec2, 4> frame{{{0, 0}, {width, 0}, {width, -height}, {0, -height}}};
  for (std::size_t i = 0; i < 4; ++i) picture.add({frame[i], frame[(i + 1) % 4], LineOf::volume});
  return picture;
}

} // namespace orograph
