// SPDX-License-Identifier: GPL-3.0-or-later
// A grid's heights, shared by all copies of the grid.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace orograph {

/// An array whose copies share their values until one of them is written to, so that a terrain can
/// stand in many frames at the cost of one. Reading from several threads is safe.
template <class T>
class Heights {
public:
  using value_type = T;

  Heights() : Heights(std::vector<T>{}) {}
  Heights(std::initializer_list<T> values) : Heights(std::vector<T>(values)) {}
  Heights(std::vector<T> values) : values_(std::make_shared<std::vector<T>>(std::move(values))) {}

  const T& operator[](std::size_t i) const { return (*values_)[i]; }
  std::size_t size() const { return values_->size(); }
  const T* data() const { return values_->data(); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }
  bool operator==(const Heights& other) const {
    return std::equal(begin(), end(), other.begin(), other.end());
  }

  /// To be written to: copied first, if another shares them.
  std::vector<T>& own() {
    if (values_.use_count() > 1) values_ = std::make_shared<std::vector<T>>(*values_);
    return *values_;
  }

private:
  std::shared_ptr<std::vector<T>> values_;
};

} // namespace orograph
