// SPDX-License-Identifier: GPL-3.0-or-later
// The files of cli/sweep/page as one text, written into the program when it is built.
#pragma once

#include <string_view>

namespace orograph {

/// HTML with the style and the script in it, and {{table}} and {{previews}}, in this order, where
/// the data goes.
std::string_view sweep_page_template();

} // namespace orograph
