// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/view_list.hpp"

#include "geometry/error.hpp"
#include "placing/view_file.hpp"
#include "text/number_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <unordered_map>
#include <vector>

namespace orograph {
namespace {

constexpr std::size_t kLongestName = 200; // of 255 bytes; room for extensions and temporaries

std::size_t digits_of(double number) {
  return number_text(std::trunc(std::abs(number))).size();
}

// After the point.
std::size_t decimals_of(double number) {
  const std::string text = number_text(number);
  const std::size_t point = text.find('.');
  return point == std::string::npos || text.find('e') != std::string::npos
             ? 0
             : text.size() - point - 1;
}

std::string padded(double number, std::size_t digits, std::size_t decimals) {
  std::string text = number_text(std::abs(number));
  const std::size_t whole = std::min(text.find('.'), text.size());
  if (decimals > 0 && text.find('e') == std::string::npos) {
    if (whole == text.size()) text += '.';
    text.resize(whole + 1 + decimals, '0');
  }
  return (std::signbit(number) && number != 0 ? "-" : "") +
         std::string(digits > whole ? digits - whole : 0, '0') + text;
}

std::string default_template(const std::vector<Axis>& axes) {
  std::string text;
  for (const Axis& axis : axes)
    if (axis.values.size() > 1) {
      const std::string_view label = names_of(axis.parameter).label;
      text += fmt::format("{}{}-{{{}}}", text.empty() ? "" : "_", label, label);
    }
  return text.empty() ? "view" : text;
}

[[noreturn]] void refuse(const std::string& name_template, const std::string& what,
                         const std::vector<Axis>& axes) {
  std::string fields = "{index}";
  for (const Axis& axis : axes) fields += fmt::format(", {{{}}}", names_of(axis.parameter).label);
  throw UsageError(fmt::format("--name '{}' can't be used: {}", name_template, what),
                   "its fields may be " + fields);
}

// "az{azimuth}-{index}": text, and in braces `index` (a view's number, from 0) or the label of a
// parameter that varies. Numbers get zeros on both sides, so that names sort as they do (but for
// those below zero). An empty template is made of all that varies: "azimuth-045_elevation-05".
class NameTemplate {
public:
  // Throws UsageError where the template names something else, holds a slash or a control
  // character.
  NameTemplate(const std::string& name_template, const std::vector<Axis>& axes,
               const std::vector<NamedView>& views, std::size_t view_count);

  // `values` by axis. Throws UsageError where the name would be hidden, or too long for a file.
  std::string name(std::size_t number, const std::vector<double>& values) const;

private:
  static constexpr std::size_t kIndex = static_cast<std::size_t>(-1);
  struct Part {
    std::string text; ///< before the field
    bool is_field;
    std::size_t axis;     ///< or kIndex
    std::size_t digits;   ///< before the point, at least
    std::size_t decimals; ///< after it
  };
  std::vector<Part> parts_;
  const std::vector<Axis>& axes_;
  const std::vector<NamedView>& views_;
};

NameTemplate::NameTemplate(const std::string& given, const std::vector<Axis>& axes,
                           const std::vector<NamedView>& views, std::size_t view_count)
    : axes_(axes), views_(views) {
  const std::string text = given.empty() ? default_template(axes) : given;
  if (text.find('/') != std::string::npos) refuse(text, "names hold no slash", axes);
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      refuse(text, "it holds a control character", axes);
  std::size_t at = 0;
  for (;;) {
    const std::size_t open = text.find_first_of("{}", at);
    Part part{text.substr(at, open - at), open != std::string::npos, kIndex, 1, 0};
    if (!part.is_field) {
      parts_.push_back(part);
      return;
    }
    const std::size_t close = text.find_first_of("{}", open + 1);
    if (text[open] == '}' || close == std::string::npos || text[close] == '{')
      refuse(text, "a brace has no partner", axes);
    const std::string field = text.substr(open + 1, close - open - 1);
    if (field == "index") {
      part.digits = digits_of(static_cast<double>(view_count - 1));
    } else {
      const auto axis = std::find_if(axes.begin(), axes.end(), [&](const Axis& a) {
        return names_of(a.parameter).label == field;
      });
      if (axis == axes.end()) refuse(text, fmt::format("there is no {{{}}} here", field), axes);
      part.axis = static_cast<std::size_t>(axis - axes.begin());
      for (const double value : axis->values) {
        part.digits = std::max(part.digits, digits_of(value));
        part.decimals = std::max(part.decimals, decimals_of(value));
      }
    }
    parts_.push_back(part);
    at = close + 1;
  }
}

std::string NameTemplate::name(std::size_t number, const std::vector<double>& values) const {
  std::string name;
  for (const Part& part : parts_) {
    name += part.text;
    if (!part.is_field) continue;
    if (part.axis == kIndex) {
      name += padded(static_cast<double>(number), part.digits, 0);
      continue;
    }
    const double value = values[part.axis];
    const bool by_name = axes_[part.axis].parameter == Parameter::view &&
                         !views_[static_cast<std::size_t>(value)].name.empty();
    name += by_name ? views_[static_cast<std::size_t>(value)].name
                    : padded(value, part.digits, part.decimals);
  }
  if (name.front() == '.')
    throw UsageError(fmt::format("'{}' begins with a point, which hides files", name),
                     "give a --name that begins with something else");
  if (name.size() > kLongestName)
    throw UsageError(fmt::format("'{}…' is too long for a name", name.substr(0, 40)),
                     "give a shorter --name");
  return name;
}

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
    eyes_ = read_eye_path(settings.eye_path, settings.eye_step_m, map,
                          settings.render.reading.allow_network);
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
