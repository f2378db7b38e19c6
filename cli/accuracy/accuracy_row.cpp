// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/accuracy/accuracy_row.hpp"

#include "geometry/error.hpp"

#include <fmt/format.h>

namespace orograph {

std::string name_of(const AccuracyRow& row) {
  const RowSettings& s = row.settings;
  std::string name =
      fmt::format("{}, {} profiles", s.occluder == Occluder::surface ? "surface" : "profiles",
                  row.profile_count);
  if (s.simplify_mm != RowSettings{}.simplify_mm)
    name += fmt::format(", simplify {} mm", s.simplify_mm);
  if (s.overview) name += fmt::format(", overview {}", *s.overview);
  if (!s.collapse) name += ", no collapse";
  if (s.arithmetic == Arithmetic::float32) name += ", float";
  if (s.arithmetic == Arithmetic::float64 && row.group == "arithmetic") name += ", double";
  if (s.arithmetic == Arithmetic::exact) name += ", exact";
  return name;
}

std::string broken_promise(const AccuracyRow& row) {
  const RowPromise& promise = row.promise;
  const InkSample ink = row.profiles + row.lines;
  if (promise.ink_error && ink.error() > *promise.ink_error)
    return fmt::format("its ink error is {:.3g} %, promised {:.3g} %", 100 * ink.error(),
                       100 * *promise.ink_error);
  if (promise.displacement_mm && row.displacement_mm() > *promise.displacement_mm)
    return fmt::format("its displacement is {:.3g} mm, promised {:.3g} mm", row.displacement_mm(),
                       *promise.displacement_mm);
  if (promise.simplified_mm && row.simplified &&
      row.simplified->largest_mm > *promise.simplified_mm)
    return fmt::format("its simplification moved a point by {:.3g} mm, promised {:.3g} mm",
                       row.simplified->largest_mm, *promise.simplified_mm);
  return "";
}

void check_promises(const std::vector<AccuracyRow>& rows) {
  for (const AccuracyRow& row : rows)
    if (const std::string broken = broken_promise(row); !broken.empty())
      throw Error(fmt::format("the row '{}' breaks its promise, {}", name_of(row), broken),
                  "please report it with the terrain and the command");
}

} // namespace orograph
