// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/sink_filesystem.hpp"

#include <cpl_vsi.h>

#include <cstdio>
#include <string_view>

namespace orograph {
namespace {

thread_local ByteSink* current_sink = nullptr;

ByteSink* sink_of(void* file) {
  return static_cast<ByteSink*>(file);
}

void* open_sink(void*, const char*, const char* access) {
  return access[0] == 'w' ? current_sink : nullptr;
}

// GDAL looks whether the file is there before it creates it.
int find_no_file(void*, const char*, VSIStatBufL*, int) {
  return -1;
}

std::size_t write_to_sink(void* file, const void* data, std::size_t size, std::size_t count) {
  const std::string_view bytes(static_cast<const char*>(data), size * count);
  return sink_of(file)->append(bytes) ? count : 0;
}

vsi_l_offset position(void* file) {
  return sink_of(file)->size();
}

int seek_nowhere(void* file, vsi_l_offset offset, int whence) {
  const vsi_l_offset end = position(file);
  return (whence == SEEK_SET ? offset : end + offset) == end ? 0 : -1;
}

int leave_open(void*) {
  return 0;
}

void install() {
  VSIFilesystemPluginCallbacksStruct* const callbacks = VSIAllocFilesystemPluginCallbacksStruct();
  callbacks->stat = find_no_file;
  callbacks->open = open_sink;
  callbacks->tell = position;
  callbacks->seek = seek_nowhere;
  callbacks->write = write_to_sink;
  callbacks->flush = leave_open;
  callbacks->close = leave_open;
  VSIInstallPluginHandler(SinkFilesystem::kFolder, callbacks);
  VSIFreeFilesystemPluginCallbacksStruct(callbacks);
}

} // namespace

SinkFilesystem::SinkFilesystem(ByteSink& out) : before_(current_sink) {
  static const bool installed = (install(), true);
  static_cast<void>(installed);
  current_sink = &out;
}

SinkFilesystem::~SinkFilesystem() {
  current_sink = before_;
}

} // namespace orograph
