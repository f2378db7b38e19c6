// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/ogr_writing.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <new>
#include <string_view>

namespace orograph {

namespace {

void keep_message(CPLErr level, CPLErrorNum number, const char* text) {
  // GDAL would end the process behind this.
  if (level == CE_Fatal && number == CPLE_OutOfMemory) throw std::bad_alloc();
  if (level >= CE_Warning)
    static_cast<OgrMessages*>(CPLGetErrorHandlerUserData())->take(level >= CE_Failure, text);
}

} // namespace

OgrMessages::OgrMessages()
    : last_(CPLGetLastErrorType()), last_number_(CPLGetLastErrorNo()),
      last_text_(CPLGetLastErrorMsg()) {
  CPLPushErrorHandlerEx(keep_message, this);
  CPLErrorReset();
}

OgrMessages::~OgrMessages() {
  CPLPopErrorHandler();
  CPLErrorSetState(static_cast<CPLErr>(last_), last_number_, last_text_.c_str());
}

void OgrMessages::take(bool is_failure, const char* text) {
  constexpr std::string_view before_reason = " failed: ";
  if (has_failure_) return;
  has_failure_ = is_failure;
  reason_ = text;
  if (const std::size_t found = reason_.rfind(before_reason); found != std::string::npos)
    reason_.erase(0, found + before_reason.size());
  std::ranges::replace(reason_, '\n', ' ');
}

ThreadOption::ThreadOption(const char* name, const char* value) : name_(name) {
  if (const char* before = CPLGetThreadLocalConfigOption(name, nullptr)) before_ = before;
  CPLSetThreadLocalConfigOption(name, value);
}

ThreadOption::~ThreadOption() {
  CPLSetThreadLocalConfigOption(name_, before_ ? before_->c_str() : nullptr);
}

void CloseOgrDataset::operator()(GDALDataset* dataset) const {
  GDALClose(dataset);
}

OgrDataset create_dataset(const char* driver_name, const std::string& path) {
  GDALAllRegister();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  if (driver == nullptr)
    throw Error(fmt::format("GDAL has no {} here", driver_name), "a GDAL that has it",
                ErrorCode::output);
  return OgrDataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
}

Error gdal_error(const std::string& name, const OgrMessages& messages) {
  const std::string reason = messages.reason().empty() ? "GDAL gives no reason" : messages.reason();
  return {fmt::format("{} can't be written ({})", name, reason),
          "a disk with room for it, and a folder that you may write to"};
}

} // namespace orograph
