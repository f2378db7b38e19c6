// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the files that the cases of bad_input.txt read. scripts/compare-drawings compiles it, so
// it needs nothing but the standard library. usage: make_bad_inputs FOLDER
#include "tests/cli/bad_inputs.hpp"

#include <filesystem>

namespace fs = std::filesystem;

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const orograph::MadeFolder made;
  orograph::make_bad_inputs(made);
  fs::copy(made.path(), argv[1], fs::copy_options::recursive | fs::copy_options::copy_symlinks);
}
