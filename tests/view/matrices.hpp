// SPDX-License-Identifier: GPL-3.0-or-later
// Points through 4x4 matrices, and what a degenerate view is told.
#pragma once

#include "geometry/error.hpp"
#include "geometry/vec.hpp"
#include "tests/catch.hpp"

#include <Eigen/Core>

#include <string>

namespace orograph {

inline Eigen::Vector4d homogeneous(Vec3 p) {
  return {p.x, p.y, p.z, 1};
}

inline Vec3 over_w(const Eigen::Vector4d& p) {
  return {p.x() / p.w(), p.y() / p.w(), p.z() / p.w()};
}

inline Vec3 moved(const Eigen::Matrix4d& matrix, Vec3 p) {
  return over_w(matrix * homogeneous(p));
}

/// The last column aside: what becomes of a direction.
inline Vec3 turned(const Eigen::Matrix4d& matrix, Vec3 d) {
  const Eigen::Vector4d image = matrix * Eigen::Vector4d(d.x, d.y, d.z, 0);
  return {image.x(), image.y(), image.z()};
}

inline double distance(Vec3 a, Vec3 b) {
  return length(a - b);
}

/// One line that holds `words`.
template <class Call>
void check_refused(const Call& call, const std::string& words) {
  std::string message;
  try {
    call();
  } catch (const Error& error) {
    message = error.what();
  }
  INFO("message: " << message);
  INFO("should say: " << words);
  CHECK(message.find(words) != std::string::npos);
  CHECK(message.find(": ") != std::string::npos);
  CHECK(message.find('\n') == std::string::npos);
}

} // namespace orograph
