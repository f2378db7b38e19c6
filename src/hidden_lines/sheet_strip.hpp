// SPDX-License-Identifier: GPL-3.0-or-later
// The pass through one strip of X where the surface is a sheet with two sides
// (docs/decisions/0054-both-sides.md).
#pragma once

#include "hidden_lines/block_feet.hpp"
#include "hidden_lines/line_pictures.hpp"
#include "hidden_lines/sector_in_work.hpp"
#include "hidden_lines/strips.hpp"
#include "horizon/covered.hpp"
#include "profiles/sheet.hpp"
#include "profiles/sheet_order.hpp"
#include "profiles/sheet_part.hpp"
#include "profiles/sheet_vertices.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace orograph {

/// A sheet as a sector sees it.
struct SheetInWork {
  const SectorInWork& work;
  const Sheet& sheet;
  SheetPart all;
  const SheetPart& part;  ///< that the sector looks at
  SheetVertices vertices; ///< in the sector's profile frame
  SheetOrder order;
  std::optional<BlockFeet> feet; ///< of a block that is closed below

  explicit SheetInWork(const SectorInWork& of);
  /// Whether a triangle is there, and is in front of something or behind it: a wall that is seen
  /// edge-on is neither, and has any place in the order.
  bool has_place(std::uint32_t triangle) const;
};

/// When something has its turn: what has the lesser one comes first.
using SheetTurn = std::uint64_t;

/// Within the turn of a triangle: lines along edges at which the sheet begins, these edges, what is
/// in the triangle, the edges on its farther side, and a block's foot below one of those. What
/// hides does so when all that lies on it has been asked.
enum class SheetStep : std::uint8_t { on_rim = 0, rim = 1, inside = 2, behind = 3, foot = 4 };
inline SheetTurn turn_of(std::uint64_t place, SheetStep step, bool hides = false) {
  return place << 4U | static_cast<SheetTurn>(step) << 1U | (hides ? 1U : 0U);
}
/// Whether there is a triangle in front.
inline bool has_front(SheetTurn turn) {
  return (turn >> 1U & 7U) != static_cast<SheetTurn>(SheetStep::on_rim);
}

/// A span of a profile, in the triangle that it lies in.
struct SheetSpan {
  SheetTurn turn : 61 = 0;
  bool is_there : 1 = false, is_up : 1 = false;
  bool takes_left : 1 = false; ///< up a wall: which is on the left of it, seen from the eye
};

/// A profile with its spans, by left vertex.
struct SheetProfile {
  ProfileInWork* profile; ///< gets what is seen of it, by strip
  std::vector<SheetSpan> spans;
};

/// Takes all that a strip holds in the order of its turns.
class SheetStrip {
public:
  /// Number `number` of the sector's strips. REQUIRES that all outlive it.
  SheetStrip(const SheetInWork& sheet, std::size_t number, const Strip& strip);

  /// `which`: the lines that reach into the strip; `near_cut` stands in front of everything.
  void run(std::span<const LineAtDepth> which, std::span<const Segment> near_cut,
           std::span<const SheetProfile> profiles);

  const std::vector<LinePart>& visible_parts() const { return parts_; }
  const LinePictures& pictures() const { return pictures_; }
  Horizon top() const { return covered_.top(); }

private:
  struct Event {
    SheetTurn turn : 60;
    SheetEnd end : 2; ///< of lines that hide
    bool is_asked : 1, takes_left : 1;
    std::uint32_t number; ///< of the line, or the profile
    std::uint32_t span;   ///< of a profile, by its left vertex; of lines one of the two
  };
  /// Of a line itself, and of a block's foot below it.
  static constexpr std::uint32_t kLine = 0xffffffff, kFoot = 0xfffffffe;

  ProfileLine whole(std::uint32_t number) const;
  void add_line(std::uint32_t number);
  void add_ground_line(std::uint32_t number);
  void add_wall_line(std::uint32_t number);
  std::optional<SurfaceEdge> edge_under(const ProfileLine& line, std::uint32_t triangle) const;
  bool may_be_upright(const ProfileLine& line) const;
  bool reaches_left(std::uint32_t triangle, SurfaceEdge edge) const;
  void add_upright_of_border(std::uint32_t number, SurfaceEdge edge, std::uint32_t wall);
  void add_edge(std::uint32_t number, SurfaceEdge edge);
  void add_spans(std::uint32_t number, const SheetProfile& profile);
  void take_line(const Event& event);
  void take_foot(const Event& event);
  void take_span(const Event& event, const SheetProfile& profile);

  const SheetInWork& sheet_;
  std::size_t number_;
  XRange range_;
  LinePictures pictures_;
  Covered covered_;
  std::vector<Event>* events_ = nullptr; ///< while it runs
  std::vector<LinePart> parts_;
  std::vector<Shares> seen_; ///< scratch
};

} // namespace orograph
