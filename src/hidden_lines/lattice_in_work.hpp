// SPDX-License-Identifier: GPL-3.0-or-later
// A sector of a grid, and the order of its lattice.
#pragma once

#include "hidden_lines/line_pictures.hpp"
#include "hidden_lines/sector_in_work.hpp"
#include "profiles/lattice_order.hpp"

#include <cstdint>
#include <vector>

namespace orograph {

/// A lattice's strips of cells, and the cells of a strip, as coordinates of the profile frame: at
/// (u, v) a strip's number and the share of it, `at_origin + per_u * u + per_v * v`.
struct AcrossLattice {
  double at_origin, per_u, per_v;
  double at(double u, double v) const { return at_origin + per_u * u + per_v * v; }
};

/// The lattice of a grid as a sector's view sees it.
struct SectorLattice {
  const Grid& grid;
  const View& view;
  LatticeOrder order;
  AcrossLattice strip{}, cell{}; ///< by the order's strips; on a map plane
  double rounding = 0;           ///< of both

  /// `strips`: on the earth. REQUIRES that all outlive this.
  SectorLattice(const Grid& grid, const View& view, const EarthStrips* strips);

  /// The places that hold something of the profile at a depth, as far as it is shown, and perhaps
  /// some beside them.
  LatticeOrder::Places places_of(double depth_m, const URange& shown) const;

private:
  // On the earth.
  void find_depths_by_place();
  LatticeOrder::Places places_of_depth(double depth_m) const;

  // Of all strips up to a place, and from it on; both rise with places.
  std::vector<double> farthest_up_to_m_, nearest_from_m_;
};

/// The same of a sector in work.
struct LatticeInWork : SectorLattice {
  const SectorInWork& work;

  /// REQUIRES that `work` outlives this.
  explicit LatticeInWork(const SectorInWork& in_work);

  /// Of a line of the sector.
  LatticeOrder::Turn turn_of(const LinePictures& pictures, std::uint32_t line) const;
};

} // namespace orograph
