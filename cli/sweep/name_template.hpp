// SPDX-License-Identifier: GPL-3.0-or-later
// What the drawings of a sweep are called.
#pragma once

#include "cli/sweep/parameter.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include "placing/view_file.hpp"

namespace orograph {

/// "az{azimuth}-{index}": text, and in braces `index` (a view's number, from 0) or the label of a
/// parameter that varies. Numbers get zeros on both sides, so that names sort as they do (but for
/// those below zero). An empty template is made of all that varies: "azimuth-045_elevation-05".
class NameTemplate {
public:
  /// Throws UsageError where the template names something else, holds a slash or a control
  /// character.
  NameTemplate(const std::string& name_template, const std::vector<Axis>& axes,
               const std::vector<NamedView>& views, std::size_t view_count);

  /// `values` by axis. Throws UsageError where the name would be hidden, or too long for a file.
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

} // namespace orograph
