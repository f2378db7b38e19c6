// SPDX-License-Identifier: GPL-3.0-or-later
// What the library and the tables of options say, in the words of Python.
#pragma once

#include <string>

namespace orograph {

/// The message with the library's fields in backquotes, and the command's options, put as the
/// arguments of the Python functions: "`overview`" and "--fill-voids" become "overview" and
/// "fill_voids". Dashes that are part of other words stay.
std::string in_python(const std::string& message);

} // namespace orograph
