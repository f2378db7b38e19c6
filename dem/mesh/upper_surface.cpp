// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/mesh/upper_surface.hpp"

#include "dem/mesh/walls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orograph {
namespace {

struct OverlappingPair {
  TrianglePair triangles;
  CommonGround ground;

  /// Which of the two is over the other throughout, 0 or 1; 2 where they pierce each other. At one
  /// height it is the one of lower number.
  int upper() const {
    if (ground.least_m >= 0) return 0;
    return ground.greatest_m <= 0 ? 1 : 2;
  }
};

double heights_tolerance_m(const Tin& tin) {
  double largest = 0;
  for (const Vec3& p : tin.vertices_m)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return 0x1p-40 * largest;
}

std::vector<OverlappingPair> overlapping_pairs(const Tin& tin, double tolerance_m) {
  std::vector<OverlappingPair> pairs;
  for (const TrianglePair& pair : all_overlaps(tin))
    pairs.push_back({pair, common_ground(tin, pair[0], pair[1], tolerance_m)});
  return pairs;
}

// A sum whose error doesn't grow with the number of terms (Kahan 1965).
struct KahanSum {
  double value = 0, lost = 0;
  void add(double term) {
    const double whole = term - lost, next = value + whole;
    lost = (next - value) - whole;
    value = next;
  }
};

// Triangles that nothing is over.
std::vector<bool> over_all(const Tin& tin, const std::vector<OverlappingPair>& pairs) {
  std::vector<bool> over(tin.triangles.size(), true);
  for (const OverlappingPair& pair : pairs)
    for (const int i : {0, 1})
      if (pair.upper() != i) over[pair.triangles[i]] = false;
  return over;
}

// Triangles that are under others all over, told from areas: those that nothing is over don't
// overlap each other, so what they have in common with one below adds up.
std::vector<bool> wholly_hidden(const Tin& tin, const std::vector<OverlappingPair>& pairs) {
  const std::vector<bool> over = over_all(tin, pairs);
  std::vector<KahanSum> covered(tin.triangles.size());
  for (const OverlappingPair& pair : pairs)
    for (const int i : {0, 1})
      if (over[pair.triangles[i]]) covered[pair.triangles[1 - i]].add(pair.ground.area_m2);
  std::vector<bool> hidden(tin.triangles.size(), false);
  for (std::uint32_t t = 0; t < hidden.size(); ++t)
    hidden[t] = covered[t].value > 0 && covered[t].value >= (1 - 1e-11) * area_m2(tin, t);
  return hidden;
}

// Triangles that have to be cut, or that others are cut along: those that overlap, but none amid
// others that nothing is over.
std::vector<bool> to_arrange(const Tin& tin, const std::vector<OverlappingPair>& pairs,
                             const std::vector<bool>& hidden) {
  const std::vector<bool> over = over_all(tin, pairs);
  const auto beside = find_neighbours(tin.triangles, tin.vertices_m.size()).of;
  std::vector<bool> chosen(tin.triangles.size(), false);
  for (const OverlappingPair& pair : pairs)
    for (const std::uint32_t t : pair.triangles)
      chosen[t] = !over[t] || !std::all_of(beside[t].begin(), beside[t].end(), [&](auto other) {
        return other != kNoTriangle && over[other] && !hidden[other] && !is_wall(tin, other);
      });
  return chosen;
}

std::vector<HadBeside> what_is_beside(const Tin& tin) {
  const Neighbours neighbours = find_neighbours(tin.triangles, tin.vertices_m.size());
  std::vector<HadBeside> had;
  for (const auto& of : neighbours.of)
    had.push_back({of[0] != kNoTriangle, of[1] != kNoTriangle, of[2] != kNoTriangle});
  for (const auto& crowd : neighbours.crowded)
    for (const TriangleSide& side : crowd) had[side.triangle][side.side] = true;
  return had;
}

// Triangles other than walls in their own places, the chosen ones by their pieces; each one's
// number in the soup beside it.
struct Assembled {
  Tin tin;
  std::vector<std::uint32_t> of;
};

Assembled assemble(const Tin& soup, const std::vector<bool>& hidden,
                   const std::vector<bool>& chosen, const UpperPieces& upper, bool with_walls) {
  Assembled assembled;
  assembled.tin.vertices_m = upper.vertices_m;
  const auto add = [&](std::uint32_t of, const std::array<std::uint32_t, 3>& triangle) {
    assembled.tin.triangles.push_back(triangle);
    assembled.of.push_back(of);
  };
  auto piece = upper.pieces.begin();
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    for (; piece != upper.pieces.end() && piece->of == t; ++piece) add(t, piece->triangle);
    if (!hidden[t] && !chosen[t] && (with_walls || !is_wall(soup, t))) add(t, soup.triangles[t]);
  }
  assembled.tin.neighbours =
      find_neighbours(assembled.tin.triangles, assembled.tin.vertices_m.size()).of;
  return assembled;
}

// Chooses triangles with one of the edges; true if there are more than before.
bool choose_beside(const Tin& soup, const std::vector<PlanEdge>& edges,
                   const std::vector<bool>& hidden, std::vector<bool>& chosen) {
  bool more = false;
  for (std::uint32_t t = 0; t < soup.triangles.size() && !edges.empty(); ++t) {
    if (chosen[t] || hidden[t]) continue;
    const std::array<std::uint32_t, 1> one{t};
    for (const PlanEdge& edge : edges_of(soup, one))
      if (std::binary_search(edges.begin(), edges.end(), edge) && !is_wall(soup, t))
        more = chosen[t] = true;
  }
  return more;
}

// Where bent lines went over triangles that nobody chose: chooses those. True if there are any.
bool choose_overlapped(const Assembled& assembled, std::vector<bool>& chosen) {
  if (!first_overlap(assembled.tin)) return false;
  bool more = false;
  for (const TrianglePair& pair : all_overlaps(assembled.tin))
    for (const std::uint32_t t : pair)
      if (!chosen[assembled.of[t]]) more = chosen[assembled.of[t]] = true;
  return more;
}

std::vector<std::uint32_t> numbers_of(const std::vector<bool>& chosen) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t t = 0; t < chosen.size(); ++t)
    if (chosen[t]) numbers.push_back(t);
  return numbers;
}

void count_pieces(const Tin& soup, const std::vector<bool>& hidden, const std::vector<bool>& chosen,
                  const UpperPieces& upper, UpperSurface& surface) {
  std::vector<bool> seen(soup.triangles.size(), false), cut = seen;
  for (const UpperPiece& piece : upper.pieces) {
    seen[piece.of] = true;
    if (piece.triangle != soup.triangles[piece.of]) cut[piece.of] = true;
  }
  for (std::size_t t = 0; t < seen.size(); ++t) {
    surface.hidden += hidden[t] || (chosen[t] && !seen[t]) ? 1 : 0;
    surface.cut += cut[t] ? 1 : 0;
  }
}

} // namespace

UpperSurface upper_surface(const Tin& soup) {
  const double tolerance_m = heights_tolerance_m(soup);
  std::vector<OverlappingPair> pairs = overlapping_pairs(soup, tolerance_m);
  const std::vector<bool> hidden = wholly_hidden(soup, pairs);
  std::erase_if(pairs, [&](const OverlappingPair& pair) {
    return hidden[pair.triangles[0]] || hidden[pair.triangles[1]];
  });

  std::vector<CommonGround> grounds;
  std::vector<bool> overlapping(soup.triangles.size(), false);
  for (const OverlappingPair& pair : pairs) {
    if (pair.upper() == 2) grounds.push_back(pair.ground);
    for (const std::uint32_t t : pair.triangles) overlapping[t] = true;
  }
  std::vector<bool> chosen = to_arrange(soup, pairs, hidden);
  choose_beside(soup, edges_of(soup, numbers_of(chosen)), hidden, chosen);

  UpperPieces upper{soup.vertices_m, {}, {}};
  for (bool more = !pairs.empty(); more;) {
    std::vector<bool> whole(chosen.size());
    for (std::size_t t = 0; t < whole.size(); ++t) whole[t] = overlapping[t] && !chosen[t];
    upper = cut_to_upper(soup, numbers_of(chosen), numbers_of(whole), grounds, tolerance_m);
    more = choose_beside(soup, upper.split, hidden, chosen) ||
           choose_overlapped(assemble(soup, hidden, chosen, upper, false), chosen);
  }

  UpperSurface surface;
  count_pieces(soup, hidden, chosen, upper, surface);
  Assembled assembled = assemble(soup, hidden, chosen, upper, true);
  const std::vector<HadBeside> had_beside = what_is_beside(soup);
  std::vector<HadBeside> had;
  for (const std::uint32_t t : assembled.of) had.push_back(had_beside[t]);
  surface.tin = std::move(assembled.tin);
  surface.dropped_walls = keep_standing_walls(surface.tin, std::move(had));
  return surface;
}

} // namespace orograph
