// SPDX-License-Identifier: GPL-3.0-or-later
// A GDAL error handler that keeps one message.
#include "draw/ogr_messages.hpp"

#include <cpl_error.h>

#include <algorithm>

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
  if (has_failure_ && !is_failure) return;
  has_failure_ = has_failure_ || is_failure;
  last_ = text;
  std::ranges::replace(last_, '\n', ' ');
}

} // namespace orograph
