// SPDX-License-Identifier: GPL-3.0-or-later
// A GDAL error handler that keeps one message.
#include "draw/ogr_messages.hpp"

#include <cpl_error.h>

#include <algorithm>
#include <string_view>

namespace orograph {
namespace {

void keep(CPLErr level, CPLErrorNum, const char* text) {
  if (level >= CE_Warning)
    static_cast<OgrMessages*>(CPLGetErrorHandlerUserData())->take(level >= CE_Failure, text);
}

} // namespace

OgrMessages::OgrMessages() {
  CPLPushErrorHandlerEx(keep, this);
  CPLErrorReset();
}

OgrMessages::~OgrMessages() {
  CPLPopErrorHandler();
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

} // namespace orograph
