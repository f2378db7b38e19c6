// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/name_template.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
      const std::string& label = names_of(axis.parameter).label;
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

} // namespace

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

} // namespace orograph
