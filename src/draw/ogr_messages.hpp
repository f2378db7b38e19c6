// SPDX-License-Identifier: GPL-3.0-or-later
// GDAL's messages while a drawing is written.
#pragma once

#include <string>

namespace orograph {

/// As long as it lives, GDAL's messages in this thread come here and not to stderr.
class OgrMessages {
public:
  OgrMessages();
  ~OgrMessages();
  OgrMessages(const OgrMessages&) = delete;
  OgrMessages& operator=(const OgrMessages&) = delete;

  bool has_failure() const { return has_failure_; }
  /// The last failure, or else the last warning, on one line; empty where there was none.
  const std::string& last() const { return last_; }
  void take(bool is_failure, const char* text);

private:
  bool has_failure_ = false;
  std::string last_;
};

} // namespace orograph
