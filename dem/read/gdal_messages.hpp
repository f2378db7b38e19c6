// SPDX-License-Identifier: GPL-3.0-or-later
// What GDAL says goes into our own messages, never to the terminal.
#pragma once

#include <string>
#include <vector>

namespace orograph {

/// While one lives, GDAL's messages in this thread are collected here. The first one also sets GDAL
/// up for the process: drivers registered, a cache of 32 MB, nothing written beside inputs.
class GdalMessages {
public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  bool has_failure() const { return !failures_.empty(); }
  /// In one line; "no reason given" if there was none.
  std::string last_failure() const;
  const std::vector<std::string>& warnings() const { return warnings_; }
  void forget();

  void add_failure(std::string message) { failures_.push_back(std::move(message)); }
  void add_warning(std::string message) { warnings_.push_back(std::move(message)); }

private:
  std::vector<std::string> failures_, warnings_;
};

} // namespace orograph
