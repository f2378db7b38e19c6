// SPDX-License-Identifier: GPL-3.0-or-later
// GDAL, so far as others need it: datasets that close themselves, and settings and messages of one
// thread. What a program has set in GDAL for itself stays as it is: nothing here holds for the
// whole process, except that drivers get registered, and what `set_gdal_for_this_program` sets.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

class GDALDataset;

namespace orograph {

/// A GDAL dataset that closes itself.
struct CloseDataset {
  void operator()(GDALDataset* dataset) const;
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// As long as it lives, an option of GDAL's has a value in this thread; then it is again what the
/// thread had before.
class GdalThreadOption {
public:
  /// REQUIRES a name that outlives it.
  GdalThreadOption(const char* name, const char* value);
  ~GdalThreadOption();
  GdalThreadOption(const GdalThreadOption&) = delete;
  GdalThreadOption& operator=(const GdalThreadOption&) = delete;

private:
  const char* name_;
  std::optional<std::string> before_;
};

/// As long as one lives, GDAL's messages in this thread are collected here and go nowhere else, and
/// GDAL reads and writes nothing beside the files that this thread opens (.aux.xml), nor changes
/// the locale. Then GDAL's last error in this thread is again the one that the program may still
/// want to ask for. Everything that calls GDAL does so while one lives; several may, one inside the
/// other, and the innermost one collects. The first one in a process registers GDAL's drivers.
/// Threads that GDAL starts by itself (an open option NUM_THREADS) don't know of it: what they say
/// goes to the program's own handler. Where GDAL has no memory, which it takes for a reason to end
/// the process, std::bad_alloc is thrown instead.
class GdalMessages {
public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  bool has_failure() const { return !failures_.empty(); }
  const std::vector<std::string>& failures() const { return failures_; }
  /// In one line; "no reason given" if there was none.
  std::string last_failure() const;
  const std::vector<std::string>& warnings() const { return warnings_; }
  void forget();

  void add_failure(std::string message) { failures_.push_back(std::move(message)); }
  void add_warning(std::string message) { warnings_.push_back(std::move(message)); }

private:
  int last_severity_, last_number_; ///< of GDAL's last error before
  std::string last_text_;
  std::vector<std::string> failures_, warnings_;
  GdalThreadOption nothing_beside_{"GDAL_PAM_ENABLED", "NO"};
  /// Which sets the numbers of the process's locale wherever a database is opened.
  GdalThreadOption no_spatialite_{"SPATIALITE_LOAD", "NO"};
};

/// For a program that uses GDAL through us alone, to be called at its beginning: GDAL's cache has
/// 32 MB, since a DEM is read once, block by block, and more would only be memory that the drawing
/// doesn't get; what GDAL says in threads of its own isn't heard instead of going to stderr; and
/// where it has no memory, std::bad_alloc is thrown.
void set_gdal_for_this_program();

} // namespace orograph
