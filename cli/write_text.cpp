// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/write_text.hpp"

#include "write/byte_sink.hpp"
#include "write/output_file.hpp"

namespace orograph {

void write_text(const std::string& text, const std::string& path, bool overwrite) {
  OutputFile place(path, overwrite);
  ByteSink out(place.temporary_path(), path);
  out.append(text);
  out.finish();
  place.commit();
}

} // namespace orograph
