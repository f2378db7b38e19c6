// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/gdal_messages.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>

#include <algorithm>

namespace orograph {
namespace {

std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

void CPL_STDCALL collect(CPLErr severity, CPLErrorNum, const char* message) {
  auto& messages = *static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
  if (severity == CE_Failure || severity == CE_Fatal)
    messages.add_failure(in_one_line(message));
  else if (severity == CE_Warning)
    messages.add_warning(in_one_line(message));
}

void set_up_gdal() {
  GDALAllRegister();
  // A DEM is read once, block by block: more would only be memory that the drawing doesn't get.
  GDALSetCacheMax64(32 << 20);
  CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");
  // GDAL's own threads don't see the collecting handler and would write to stderr.
  CPLSetErrorHandler(CPLQuietErrorHandler);
}

} // namespace

GdalMessages::GdalMessages() {
  static const bool once = (set_up_gdal(), true);
  static_cast<void>(once);
  CPLPushErrorHandlerEx(collect, this);
}

GdalMessages::~GdalMessages() {
  CPLPopErrorHandler();
}

std::string GdalMessages::last_failure() const {
  return failures_.empty() ? "no reason given" : failures_.back();
}

void GdalMessages::forget() {
  failures_.clear();
  warnings_.clear();
}

} // namespace orograph
