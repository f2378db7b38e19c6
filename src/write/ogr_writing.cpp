// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/ogr_writing.hpp"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <string_view>

namespace orograph {

Dataset create_dataset(const char* driver_name, const std::string& path) {
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  if (driver == nullptr)
    throw Error(fmt::format("GDAL has no {} here", driver_name), "a GDAL that has it",
                ErrorCode::output);
  return Dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
}

Error gdal_error(const std::string& name, const GdalMessages& messages) {
  constexpr std::string_view before_reason = " failed: ";
  std::string reason = messages.has_failure()         ? messages.failures().front()
                       : !messages.warnings().empty() ? messages.warnings().back()
                                                      : "GDAL gives no reason";
  if (const std::size_t found = reason.rfind(before_reason); found != std::string::npos)
    reason.erase(0, found + before_reason.size());
  return {fmt::format("{} can't be written ({})", name, reason),
          "a disk with room for it, and a folder that you may write to"};
}

} // namespace orograph
