// SPDX-License-Identifier: GPL-3.0-or-later
#include "gdal/gdal.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <gdal_priv.h>

#include <algorithm>
#include <new>

namespace orograph {
namespace {

std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

// GDAL ends the process where it has no memory, behind the handler that it tells so: that one
// doesn't come back.
void throw_if_without_memory(CPLErr severity, CPLErrorNum number) {
  if (severity == CE_Fatal && number == CPLE_OutOfMemory) throw std::bad_alloc();
}

void CPL_STDCALL hear_nothing(CPLErr severity, CPLErrorNum number, const char*) {
  throw_if_without_memory(severity, number);
}

void CPL_STDCALL collect(CPLErr severity, CPLErrorNum number, const char* message) {
  throw_if_without_memory(severity, number);
  auto& messages = *static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
  if (severity == CE_Failure || severity == CE_Fatal)
    messages.add_failure(in_one_line(message));
  else if (severity == CE_Warning)
    messages.add_warning(in_one_line(message));
}

} // namespace

void CloseDataset::operator()(GDALDataset* dataset) const {
  GDALClose(dataset);
}

GdalThreadOption::GdalThreadOption(const char* name, const char* value) : name_(name) {
  if (const char* before = CPLGetThreadLocalConfigOption(name, nullptr)) before_ = before;
  CPLSetThreadLocalConfigOption(name, value);
}

GdalThreadOption::~GdalThreadOption() {
  CPLSetThreadLocalConfigOption(name_, before_ ? before_->c_str() : nullptr);
}

// The handler is on the thread's own stack of handlers.
GdalMessages::GdalMessages()
    : last_severity_(CPLGetLastErrorType()), last_number_(CPLGetLastErrorNo()),
      last_text_(CPLGetLastErrorMsg()) {
  static const bool once = (GDALAllRegister(), true);
  static_cast<void>(once);
  CPLPushErrorHandlerEx(collect, this);
}

GdalMessages::~GdalMessages() {
  CPLPopErrorHandler();
  CPLErrorSetState(static_cast<CPLErr>(last_severity_), last_number_, last_text_.c_str());
}

std::string GdalMessages::last_failure() const {
  return failures_.empty() ? "no reason given" : failures_.back();
}

void GdalMessages::forget() {
  failures_.clear();
  warnings_.clear();
}

void set_gdal_for_this_program() {
  GDALSetCacheMax64(32 << 20);
  CPLSetErrorHandler(hear_nothing);
}

} // namespace orograph
