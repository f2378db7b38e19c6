// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as a file, and what every reader promises of them.
#pragma once

#include "geometry/error.hpp"
#include "tests/fuzz/fuzz_targets.hpp"
#include "text/printable.hpp"

#include <string>

namespace orograph {

/// A folder of this process's own, in memory where the system has such a place; it goes when the
/// process ends.
const std::string& scratch_folder();

/// The path of a file there that holds the bytes; a later one of the same name takes its place.
std::string scratch_file(const std::string& name, FuzzBytes bytes);

/// Runs a reader, which may refuse what it reads with an Error: one line that says what is wrong
/// and what would be right, once it is printable.
template <class Read>
void read_or_refuse(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    const std::string told = printable(error.what());
    expect(!error.wrong().empty() && !error.right().empty(), "an error without words: " + told);
    expect(told.size() < 20000, "an error of a page: " + told);
  }
}

} // namespace orograph
