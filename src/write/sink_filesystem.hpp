// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "write/byte_sink.hpp"

namespace orograph {

/// A ByteSink as a file that GDAL can write, since its GeoJSON writer doesn't look whether its own
/// writes succeed. As long as it lives, what GDAL writes in this thread to a file in kFolder goes
/// to the sink of the youngest one. Such a file can be written from begin to end and nothing else.
class SinkFilesystem {
public:
  static constexpr const char* kFolder = "/vsiorograph/";

  explicit SinkFilesystem(ByteSink& out);
  ~SinkFilesystem();
  SinkFilesystem(const SinkFilesystem&) = delete;
  SinkFilesystem& operator=(const SinkFilesystem&) = delete;

private:
  ByteSink* before_;
};

} // namespace orograph
