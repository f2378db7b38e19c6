// SPDX-License-Identifier: GPL-3.0-or-later
// Views that wait to be drawn.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace orograph {

/// Hands out each view once, to any thread.
class ViewQueue {
public:
  virtual ~ViewQueue() = default;
  /// None where all are handed out, or `stop` was called.
  virtual std::optional<std::size_t> next() = 0;
  /// No more are handed out, to anybody.
  virtual void stop() = 0;
};

/// Of this process alone.
class LocalQueue : public ViewQueue {
public:
  explicit LocalQueue(std::vector<std::size_t> views) : views_(std::move(views)) {}

  std::optional<std::size_t> next() override {
    const std::size_t i = next_.fetch_add(1);
    return i < views_.size() ? std::optional(views_[i]) : std::nullopt;
  }
  void stop() override { next_ = views_.size(); }

private:
  const std::vector<std::size_t> views_;
  std::atomic<std::size_t> next_ = 0;
};

} // namespace orograph
