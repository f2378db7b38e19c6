// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/pipeline.hpp"

#include "geometry/error.hpp"
#include "view/finite.hpp"
#include "view/model_transform.hpp"
#include "view/view_mapping.hpp"
#include "view/view_orientation.hpp"

namespace orograph {
namespace {

void require_rectangle(const Box2& box, const std::string& what) {
  require_finite(box.low, what);
  require_finite(box.high, what);
  if (!(box.width() > 0 && box.height() > 0))
    throw Error(what + " is empty", "its width and height should be greater than 0");
}

} // namespace

Eigen::Matrix4d workstation_transformation(const Box2& window, const Box2& viewport_mm) {
  require_rectangle(window, "the window on the canonical volume");
  require_rectangle(viewport_mm, "the viewport");
  return translation({viewport_mm.low.x, viewport_mm.high.y, 0}) *
         scaling(
             {viewport_mm.width() / window.width(), -viewport_mm.height() / window.height(), 1}) *
         translation({-window.low.x, -window.low.y, 0});
}

Eigen::Matrix4d compose(const Eigen::Matrix4d& model, const PhigsView& view,
                        const Box2& viewport_mm) {
  require_model(model);
  const Eigen::Matrix4d orientation = view_orientation(view.vrp_m, view.vpn, view.vup);
  const Eigen::Matrix4d mapping = view_mapping(view);
  const CanonicalVolume volume = canonical_volume(view);
  const Eigen::Matrix4d to_parallel = volume.projection == PhigsProjection::perspective
                                          ? perspective_transformation(volume.z_min)
                                          : Eigen::Matrix4d::Identity();
  const Eigen::Matrix4d to_page = workstation_transformation(kWholeWindow, viewport_mm);

  const Eigen::Matrix4d all = to_page * to_parallel * mapping * orientation * model;
  if (!all.allFinite())
    throw Error("the view's numbers are too large or too small beside each other",
                "give window, planes and eye in metres of the scene");
  return all;
}

} // namespace orograph
