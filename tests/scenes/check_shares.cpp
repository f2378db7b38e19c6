// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/check_shares.hpp"

#include "reference/sight_segment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orograph {
namespace {

enum class Truth { visible, hidden, unsure };
enum class Facing { light, dark, unsure };

bool in_order(const std::vector<LineShare>& shares) {
  double last = 0;
  for (const LineShare& share : shares) {
    if (!(share.begin >= last && share.end > share.begin && share.end <= 1)) return false;
    last = share.end;
  }
  return true;
}

bool is_in(const std::vector<LineShare>& shares, double t) {
  return std::any_of(shares.begin(), shares.end(),
                     [&](const LineShare& share) { return share.begin <= t && t <= share.end; });
}

// None at an end of a share.
std::vector<double> places_to_ask(const std::vector<LineShare>& shares, Random& random,
                                  const ShareCheck& check) {
  std::vector<double> places;
  for (int i = 0; i < check.anywhere; ++i) places.push_back(random.share());
  double last = 0;
  for (const LineShare& share : shares) {
    for (const double end : {share.begin, share.end})
      for (const double by : {-check.near_end, check.near_end}) places.push_back(end + by);
    places.push_back(0.5 * (last + share.begin));
    places.push_back(0.5 * (share.begin + share.end));
    last = share.end;
  }
  places.push_back(0.5 * (last + 1));
  std::erase_if(places, [&](double t) {
    return !(t > 0 && t < 1) || std::any_of(shares.begin(), shares.end(), [&](LineShare share) {
      return t == share.begin || t == share.end;
    });
  });
  return places;
}

struct Line {
  ProfilePoint from, to;
  std::string name;
};

// `drawn`: the shares that are.
template <class TruthAt>
ShareTally check_line(const Line& line, const std::vector<LineShare>& shares, bool shares_are_drawn,
                      Random& random, const ShareCheck& check, const TruthAt& truth_at) {
  const auto beside = [&](ProfilePoint p) { // a range is only that of a perspective view
    return std::isfinite(check.x.begin) && !(p.u > check.x.begin * p.v && p.u < check.x.end * p.v);
  };
  ShareTally tally;
  tally.lines = 1;
  tally.shares = shares.size();
  const auto wrong = [&](std::uint64_t& count, const std::string& what) {
    ++count;
    if (tally.first_wrong.empty()) tally.first_wrong = line.name + ": " + what;
  };
  if (!in_order(shares)) wrong(tally.disordered, "its shares aren't in order and apart");
  for (const double t : places_to_ask(shares, random, check)) {
    const ProfilePoint p = point_between(line.from, line.to, t);
    if (p.v < check.nearest_m || beside(p)) continue;
    const Truth truth = truth_at(p);
    ++tally.asked;
    tally.unsure += truth == Truth::unsure;
    tally.visible += truth == Truth::visible;
    const bool drawn = is_in(shares, t) == shares_are_drawn;
    if (truth == Truth::hidden && drawn)
      wrong(tally.drawn_but_hidden, fmt::format("drawn but hidden at {:.17g}", t));
    if (truth == Truth::visible && !drawn)
      wrong(tally.missing, fmt::format("missing at {:.17g}", t));
  }
  return tally;
}

// By the side of the triangle's plane on which the eye is.
struct Facings {
  const View& view;
  const StandingSolid& standing;
  std::vector<LongVec> places;
  double slack_m;

  Facing of(std::uint32_t triangle) const {
    const auto& [a, b, c] = standing.solid->triangles[triangle];
    const LongVec normal = cross(places[b] - places[a], places[c] - places[a]);
    const long double size = std::max({length(places[b] - places[a]), length(places[c] - places[b]),
                                       length(places[a] - places[c])});
    LongVec to_eye{static_cast<long double>(view.x_per_v) * view.y_per_z, -view.y_per_z,
                   view.y_per_v};
    if (view.is_perspective()) to_eye = LongVec{0, 0, view.eye_z_m} - places[a];
    const long double towards = dot(normal, to_eye) / (length(normal) * length(to_eye));
    // What turns it where a corner moves by the slack, and what moving it does.
    const long double turned = 2 * slack_m * size / length(normal);
    const long double moved = view.is_perspective() ? 2 * slack_m / length(to_eye) : 0;
    if (std::abs(towards) <= turned + moved) return Facing::unsure;
    return (towards > 0) != standing.mirrored ? Facing::light : Facing::dark;
  }
};

Truth truth_of(const SolidEdge& edge, const Facings& facings, const Sight::Answer& answer) {
  const Truth seen = answer.unsure     ? Truth::unsure
                     : answer.hidden() ? Truth::hidden
                                       : Truth::visible;
  if (edge.is_wire() || seen == Truth::hidden) return seen;
  const Facing left = facings.of(edge.left), right = facings.of(edge.right);
  if (left == Facing::unsure || right == Facing::unsure) return Truth::unsure;
  if (left == Facing::dark && right == Facing::dark) return Truth::hidden;
  if (edge.smooth && left == right) return Truth::hidden; // not drawn
  return seen;
}

} // namespace

void ShareTally::add(const ShareTally& more) {
  lines += more.lines;
  shares += more.shares;
  asked += more.asked;
  unsure += more.unsure;
  visible += more.visible;
  drawn_but_hidden += more.drawn_but_hidden;
  missing += more.missing;
  disordered += more.disordered;
  if (first_wrong.empty()) first_wrong = more.first_wrong;
}

ShareCheck share_check(const View& view, std::span<const StandingSolid> solids) {
  double reach_m = std::max(length(view.depth_origin_m), std::abs(view.eye_z_m));
  for (const StandingSolid& standing : solids)
    for (const Vec3& vertex : standing.vertices_m) reach_m = std::max(reach_m, length(vertex));
  ShareCheck check;
  check.slack_m = 1e-10 * reach_m;
  check.nearest_m = view.is_perspective() ? view.near_m : -std::numeric_limits<double>::infinity();
  return check;
}

ShareTally check_edges(const Sight& sight, const View& view, std::span<const StandingSolid> solids,
                       const VisibleShares& visible_shares, Random& random,
                       const ShareCheck& check) {
  ShareTally tally;
  for (std::size_t s = 0; s < solids.size(); ++s) {
    std::vector<ProfilePoint> vertices;
    Facings facings{view, solids[s], {}, check.slack_m};
    for (const Vec3& vertex : solids[s].vertices_m)
      facings.places.push_back(long_vec(vertices.emplace_back(to_profile_frame(view, vertex))));
    const std::vector<SolidEdge>& edges = solids[s].solid->edges;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const Line line{vertices[edges[e].from], vertices[edges[e].to],
                      fmt::format("solid {}, edge {}", s, e)};
      const Own own{edges[e].is_wire() ? Own::Which::none : Own::Which::edge, s, e};
      tally.add(check_line(line, visible_shares(s, e), true, random, check, [&](ProfilePoint p) {
        return truth_of(edges[e], facings, sight.ask(p, check.slack_m, own));
      }));
    }
  }
  return tally;
}

ShareTally check_ground_line(const Sight& sight, ProfilePoint from, ProfilePoint to,
                             const SharesBySolids& hidden_shares, Random& random,
                             const ShareCheck& check) {
  const Line line{from, to,
                  fmt::format("from ({:.17g}, {:.17g}, {:.17g}) to ({:.17g}, {:.17g}, {:.17g})",
                              from.u, from.v, from.z, to.u, to.v, to.z)};
  return check_line(line, hidden_shares(from, to), false, random, check, [&](ProfilePoint p) {
    const SightAnswer verdict = sight.by_solids(p, check.slack_m, {Own::Which::none});
    return verdict.unsure ? Truth::unsure : verdict.hidden ? Truth::hidden : Truth::visible;
  });
}

} // namespace orograph
