// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files in a folder that goes away.
#pragma once

#include "solids/read_scene.hpp"
#include "tests/dem/temp_folder.hpp"

#include <fstream>
#include <string>

namespace orograph {

inline std::string write_file(const TempFolder& folder, const std::string& name,
                              const std::string& text) {
  std::ofstream(folder.file(name), std::ios::binary) << text;
  return folder.file(name);
}

inline SceneFile scene_of(const std::string& text) {
  const TempFolder folder;
  return read_scene(write_file(folder, "scene.toml", text));
}

} // namespace orograph
