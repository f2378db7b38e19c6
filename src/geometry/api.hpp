// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What programs that link to the library may see; all else is hidden in it.
#define OROGRAPH_API __attribute__((visibility("default")))
