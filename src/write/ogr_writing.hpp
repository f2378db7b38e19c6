// SPDX-License-Identifier: GPL-3.0-or-later
// What all writers through OGR share: GDAL's messages and options in this thread alone.
#pragma once

#include "geometry/error.hpp"

#include <memory>
#include <optional>
#include <string>

class GDALDataset;

namespace orograph {

/// As long as it lives, GDAL's messages in this thread come here and go nowhere else. The last
/// error that the program may still want to ask GDAL for is put back.
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
  /// Keeps one of GDAL's messages, a failure or a warning.
  void take(bool is_failure, const char* text);

private:
  int last_;
  int last_number_;
  std::string last_text_;
  bool has_failure_ = false;
  std::string reason_;
};

/// As long as it lives, an option of GDAL's has a value in this thread; then what it had before.
class ThreadOption {
public:
  ThreadOption(const char* name, const char* value);
  ~ThreadOption();
  ThreadOption(const ThreadOption&) = delete;
  ThreadOption& operator=(const ThreadOption&) = delete;

private:
  const char* name_;
  std::optional<std::string> before_;
};

/// The same bytes on any day, and nothing beside the file.
struct WritingOptions {
  ThreadOption date{"OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z"};
  ThreadOption nothing_beside{"GDAL_PAM_ENABLED", "NO"};
};

struct CloseOgrDataset {
  void operator()(GDALDataset* dataset) const;
};
using OgrDataset = std::unique_ptr<GDALDataset, CloseOgrDataset>;

/// A new dataset without layers at `path`; null where the driver fails. Throws Error where this
/// GDAL has no such driver.
OgrDataset create_dataset(const char* driver_name, const std::string& path);

/// That the file called `name` can't be written, and why.
Error gdal_error(const std::string& name, const OgrMessages& messages);

} // namespace orograph
