// SPDX-License-Identifier: GPL-3.0-or-later
// A long triangle is entered row by row of buckets, where it really is, because the box of one that
// runs aslant holds many buckets that it never comes near.
#include "dem/mesh/tin_index.hpp"

#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

namespace orograph {
namespace {

constexpr std::size_t most_entries = 16; // a triangle
// A triangle. With one each most triangles are in six, and large ones, beside small ones, in many.
constexpr double kBuckets = 0.25;

// Range of x, or an empty one.
struct Run {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void include(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

// Adds the part of the line from p to q with y in [low_y, high_y].
void include_part(Run& run, Vec2 p, Vec2 q, double low_y, double high_y) {
  if (p.y > q.y) std::swap(p, q);
  if (q.y < low_y || p.y > high_y) return;
  const auto x_at = [&](double y) { return p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x); };
  run.include(p.y < low_y ? x_at(low_y) : p.x);
  run.include(q.y > high_y ? x_at(high_y) : q.x);
}

double finite(double length) {
  return std::min(length, std::numeric_limits<double>::max());
}

double greatest_coordinate(const Box2& box) {
  return std::max(
      {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
}

bool meet(const Box2& a, const Box2& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

void keep_each_once(std::vector<std::uint32_t>& triangles) {
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
}

constexpr double kRounding = 0x1p-49; // of a place on an edge, a share of the largest coordinate

} // namespace

TinIndex::TinIndex(const Tin& tin) : tin_(tin) {
  std::mutex box_mutex;
  on_all_cores(tasks_of_triangles(tin), [&](std::size_t task) {
    Box2 box;
    for (const std::uint32_t t : triangles_of_task(tin, task)) {
      const Box2 of_triangle = box_of(t);
      box.include(of_triangle.low);
      box.include(of_triangle.high);
    }
    const std::lock_guard lock(box_mutex);
    box_.include(box.low);
    box_.include(box.high);
  });
  rounding_m_ = kRounding * greatest_coordinate(box_);

  const double width = finite(box_.width()), height = finite(box_.height()),
               buckets = std::max(1.0, kBuckets * static_cast<double>(tin.triangles.size()));
  lay_buckets(
      std::max(std::sqrt(width) * std::sqrt(height / buckets), std::max(width, height) / buckets));
  while (!count(most_entries * tin.triangles.size())) lay_buckets(2 * bucket_m_);

  // Each is its bucket's end until that is filled, from the end down. In which order cores come
  // there doesn't matter: what is found is sorted.
  std::uint32_t sum = 0;
  for (std::uint32_t& b : begin_) b = sum += b;
  triangles_.resize(sum);
  on_all_cores(tasks_of_triangles(tin), [&](std::size_t task) {
    for (const std::uint32_t t : triangles_of_task(tin, task))
      for_each_run(t, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i <= last; ++i)
          triangles_[std::atomic_ref(begin_[i]).fetch_sub(1, std::memory_order_relaxed) - 1] = t;
      });
  });
}

void TinIndex::lay_buckets(double bucket_m) {
  bucket_m_ = bucket_m > 0 ? finite(bucket_m) : 1;
  columns_ = 1 + static_cast<int>(finite(box_.width()) / bucket_m_);
  rows_ = 1 + static_cast<int>(finite(box_.height()) / bucket_m_);
}

// Entries of every bucket; false if they are more than `most`.
bool TinIndex::count(std::size_t most) {
  begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  std::atomic<std::size_t> entries = 0;
  on_all_cores(tasks_of_triangles(tin_), [&](std::size_t task) {
    std::size_t of_task = 0;
    for (const std::uint32_t t : triangles_of_task(tin_, task)) {
      if (entries + of_task > most) break;
      for_each_run(t, [&](std::size_t first, std::size_t last) {
        of_task += last - first + 1;
        for (std::size_t i = first; i <= last; ++i)
          std::atomic_ref(begin_[i]).fetch_add(1, std::memory_order_relaxed);
      });
    }
    entries += of_task;
  });
  return entries <= most;
}

// Both are monotone, rounding included, so that boxes which meet have a bucket in common.
int TinIndex::column_of(double x) const {
  return static_cast<int>(std::clamp((x - box_.low.x) / bucket_m_, 0.0, columns_ - 1.0));
}
int TinIndex::row_of(double y) const {
  return static_cast<int>(std::clamp((y - box_.low.y) / bucket_m_, 0.0, rows_ - 1.0));
}

Box2 TinIndex::box_of(std::uint32_t triangle) const {
  Box2 box;
  for (const std::uint32_t v : tin_.triangles[triangle])
    box.include({tin_.vertices_m[v].x, tin_.vertices_m[v].y});
  return box;
}

// Buckets [first, last] of every row that the triangle meets.
template <class Visit>
void TinIndex::for_each_run(std::uint32_t triangle, Visit visit) const {
  const Box2 box = box_of(triangle);
  const int first_row = row_of(box.low.y), last_row = row_of(box.high.y);
  const int first_column = column_of(box.low.x), last_column = column_of(box.high.x);
  const auto bucket = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  };
  // A triangle so wide that differences overflow is entered by its box.
  const bool small = last_row - first_row < 2 || last_column - first_column < 2;
  if (small || !std::isfinite(box.width()) || !std::isfinite(box.height())) {
    for (int row = first_row; row <= last_row; ++row)
      visit(bucket(first_column, row), bucket(last_column, row));
    return;
  }
  const double slack = rounding_m_ + 0x1p-20 * bucket_m_;
  for (int row = first_row; row <= last_row; ++row) {
    const double low_y = box_.low.y + row * bucket_m_ - slack;
    const double high_y = box_.low.y + (row + 1) * bucket_m_ + slack;
    Run run;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = tin_.vertices_m[tin_.triangles[triangle][k]];
      const Vec3 q = tin_.vertices_m[tin_.triangles[triangle][(k + 1) % 3]];
      include_part(run, {p.x, p.y}, {q.x, q.y}, low_y, high_y);
    }
    if (run.low <= run.high)
      visit(bucket(column_of(run.low - slack), row), bucket(column_of(run.high + slack), row));
  }
}

// What is entered in buckets (first, row) to (last, row) and whose box meets `box`.
void TinIndex::append(int first, int last, int row, const Box2& box,
                      std::vector<std::uint32_t>& out) const {
  const std::size_t before = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
  const std::uint32_t begin = begin_[before + static_cast<std::size_t>(first)];
  const std::uint32_t end = begin_[before + static_cast<std::size_t>(last) + 1];
  for (std::uint32_t i = begin; i < end; ++i)
    if (meet(box_of(triangles_[i]), box)) out.push_back(triangles_[i]);
}

void TinIndex::meeting(const Box2& box, std::vector<std::uint32_t>& out) const {
  out.clear();
  if (!meet(box, box_)) return;
  const int first = column_of(box.low.x), last = column_of(box.high.x);
  for (int row = row_of(box.low.y); row <= row_of(box.high.y); ++row)
    append(first, last, row, box, out);
  keep_each_once(out);
}

void TinIndex::along(Vec2 from, Vec2 to, double slack_m, std::vector<std::uint32_t>& out) const {
  out.clear();
  Box2 strip;
  strip.include(from);
  strip.include(to);
  const double slack =
      slack_m + kRounding * std::max(greatest_coordinate(strip), greatest_coordinate(box_));
  strip = {{strip.low.x - slack, strip.low.y - slack},
           {strip.high.x + slack, strip.high.y + slack}};
  if (!meet(strip, box_)) return;
  for (int row = row_of(strip.low.y); row <= row_of(strip.high.y); ++row) {
    // Outermost rows hold what is beyond as well, as far as rounding goes: `slack` has room for it.
    Run run;
    include_part(run, from, to, box_.low.y + row * bucket_m_ - slack,
                 box_.low.y + (row + 1) * bucket_m_ + slack);
    if (run.low <= run.high)
      append(column_of(run.low - slack), column_of(run.high + slack), row, strip, out);
  }
  keep_each_once(out);
}

} // namespace orograph
