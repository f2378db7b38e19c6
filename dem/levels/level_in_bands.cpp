// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/levels/level_in_bands.hpp"

#include "dem/levels/summits.hpp"
#include "geometry/on_all_cores.hpp"

#include <algorithm>
#include <cmath>

namespace orograph {
namespace {

// Whether a vertex and all beside it that have a height have the same.
template <class Height>
bool is_level(std::span<const Height> above, std::span<const Height> line,
              std::span<const Height> below, int column) {
  const Height height = line[static_cast<std::size_t>(column)];
  const auto width = static_cast<int>(line.size());
  for (const std::span<const Height> beside : {above, line, below})
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, width - 1); ++c) {
      if (beside.empty()) continue;
      const Height other = beside[static_cast<std::size_t>(c)];
      if (other != height && !std::isnan(other)) return false;
    }
  return true;
}

} // namespace

template <class Height>
LevelInBands<Height>::LevelInBands(int columns, int rows, int step)
    : step_(step), file_columns_(columns), file_rows_(rows),
      across_(stretched_windows(columns, vertices_for(columns, step))),
      down_(stretched_windows(rows, vertices_for(rows, step))),
      place_across_(places_in_level(columns, this->columns())),
      place_down_(places_in_level(rows, this->rows())), around_(down_.size()),
      heights_(across_.size() * down_.size()), departures_(static_cast<std::size_t>(rows)),
      side_(kSummitsApart * step), tops_(columns, rows, side_) {}

template <class Height>
void LevelInBands<Height>::take(const Band<Height>& band) {
  bands_.push_back(band);
  gather(band);
  make_rows();
  const bool is_last = band.first_row + band.rows == file_rows_;
  compare(is_last ? file_rows_ : band.first_row + band.rows - 1);
  forget();
}

// Of the grid. Empty where there is none, or none any more.
template <class Height>
std::span<const Height> LevelInBands<Height>::line(int row) const {
  const auto width = static_cast<std::size_t>(file_columns_);
  for (const Band<Height>& band : bands_)
    if (row >= band.first_row && row < band.first_row + band.rows)
      return {band.heights->data() + static_cast<std::size_t>(row - band.first_row) * width, width};
  return {};
}

// What is around the level's rows that this band brings something of.
template <class Height>
void LevelInBands<Height>::gather(const Band<Height>& band) {
  const int end = band.first_row + band.rows;
  std::vector<std::size_t> reached; // not in order: a window at a border is narrower
  for (std::size_t j = around_end_; j < down_.size() && down_[j].middle - step_ < end + step_; ++j)
    if (down_[j].first < end && down_[j].last >= band.first_row) {
      reached.push_back(j);
      if (down_[j].last >= end) begun_.try_emplace(j, down_[j]);
    }
  on_all_cores(reached.size(), [&](std::size_t i) {
    const std::size_t j = reached[i];
    const LevelWindow& window = down_[j];
    const auto found = begun_.find(j);
    thread_local RowGathering<Height> whole;
    if (found == begun_.end()) whole.begin(window);
    RowGathering<Height>& gathering = found == begun_.end() ? whole : found->second;
    const int last = std::min(window.last, end - 1);
    for (int row = std::max(window.first, band.first_row); row <= last; ++row)
      gathering.add(line(row), row);
    if (window.last < end) around_[j] = gathering.around(line(window.nearest()), across_);
  });
  std::erase_if(begun_, [&](const auto& begun) { return down_[begun.first].last < end; });
  while (around_end_ < down_.size() && down_[around_end_].last < end) ++around_end_;
}

template <class Height>
void LevelInBands<Height>::make_rows() {
  // The last row has none below it.
  const std::size_t end = around_end_ == down_.size() ? around_end_
                          : around_end_ > 0           ? around_end_ - 1
                                                      : 0;
  if (end <= made_) return;
  on_all_cores(end - made_, [&](std::size_t i) {
    const std::size_t j = made_ + i;
    const int nearest = down_[j].nearest();
    const auto above = line(nearest - 1), here = line(nearest), below = line(nearest + 1);
    const std::vector<double> made = heights_with_character(around_, j);
    for (std::size_t column = 0; column < across_.size(); ++column) {
      const int at = across_[column].nearest();
      heights_[j * across_.size() + column] = is_level(above, here, below, at)
                                                  ? here[static_cast<std::size_t>(at)]
                                                  : static_cast<Height>(made[column]);
    }
  });
  for (std::size_t j = made_ > 0 ? made_ - 1 : 0; j + 1 < end; ++j) around_[j] = {};
  made_ = end;
}

// Rows of the grid before `end_row` with the level, where that is there, and what is highest.
template <class Height>
void LevelInBands<Height>::compare(int end_row) {
  int end = compared_;
  while (end < end_row &&
         static_cast<std::size_t>(place_down_[static_cast<std::size_t>(end)].cell) + 1 < made_)
    ++end;
  const auto row_of_level = [&](int row) {
    return std::span<const Height>(heights_).subspan(static_cast<std::size_t>(row) * across_.size(),
                                                     across_.size());
  };
  const int first_square = compared_ / side_;
  const auto squares =
      static_cast<std::size_t>(end > compared_ ? (end - 1) / side_ - first_square + 1 : 0);
  on_all_cores(static_cast<std::size_t>(end - compared_), [&](std::size_t i) {
    const int row = compared_ + static_cast<int>(i);
    const auto [cell, share] = place_down_[static_cast<std::size_t>(row)];
    departures_[static_cast<std::size_t>(row)] = departure_of_row(
        line(row), row_of_level(cell), row_of_level(cell + 1), share, place_across_);
  });
  on_all_cores(squares, [&](std::size_t i) {
    const int first = (first_square + static_cast<int>(i)) * side_;
    for (int row = std::max(first, compared_); row < std::min(first + side_, end); ++row)
      tops_.add(row, line(row - 1), line(row), line(row + 1));
  });
  compared_ = end;
}

template <class Height>
void LevelInBands<Height>::forget() {
  const int needed =
      std::min(compared_ - 1, made_ < down_.size() ? down_[made_].nearest() - 1 : file_rows_);
  while (!bands_.empty() && bands_.front().first_row + bands_.front().rows <= needed)
    bands_.pop_front();
}

template <class Height>
LargerCells LevelInBands<Height>::larger_cells(std::size_t most) const {
  return {step_, file_columns_, file_rows_, departure_of(departures_), tops_.tops(most)};
}

template class LevelInBands<float>;
template class LevelInBands<double>;

} // namespace orograph
