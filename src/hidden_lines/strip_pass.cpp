// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/strip_pass.hpp"

#include "geometry/on_all_cores.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/profile_stages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace orograph {
StripPass::StripPass(const SectorInWork& work, const Strip& strip,
                     std::span<const LineAtDepth> which, std::span<const Segment> near_cut)
    : work_(work), range_(strip.range),
      pictures_(work.terrain.surface, work.placed.reach_m, work.on_ground.points, work.sector,
                work.lines, strip.range, work.from_m, work.on_ground.overlays_are_lifted),
      lines_(pictures_, which, work.tolerance),
      horizon_(strip.core.begin, strip.core.end, strip.blocks, pictures_.looked_at().begin,
               pictures_.looked_at().end),
      planes_(work) {
  pictures_.set_seen_with(work.seen_with);
  for (const Segment& s : near_cut)
    if (s.x0 <= range_.end && s.x1 >= range_.begin) horizon_.raise({s.x0, s.x1, s, false});
}

void StripPass::take_lines(double to_m) {
  planes_.take_to(to_m, [&](double plane_m) { take_slab(plane_m); });
}

void StripPass::take_profile(const ProfileInWork& profile, std::vector<VisibleRun>& visible) {
  visible.clear();
  clip_profile(profile.projected, range_, horizon_, work_.tolerance, work_.draws_profiles, visible,
               counts_);
  add_visible_uprights(profile, work_.sector.view, range_, horizon_, pictures_.rounding_m(),
                       visible);
}

void StripPass::finish() {
  if (planes_.last_m() < work_.sector.farthest_m) take_lines(work_.sector.farthest_m);
  take_slab(std::numeric_limits<double>::infinity());
}

void StripPass::take_slab(double to_m) {
  throw_if_stopped();
  // Of equally high ones the first stands, as in `orograph::raise`.
  lines_.take_slab(to_m, horizon_,
                   [](std::span<const HorizonPiece> occluders, BlockedHorizon& horizon) {
                     for (const HorizonPiece& occluder : occluders) horizon.raise(occluder);
                   });
}

std::vector<std::unique_ptr<StripPass>> strips_of(const SectorInWork& work) {
  return strips_of<StripPass>(work, [&](std::size_t, const auto&... of_strip) {
    return std::make_unique<StripPass>(work, of_strip...);
  });
}

namespace {

// A batch is small, so that it stays in the cache: some 40 bytes a vertex. But as long as it is in
// work, each of its profiles is a task of its own, and the threads wait for each other behind it.
constexpr double kVerticesABatch = 32768;
constexpr double kLeastProfiles = 8, kMostProfiles = 256;

std::size_t batch_size(const PlacedView& placed, const Sector& sector) {
  const auto& box = placed.extent.box;
  const double across_m = std::hypot(box.high.x - box.low.x, box.high.y - box.low.y);
  const double vertices = 2 * across_m / placed.cell_m + 1;
  const double count = std::clamp(kVerticesABatch / vertices, kLeastProfiles, kMostProfiles);
  return std::max<std::size_t>(1,
                               std::min(static_cast<std::size_t>(count), sector.profiles.size()));
}

// All strips and profiles of a sector. A batch goes through four steps: cut and projected (by
// profile), clipped (by strip), laid out (by profile), shown in order. Four batches are in work at
// once, one in each step, so that there are always tasks of several kinds for the threads.
class StripsPass {
public:
  StripsPass(const SectorInWork& work, const LayOut& lay_out)
      : work_(work), size_(batch_size(work.placed, work.sector)), strips_(strips_of(work)),
        strip_seconds_(strips_.size()), stages_(work, lay_out, strips_.size()) {
    for (auto& batch : batches_) batch.resize(size_);
  }

  void run(const Show& show, Counts& counts) {
    const std::size_t batch_count = (work_.sector.profiles.size() + size_ - 1) / size_;
    for (std::size_t round = 0; round < batch_count + 3; ++round) {
      const auto batch = [&](std::size_t step) -> auto& {
        return batches_[(round + 4 - step) % 4];
      };
      const auto size = [&](std::size_t step) {
        return round >= step ? in_batch(round - step) : 0;
      };
      const std::size_t to_cut = size(0), to_clip = size(1), to_lay = size(2), to_show = size(3);
      // What has to be in order is one task, the first.
      const std::size_t first_cut = 1 + (to_clip > 0 ? strips_.size() : 0),
                        first_lay = first_cut + to_cut;
      on_all_cores(first_lay + to_lay, [&](std::size_t task) {
        if (task == 0)
          show_batch(batch(3), to_show, show, counts);
        else if (task < first_cut)
          clip(batch(1), to_clip, task - 1);
        else if (task < first_lay)
          stages_.cut(batch(0)[task - first_cut], round * size_ + task - first_cut);
        else
          stages_.lay_out(batch(2)[task - first_lay]);
      });
    }
    on_all_cores(strips_.size(), [&](std::size_t i) {
      Stopwatch watch;
      strips_[i]->finish();
      watch.mark(strip_seconds_[i]);
    });
  }

  SectorParts found() const { return parts_of(work_, strips_); }

  void add_to(Counts& counts, StageSeconds& seconds) const {
    add_counts(strips_, counts);
    for (const double strip_s : strip_seconds_) seconds.clip += strip_s;
    for (const auto& batch : batches_)
      for (const TimedProfile& timed : batch) timed.add_to(seconds);
  }

private:
  std::size_t in_batch(std::size_t batch) const {
    const std::size_t all = work_.sector.profiles.size();
    return batch * size_ < all ? std::min(size_, all - batch * size_) : 0;
  }

  static void show_batch(std::vector<TimedProfile>& batch, std::size_t size, const Show& show,
                         Counts& counts) {
    for (std::size_t i = 0; i < size; ++i) {
      count(batch[i].profile, counts);
      show(batch[i].profile);
    }
  }

  void clip(std::vector<TimedProfile>& batch, std::size_t count, std::size_t number) {
    Stopwatch watch;
    StripPass& strip = *strips_[number];
    for (std::size_t i = 0; i < count; ++i) {
      ProfileInWork& profile = batch[i].profile;
      strip.take_lines(profile.planned.depth_m);
      strip.take_profile(profile, profile.by_strip[number]);
      profile.horizon_sizes[number] = strip.horizon().size();
    }
    watch.mark(strip_seconds_[number]);
  }

  const SectorInWork& work_;
  std::size_t size_; ///< profiles in a batch
  std::vector<std::unique_ptr<StripPass>> strips_;
  std::vector<double> strip_seconds_;
  ProfileStages stages_;
  std::array<std::vector<TimedProfile>, 4> batches_;
};

} // namespace

SectorParts strips_pass(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                        Counts& counts, StageSeconds& seconds) {
  return run_pass<StripsPass>(work, lay_out, show, counts, seconds);
}

} // namespace orograph
