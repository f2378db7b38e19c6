// SPDX-License-Identifier: GPL-3.0-or-later
// What exact numbers do where there is no memory.
#pragma once

namespace orograph {

/// For a program that uses GMP through us alone, to be called at its beginning: where GMP has no
/// memory, for which it ends the process, std::bad_alloc is thrown instead.
void set_exact_numbers_for_this_program();

} // namespace orograph
