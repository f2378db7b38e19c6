// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/page/page_tone.hpp"

#include "geometry/error.hpp"
#include "geometry/on_all_cores.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <string>

namespace orograph {
namespace {

constexpr int kPerWindow = 12; // normals on a side
constexpr double kStep_mm = kToneWindow_mm / kPerWindow;

double mean(std::span<const double> numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

std::vector<double> ranks(std::span<const double> numbers) {
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return numbers[i]; });
  std::vector<double> out(numbers.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && numbers[order[end]] == numbers[order[first]]) ++end;
    for (std::size_t i = first; i < end; ++i)
      out[order[i]] = 0.5 * static_cast<double>(first + end - 1);
  }
  return out;
}

// Normals of the ground on a lattice over the frame; none where there is no ground, or water.
class Normals {
public:
  Normals(const PageGround& ground, const Box2& frame_mm)
      : columns_(static_cast<int>(frame_mm.width() / kStep_mm)),
        rows_(static_cast<int>(frame_mm.height() / kStep_mm)),
        normals_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    on_all_cores(static_cast<std::size_t>(rows_), [&](std::size_t row) {
      for (int column = 0; column < columns_; ++column) {
        const auto shown =
            ground.at(frame_mm.low + kStep_mm * Vec2{column + 0.5, static_cast<double>(row) + 0.5});
        if (shown && !shown->is_level)
          normals_[index(column, static_cast<int>(row))] = shown->normal;
      }
    });
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  // None where one of the neighbours is.
  std::optional<Vec3> smoothed(int column, int row) const {
    Vec3 sum;
    for (int r = row - 1; r <= row + 1; ++r)
      for (int c = column - 1; c <= column + 1; ++c) {
        if (c < 0 || r < 0 || c >= columns_ || r >= rows_ || !normals_[index(c, r)])
          return std::nullopt;
        const double weight = (c == column ? 2 : 1) * (r == row ? 2 : 1);
        sum = sum + weight * *normals_[index(c, r)];
      }
    return (1 / length(sum)) * sum;
  }

private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  int columns_, rows_;
  std::vector<std::optional<Vec3>> normals_;
};

} // namespace

double AskedTone::darkness(Vec3 normal) const {
  const double azimuth_rad = azimuth.in_radians(), altitude_rad = altitude.in_radians();
  const Vec3 light{std::cos(altitude_rad) * std::sin(azimuth_rad),
                   std::cos(altitude_rad) * std::cos(azimuth_rad), std::sin(altitude_rad)};
  const double lit = std::clamp(dot(normal, light), 0.0, 1.0);
  return light_side + (shadow_side - light_side) * std::pow(1 - lit, 1.2);
}

std::vector<ToneWindow> tone_windows(const PageGround& ground, const Box2& frame_mm,
                                     const AskedTone& asked) {
  const Normals normals(ground, frame_mm);
  std::vector<ToneWindow> windows;
  for (int row = 0; row + kPerWindow <= normals.rows(); row += kPerWindow)
    for (int column = 0; column + kPerWindow <= normals.columns(); column += kPerWindow) {
      double sum = 0;
      int counted = 0;
      for (int r = row; r < row + kPerWindow; ++r)
        for (int c = column; c < column + kPerWindow; ++c)
          if (const auto normal = normals.smoothed(c, r)) {
            sum += asked.darkness(*normal);
            ++counted;
          }
      if (counted != kPerWindow * kPerWindow) continue;
      const Vec2 low = frame_mm.low + kStep_mm * Vec2{1.0 * column, 1.0 * row};
      windows.push_back({{low, low + Vec2{kToneWindow_mm, kToneWindow_mm}}, sum / counted});
    }
  return windows;
}

double PagePixels::mean_darkness(const Box2& mm) const {
  const auto first = [&](double at_mm) {
    return static_cast<std::size_t>(std::max(0.0, std::ceil(at_mm * per_mm - 0.5)));
  };
  const std::size_t right = std::min(columns, first(mm.high.x)),
                    bottom = std::min(rows, first(mm.high.y));
  double light = 0, counted = 0;
  for (std::size_t row = first(mm.low.y); row < bottom; ++row)
    for (std::size_t column = first(mm.low.x); column < right; ++column) {
      light += levels[row * columns + column];
      ++counted;
    }
  return 1 - light / (255 * counted);
}

PagePixels read_page_pixels(const std::string& path, double per_mm) {
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> image(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
  if (!image) throw Error(path + " is no image", "give one that GDAL reads");
  const int columns = image->GetRasterXSize(), rows = image->GetRasterYSize();
  PagePixels pixels{static_cast<std::size_t>(columns), static_cast<std::size_t>(rows), per_mm, {}};
  pixels.levels.resize(pixels.columns * pixels.rows);
  if (image->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns, rows, pixels.levels.data(), columns,
                                        rows, GDT_Byte, 0, 0, nullptr) != CE_None)
    throw Error(path + " can't be read to its end", "give a whole image");
  return pixels;
}

double rank_correlation(std::span<const double> a, std::span<const double> b) {
  const std::vector<double> of_a = ranks(a), of_b = ranks(b);
  const double middle = mean(of_a); // of both
  double together = 0, squares_a = 0, squares_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    together += (of_a[i] - middle) * (of_b[i] - middle);
    squares_a += (of_a[i] - middle) * (of_a[i] - middle);
    squares_b += (of_b[i] - middle) * (of_b[i] - middle);
  }
  return together / std::sqrt(squares_a * squares_b);
}

double greatest_departure(std::span<const double> numbers) {
  const double middle = mean(numbers);
  double greatest = 0;
  for (const double number : numbers) greatest = std::max(greatest, std::abs(number - middle));
  return greatest / middle;
}

} // namespace orograph
