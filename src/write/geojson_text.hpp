// SPDX-License-Identifier: GPL-3.0-or-later
// GeoJSON (RFC 7946, with the CRS of the specification of 2008, which programs still read) as text,
// a feature a line.
#pragma once

#include "geometry/attributes.hpp"
#include "geometry/vec.hpp"
#include "write/byte_sink.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace orograph {

/// Writes a collection of features: for each its properties, in their order, then its geometry.
/// Texts are cleaned as by `clean_utf8`. REQUIRES finite coordinates.
class GeojsonText {
public:
  struct Head {
    std::string name;        ///< of the layer
    std::string description; ///< empty: none
    std::string crs_wkt;     ///< empty: none; one without an authority's name isn't told either
  };
  /// Numbers have `digits` significant ones, or as many as read back to the same number. Throws
  /// Error where the CRS isn't valid.
  GeojsonText(const Head& head, std::optional<int> digits, ByteSink& out);

  /// Of the feature that `line` or `point` ends. Numbers that are none are told as null.
  void property(std::string_view name, const AttributeValue& value);

  // All three tell whether all bytes up to now went out or wait in the sink.
  bool line(std::span<const Vec3> points);
  bool point(const std::optional<Vec2>& place);
  bool finish();

private:
  void append_number(double value, std::string& to) const;
  bool end_feature(std::string_view geometry);

  std::optional<int> digits_;
  ByteSink& out_;
  bool has_features_ = false;
  std::string properties_; ///< of the next feature, a comma before each
};

} // namespace orograph
