// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/scratch_file.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace orograph {
namespace {

namespace fs = std::filesystem;

class ScratchFolder {
public:
  ScratchFolder() {
    const fs::path memory = "/dev/shm";
    std::error_code error;
    const fs::path above =
        ::access(memory.c_str(), W_OK) == 0 ? memory : fs::temp_directory_path(error);
    std::string name = (above / "orograph-fuzz-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw FuzzFinding("no folder can be made: " + name);
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::string& path() const { return path_; }

private:
  std::string path_;
};

} // namespace

const std::string& scratch_folder() {
  static const ScratchFolder folder;
  return folder.path();
}

std::string scratch_file(const std::string& name, FuzzBytes bytes) {
  std::string path = scratch_folder() + "/" + name;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  file.close();
  expect(static_cast<bool>(file), "can't write " + path);
  return path;
}

} // namespace orograph
