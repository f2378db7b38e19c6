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
  /// The first failure (later ones follow from it), or else the last warning; on one line and
  /// without the SQL statement that met it; empty where there was none.
  const std::string& reason() const { return reason_; }
  void take(bool is_failure, const char* text);

private:
  bool has_failure_ = false;
  std::string reason_;
};

} // namespace orograph
