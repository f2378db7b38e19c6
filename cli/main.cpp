// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.hpp"

int main(int argc, char** argv) {
  return orograph::run_command_line(argc, argv);
}
