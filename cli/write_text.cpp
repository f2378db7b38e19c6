// SPDX-License-Identifier: GPL-3.0-or-later
// A text file, whole.
#include "cli/write_text.hpp"

#include "draw/output_file.hpp"
#include "geometry/error.hpp"

#include <fstream>

namespace orograph {

void write_text(const std::string& text, const std::string& path, bool overwrite) {
  OutputFile place(path, overwrite);
  std::ofstream file(place.temporary_path(), std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file)
    throw Error("can't write '" + path + "'", "make room on the disk, or choose another place");
  place.commit();
}

} // namespace orograph
