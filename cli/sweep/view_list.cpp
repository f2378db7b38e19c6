// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/view_list.hpp"

#include "cli/sweep/name_template.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace orograph {
namespace {

std::vector<double> numbers_up_to(std::size_t count) {
  std::vector<double> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0.0);
  return numbers;
}

void check_zipped(const std::vector<Axis>& axes) {
  const Axis* list = nullptr;
  for (const Axis& axis : axes) {
    if (axis.values.size() == 1) continue;
    if (!list) list = &axis;
    if (axis.values.size() != list->values.size())
      throw UsageError(fmt::format("--zip: {} has {} values and {} {}",
                                   names_of(list->parameter).option, list->values.size(),
                                   names_of(axis.parameter).option, axis.values.size()),
                       "give them as many values, or leave --zip out to cross them");
  }
}

} // namespace

double view_count(const std::vector<Axis>& axes, bool zipped) {
  double count = 1;
  for (const Axis& axis : axes) {
    const auto values = static_cast<double>(axis.values.size());
    count = zipped ? std::max(count, values) : count * values;
  }
  return count;
}

ViewList::ViewList(const SweepSettings& settings, const MapFrame& map) : sweep_(settings) {
  if (!settings.views.empty())
    axes_.push_back({Parameter::view, numbers_up_to(settings.views.size())});
  if (!settings.eye_path.empty()) {
    eyes_ = read_eye_path(settings.eye_path, settings.eye_step_m, map);
    axes_.push_back({Parameter::eye, numbers_up_to(eyes_.size())});
  }
  axes_.insert(axes_.end(), settings.axes.begin(), settings.axes.end());
  if (settings.zipped) check_zipped(axes_);
  const double count = view_count(axes_, settings.zipped);
  if (count > kManyViews && !settings.many)
    throw UsageError(fmt::format("that makes {:.0f} views", count),
                     "give --yes if you mean it, or larger steps");
  size_ = static_cast<std::size_t>(count);

  const NameTemplate names(settings.name_template, axes_, settings.views, size_);
  std::unordered_map<std::string, std::size_t> seen;
  names_.reserve(size_);
  for (std::size_t number = 0; number < size_; ++number) {
    names_.push_back(names.name(number, values(number)));
    const auto [other, is_new] = seen.emplace(names_.back(), number);
    if (!is_new)
      throw UsageError(fmt::format("views {} and {} would both be called '{}'", other->second,
                                   number, names_.back()),
                       "put what differs into --name, or {index}");
  }
}

std::size_t ViewList::index_on(std::size_t axis, std::size_t number) const {
  if (sweep_.zipped) return axes_[axis].values.size() == 1 ? 0 : number;
  for (std::size_t later = axes_.size(); later-- > axis + 1;) number /= axes_[later].values.size();
  return number % axes_[axis].values.size();
}

std::vector<double> ViewList::values(std::size_t number) const {
  std::vector<double> values;
  for (std::size_t axis = 0; axis < axes_.size(); ++axis)
    values.push_back(axes_[axis].values[index_on(axis, number)]);
  return values;
}

RenderSettings ViewList::settings(std::size_t number) const {
  RenderSettings settings = sweep_.render;
  const std::vector<double> at = values(number);
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    const Parameter parameter = axes_[axis].parameter;
    const auto index = static_cast<std::size_t>(at[axis]);
    if (parameter == Parameter::view) {
      settings.map.view.file = sweep_.views[index].view;
      settings.map.view.file_name = sweep_.views_file;
    } else if (parameter == Parameter::eye) {
      settings.map.view.eye_map = eyes_[index].place;
      if (settings.map.view.eye_height_m) settings.map.view.eye_map->z.reset();
      const bool looks = settings.map.view.look_at_map || settings.map.view.look_at_lonlat ||
                         settings.map.view.look_azimuth;
      if (!looks) settings.map.view.look_azimuth = eyes_[index].look;
    } else {
      set_parameter(settings, parameter, at[axis]);
    }
  }
  return settings;
}

} // namespace orograph
