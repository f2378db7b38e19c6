// SPDX-License-Identifier: GPL-3.0-or-later
// A batch goes through three steps: cut and projected (by profile), clipped (by strip), laid out
// (by profile). Three batches are in work at once, one in each step, so that there are always tasks
// of several kinds for the threads.
#include "cli/sweep_strips.hpp"

#include "cli/stopwatch.hpp"
#include "cli/strips.hpp"
#include "geometry/on_all_cores.hpp"
#include "horizon/horizon_pieces.hpp"
#include "horizon/upright.hpp"
#include "profiles/project_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

namespace orograph {
namespace {

// A batch is small, so that it stays in the cache: some 40 bytes a vertex. But as long as it is in
// work, each of its profiles is a task of its own, and the threads wait for each other behind it.
constexpr double kVerticesABatch = 32768;
constexpr double kLeastProfiles = 8, kMostProfiles = 256;

// What is that close in X to a profile's way along a wall counts as being at it.
double beside_wall(double x, const View& view, double depth_m, double rounding_m) {
  return view.is_perspective() ? rounding_m * (1 + std::abs(x)) / depth_m : rounding_m;
}

// One strip, front to back.
class StripSweep {
public:
  StripSweep(const SectorInWork& work, const Strip& strip, std::vector<std::uint32_t> which)
      : work_(work), strip_(strip),
        lines_(work.terrain.surface, work.sector, work.lines, std::move(which), strip.range,
               work.from_m, work.tolerance),
        horizon_(strip.core.begin, strip.core.end, strip.blocks, lines_.looked_at().begin,
                 lines_.looked_at().end),
        plane_m_(std::max(work.sector.nearest_m, work.from_m)) {
    thickness_m_ = slab_thickness_m(work, plane_m_);
  }

  void raise(const std::vector<Segment>& segments) {
    for (const Segment& s : segments)
      if (s.x0 <= strip_.range.end && s.x1 >= strip_.range.begin)
        horizon_.raise({s.x0, s.x1, s, false});
  }

  void take(ProfileInWork& profile, std::vector<VisibleRun>& visible) {
    Stopwatch watch;
    const double depth_m = profile.planned.depth_m;
    take_slabs(depth_m);
    visible.clear();
    clip_profile(profile.projected, strip_.range, horizon_, work_.tolerance, visible, counts_);
    for (const Segment& upright : profile.uprights) {
      if (upright.x0 < strip_.range.begin || upright.x0 >= strip_.range.end) continue;
      const double beside =
          beside_wall(upright.x0, work_.sector.view, depth_m, lines_.rounding_m());
      for (const Piece& piece : visible_uprights(std::span(&upright, 1), horizon_, beside))
        visible.push_back({left_vertex(upright), left_vertex(upright), piece.t_begin, piece.t_end});
    }
    watch.mark(seconds_);
  }

  void finish() {
    Stopwatch watch;
    if (plane_m_ < work_.sector.farthest_m) take_slabs(work_.sector.farthest_m);
    take_slab(std::numeric_limits<double>::infinity());
    watch.mark(seconds_);
  }

  const LineSweep& lines() const { return lines_; }
  const BlockedHorizon& horizon() const { return horizon_; }
  const ProfileClipCounts& counts() const { return counts_; }
  double seconds() const { return seconds_; }

private:
  void take_slabs(double to_m) {
    const double count = std::ceil((to_m - plane_m_) / thickness_m_);
    for (int i = 1; i < count; ++i) take_slab(plane_m_ + (to_m - plane_m_) * (i / count));
    take_slab(to_m);
    plane_m_ = to_m;
  }
  void take_slab(double to_m) {
    lines_.take_slab(to_m, horizon_,
                     [](std::vector<HorizonPiece>& occluders, BlockedHorizon& horizon) {
                       // Of equally high ones the first stands, as in `orograph::raise`.
                       std::sort(occluders.begin(), occluders.end(), is_raised_before);
                       for (const HorizonPiece& occluder : occluders) horizon.raise(occluder);
                     });
  }

  const SectorInWork& work_;
  Strip strip_;
  LineSweep lines_;
  BlockedHorizon horizon_;
  double plane_m_, thickness_m_ = 0;
  ProfileClipCounts counts_;
  double seconds_ = 0;
};

struct ProfileSeconds {
  double cut = 0, project = 0, layout = 0;
};

std::size_t batch_size(const Scene& scene, const Sector& sector) {
  const auto& box = scene.extent.box;
  const double across_m = std::hypot(box.high.x - box.low.x, box.high.y - box.low.y);
  const double vertices = 2 * across_m / scene.cell_m + 1;
  const double count = std::clamp(kVerticesABatch / vertices, kLeastProfiles, kMostProfiles);
  return std::max<std::size_t>(1,
                               std::min(static_cast<std::size_t>(count), sector.profiles.size()));
}

// What is on the page of a profile's u.
URange u_range(const View& view, XRange range, double depth_m) {
  if (view.is_perspective()) return {range.begin * depth_m, range.end * depth_m};
  return {range.begin - depth_m * view.x_per_v, range.end - depth_m * view.x_per_v};
}

// Where the near plane cuts the terrain, a section begins: the cut hides.
std::vector<Segment> near_cut(const SectorInWork& work) {
  std::vector<Segment> segments, uprights;
  if (!work.sector.view.is_perspective()) return segments;
  Profile cut;
  work.cutter.cut(work.sector.view.near_m, {}, cut);
  project_profile(cut, work.near_cut, work.sector.view, segments, uprights);
  return segments;
}

} // namespace

double slab_thickness_m(const SectorInWork& work, double nearest_m) {
  constexpr double kMostSlabs = 1e5;
  return std::max(work.scene.cell_m, (work.sector.farthest_m - nearest_m) / kMostSlabs);
}

SweptSector sweep_strips(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                         CountsReport& counts, SecondsReport& seconds) {
  Stopwatch watch;
  const Sector& sector = work.sector;
  const std::vector<Strip> plan =
      plan_strips(work.scene, sector, work.range, work.vertices_a_strip);
  std::vector<XRange> ranges;
  for (const Strip& strip : plan) ranges.push_back(strip.range);
  auto which = lines_by_range(work.terrain.surface, sector, work.lines, ranges, work.from_m);
  std::vector<std::unique_ptr<StripSweep>> strips(plan.size());
  const std::vector<Segment> cut = near_cut(work);
  on_all_cores(plan.size(), [&](std::size_t i) {
    strips[i] = std::make_unique<StripSweep>(work, plan[i], std::move(which[i]));
    strips[i]->raise(cut);
  });
  watch.mark(seconds.facing);

  const std::size_t size = batch_size(work.scene, sector);
  const std::size_t profile_count = sector.profiles.size();
  const std::size_t batch_count = (profile_count + size - 1) / size;
  struct Timed {
    ProfileInWork work;
    ProfileSeconds seconds;
  };
  std::array<std::vector<Timed>, 3> batches;
  for (auto& batch : batches) batch.resize(size);
  const auto in_batch = [&](std::size_t batch) {
    return batch < batch_count ? std::min(size, profile_count - batch * size) : 0;
  };
  const auto cut_one = [&](Timed& timed, std::size_t number) {
    Stopwatch own;
    ProfileInWork& profile = timed.work;
    profile.planned = sector.profiles[number];
    profile.by_strip.resize(plan.size());
    profile.horizon_sizes.resize(plan.size());
    const double depth_m = profile.planned.depth_m;
    const URange range = work.whole_profiles ? URange{} : u_range(sector.view, work.range, depth_m);
    work.cutter.cut(depth_m, range, profile.profile);
    own.mark(timed.seconds.cut);
    project_profile(profile.profile, static_cast<std::uint32_t>(profile.planned.number),
                    sector.view, profile.projected, profile.uprights);
    own.mark(timed.seconds.project);
  };
  const auto clip_batch = [&](std::vector<Timed>& batch, std::size_t count, std::size_t strip) {
    for (std::size_t i = 0; i < count; ++i) {
      ProfileInWork& profile = batch[i].work;
      strips[strip]->take(profile, profile.by_strip[strip]);
      profile.horizon_sizes[strip] = strips[strip]->horizon().size();
    }
  };
  const auto lay_out_one = [&](Timed& timed) {
    Stopwatch own;
    join_strips(timed.work);
    lay_out(timed.work);
    own.mark(timed.seconds.layout);
  };
  for (std::size_t round = 0; round < batch_count + 2; ++round) {
    auto &cutting = batches[round % 3], &clipping = batches[(round + 2) % 3],
         &laying = batches[(round + 1) % 3];
    const std::size_t to_cut = in_batch(round), to_clip = round >= 1 ? in_batch(round - 1) : 0,
                      to_lay = round >= 2 ? in_batch(round - 2) : 0;
    const std::size_t strip_tasks = to_clip > 0 ? strips.size() : 0;
    on_all_cores(strip_tasks + to_cut + to_lay, [&](std::size_t task) {
      if (task < strip_tasks)
        clip_batch(clipping, to_clip, task);
      else if (task < strip_tasks + to_cut)
        cut_one(cutting[task - strip_tasks], round * size + task - strip_tasks);
      else
        lay_out_one(laying[task - strip_tasks - to_cut]);
    });
    for (std::size_t i = 0; i < to_lay; ++i) {
      counts.cut_vertices += laying[i].work.profile.size();
      const auto& sizes = laying[i].work.horizon_sizes;
      counts.largest_horizon = std::max(
          counts.largest_horizon, std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0}));
      for (const VertexRun& run : laying[i].work.projected.runs)
        counts.segments += run.last - run.first;
      show(laying[i].work);
    }
  }
  watch = {};
  on_all_cores(strips.size(), [&](std::size_t i) { strips[i]->finish(); });
  for (const auto& batch : batches)
    for (const Timed& timed : batch) {
      seconds.cut += timed.seconds.cut;
      seconds.project += timed.seconds.project;
      seconds.layout += timed.seconds.layout;
    }

  SweptSector out;
  for (const auto& strip : strips) {
    const auto& parts = strip->lines().visible_parts();
    out.visible.insert(out.visible.end(), parts.begin(), parts.end());
    const std::vector<LinePart> skyline = strip->lines().skyline(strip->horizon().joined());
    out.skyline.insert(out.skyline.end(), skyline.begin(), skyline.end());
    counts.ties += strip->counts().ties;
    counts.pieces_before_collapse += strip->horizon().pieces_uncollapsed();
    counts.pieces_after_collapse += strip->horizon().pieces_collapsed();
    seconds.clip += strip->seconds();
  }
  watch = {};
  join(out.visible);
  join(out.skyline);
  out.skyline = shared(out.skyline, out.visible);
  watch.mark(seconds.layout);
  return out;
}

} // namespace orograph
