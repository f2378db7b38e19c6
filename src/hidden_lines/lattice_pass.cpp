// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden_lines/lattice_pass.hpp"

#include "geometry/on_all_cores.hpp"
#include "hidden_lines/instruments.hpp"
#include "hidden_lines/lattice_strip.hpp"
#include "hidden_lines/parts_by_edge.hpp"
#include "hidden_lines/profile_stages.hpp"
#include "hidden_lines/strips.hpp"
#include "placing/sector.hpp"
#include "profiles/silhouettes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>

namespace orograph {
namespace {

// Places are taken so many at a time that the profiles that begin there, where they run along the
// strips of cells, stay in the cache: some 40 bytes a vertex.
constexpr double kVerticesABand = 32768;
constexpr double kLeastPlaces = 8, kMostPlaces = 64;

std::uint32_t places_of_band(const LatticeInWork& lattice) {
  if (lattice.work.passes_over_profiles)
    return lattice.order.place_count(); // none waits for another
  const int cells =
      (lattice.order.rows_are_strips() ? lattice.grid.columns : lattice.grid.rows) - 1;
  return static_cast<std::uint32_t>(
      std::clamp(kVerticesABand / (2.0 * cells), kLeastPlaces, kMostPlaces));
}

// All strips of X and all profiles of a sector. The places of the lattice's order are taken in
// bands; in each, profiles that begin in the next band are cut, and those that ended in the last
// one are laid out, so that there are always tasks of several kinds for the threads.
class LatticePass {
public:
  LatticePass(const SectorInWork& work, const LayOut& lay_out)
      : lattice_(work), band_(places_of_band(lattice_)),
        strips_(strips_of<LatticeStrip>(work,
                                        [&](std::size_t i, const auto&... of_strip) {
                                          return std::make_unique<LatticeStrip>(lattice_,
                                                                                of_strip..., i);
                                        })),
        seconds_(strips_.size()), stages_(work, lay_out, strips_.size()) {
    const auto& profiles = work.sector.profiles;
    waiting_.reserve(profiles.size());
    for (std::size_t i = 0; i < profiles.size(); ++i) {
      const auto [first, last] = lattice_.places_of(
          profiles[i].depth_m, work.whole_profiles
                                   ? URange{}
                                   : u_range(work.sector.view, profiles[i].depth_m, work.range));
      waiting_.push_back({i, first / band_, last / band_});
    }
    std::stable_sort(waiting_.begin(), waiting_.end(), [](const Waiting& a, const Waiting& b) {
      return a.first_band < b.first_band;
    });
    slots_.resize(profiles.size());
  }

  void run(const Show& show, Counts& counts) {
    const std::uint32_t bands = (lattice_.order.place_count() + band_ - 1) / band_;
    // In round r band r is cut, r - 1 clipped, r - 2 laid out and r - 3 shown, which has to be in
    // order and is one task, the first.
    for (std::uint32_t round = 0; round < bands + 2; ++round) {
      begin_profiles(round);
      end_profiles(round);
      const bool clips = round >= 1 && round <= bands;
      const std::size_t first_cut = 1 + (clips ? strips_.size() : 0),
                        first_lay = first_cut + cutting_.size();
      if (clips && lattice_.order.earth()) find_spans((round - 1) * band_);
      on_all_cores(first_lay + laying_.size(), [&](std::size_t task) {
        if (task == 0)
          show_finished(show, counts);
        else if (task < first_cut)
          clip(task - 1, (round - 1) * band_);
        else if (task < first_lay)
          cut(cutting_[task - first_cut]);
        else
          stages_.lay_out(*slots_[laying_[task - first_lay]]);
      });
      // Those that were cut come into work, by depth.
      for (const std::size_t index : cutting_) active_.push_back(&slots_[index]->profile);
      std::sort(active_.begin(), active_.end(),
                [](const ProfileInWork* a, const ProfileInWork* b) { return a->index < b->index; });
      for (const std::size_t index : laying_) laid_out_[index] = true;
    }
    show_finished(show, counts);
    on_all_cores(strips_.size(), [&](std::size_t i) {
      Stopwatch watch;
      strips_[i]->finish();
      watch.mark(seconds_[i]);
    });
  }

  SectorParts found() const {
    SectorParts out = parts_by_edge(strips_, lattice_.work.lines.size());
    out.contours = seen_contours();
    return out;
  }

  void add_to(Counts& counts, StageSeconds& seconds) const {
    add_counts(strips_, counts);
    for (const double strip_s : seconds_) seconds.clip += strip_s;
    for (const auto& timed : free_) timed->add_to(seconds);
  }

private:
  struct Waiting {
    std::size_t profile;
    std::uint32_t first_band, last_band;
  };

  SeenContours seen_contours() const {
    std::vector<ContourRuns> runs;
    std::vector<ContourPart> parts;
    for (const auto& strip : strips_)
      if (LatticeContours* contours = strip->contours()) {
        std::ranges::move(contours->runs(), std::back_inserter(runs));
        parts.insert(parts.end(), contours->parts().begin(), contours->parts().end());
      }
    return orograph::seen_contours(std::move(runs), std::move(parts));
  }

  void begin_profiles(std::uint32_t band) {
    cutting_.clear();
    for (; next_waiting_ < waiting_.size() && waiting_[next_waiting_].first_band <= band;
         ++next_waiting_) {
      const std::size_t index = waiting_[next_waiting_].profile;
      if (free_.empty()) free_.push_back(std::make_unique<TimedProfile>());
      slots_[index] = std::move(free_.back());
      free_.pop_back();
      cutting_.push_back(index);
      last_band_[index] = waiting_[next_waiting_].last_band;
    }
  }

  void cut(std::size_t index) {
    stages_.cut(*slots_[index], index);
    ProfileInWork& profile = slots_[index]->profile;
    if (const EarthStrips* strips = lattice_.order.earth())
      profile.on_earth = spans_by_strip(profile.profile, *strips);
  }

  // Those whose last band was clipped in the last round.
  void end_profiles(std::uint32_t round) {
    laying_.clear();
    std::erase_if(active_, [&](const ProfileInWork* profile) {
      if (last_band_[profile->index] + 2 > round) return false;
      laying_.push_back(profile->index);
      return true;
    });
  }

  void clip(std::size_t number, std::uint32_t first_place) {
    Stopwatch watch;
    const std::uint32_t end = std::min(first_place + band_, lattice_.order.place_count());
    for (std::uint32_t place = first_place; place < end; ++place)
      strips_[number]->take(place, {active_, spans_[place - first_place]});
    watch.mark(seconds_[number]);
  }

  // Of all profiles what a band of places holds.
  void find_spans(std::uint32_t first_place) {
    for (auto& spans : spans_) spans.clear();
    const std::uint32_t end = std::min(first_place + band_, lattice_.order.place_count());
    int low = std::numeric_limits<int>::max(), high = -1;
    for (std::uint32_t place = first_place; place < end; ++place)
      if (const int strip = lattice_.order.place(place).strip;
          strip != LatticeOrder::Place::kNone) {
        low = std::min(low, strip);
        high = std::max(high, strip);
      }
    for (ProfileInWork* profile : active_) {
      const std::vector<SpansByStrip::Run>& runs = profile->on_earth.runs;
      const std::vector<double>& x = profile->projected.x;
      for (auto run = std::ranges::lower_bound(runs, low, {}, &SpansByStrip::Run::strip);
           run != runs.end() && run->strip <= high; ++run) {
        const std::uint32_t place =
            LatticeOrder::place_of(lattice_.order.turn_of_nearer(run->strip, 0));
        if (place >= first_place && place < end)
          spans_[place - first_place].push_back(
              {profile, run->first, run->end, x[run->first], x[run->end], 0});
      }
    }
    for (auto& spans : spans_) {
      std::ranges::stable_sort(spans, {}, &SpansOfPlace::x_begin);
      double last = -std::numeric_limits<double>::infinity();
      for (SpansOfPlace& of : spans) of.x_last = last = std::max(last, of.x_end);
    }
  }

  void show_finished(const Show& show, Counts& counts) {
    for (; next_shown_ < slots_.size() && laid_out_[next_shown_]; ++next_shown_) {
      ProfileInWork& profile = slots_[next_shown_]->profile;
      count(profile, counts);
      show(profile);
      free_.push_back(std::move(slots_[next_shown_]));
    }
  }

  LatticeInWork lattice_;
  std::uint32_t band_; ///< places
  std::vector<std::unique_ptr<LatticeStrip>> strips_;
  std::vector<double> seconds_;
  ProfileStages stages_;
  std::vector<Waiting> waiting_; ///< by the band that they begin in
  std::size_t next_waiting_ = 0, next_shown_ = 0;
  std::vector<std::unique_ptr<TimedProfile>> slots_; ///< by profile, of those in work
  std::vector<std::unique_ptr<TimedProfile>> free_;
  std::vector<ProfileInWork*> active_;                  ///< that are clipped, by depth
  std::vector<std::vector<SpansOfPlace>> spans_{band_}; ///< by place of the band; on the earth
  std::vector<std::size_t> cutting_, laying_;
  std::vector<std::uint32_t> last_band_ =
      std::vector<std::uint32_t>(lattice_.work.sector.profiles.size());
  std::vector<bool> laid_out_ = std::vector<bool>(lattice_.work.sector.profiles.size());
};

} // namespace

bool pays_in_order(const Grid& grid, const Sector& sector, const EarthStrips* strips,
                   LinesTaken lines) {
  if (!lines.profiles) return true;
  const SectorLattice lattice(grid, sector.view, strips);
  const XRange range = page_range(sector);
  double pieces = 0;
  for (const PlannedProfile& profile : sector.profiles) {
    const auto [first, last] =
        lattice.places_of(profile.depth_m, u_range(sector.view, profile.depth_m, range));
    pieces += last - first;
  }
  // Default drawings of nine terrains from aslant took 0.6 to 1.1 times as long in order as in
  // slabs with contours, the middle one 0.7, and 0.9 to 1.08 times as long without.
  constexpr double kCellsAPiece = 8, kWithContours = 1;
  const auto cells = static_cast<double>(grid.size());
  if (pieces * (lines.contours ? kWithContours : kCellsAPiece) <= cells) return true;
  // A profile a row from 213: where there is a piece for each silhouette, rough 2000² seen from 25
  // degrees takes 0.8 times as long in order; with three, seen from 60, 1.3 times, Mont Blanc 1.2
  // times with four, and a smooth terrain twice as long with nine.
  constexpr double kPiecesASilhouette = 1.5;
  return !strips && pieces <= kPiecesASilhouette * cells * silhouettes_a_cell(grid, sector.view);
}

bool may_pay_on_earth(const Grid& grid, const Sector& sector, bool profiles) {
  // With 0.03 to 0.14 silhouettes a cell five tiles took 0.8 to 0.95 times as long in order as in
  // slabs; the Cape Peninsula, most of it sea, 0.9 to 1.1 times with 0.01, and a tile that is
  // nearly all sea 1.2 times.
  constexpr double kLeastSilhouettes = 0.03;
  constexpr double kMostPieces = 0.25; // a cell, if each profile passed all strips
  const double count = profiles ? static_cast<double>(sector.profiles.size()) : 0;
  return count * std::max(grid.columns, grid.rows) <=
             kMostPieces * static_cast<double>(grid.size()) &&
         silhouettes_a_cell(grid, sector.view) >= kLeastSilhouettes;
}

SectorParts lattice_pass(const SectorInWork& work, const LayOut& lay_out, const Show& show,
                         Counts& counts, StageSeconds& seconds) {
  return run_pass<LatticePass>(work, lay_out, show, counts, seconds);
}

} // namespace orograph
