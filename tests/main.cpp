// SPDX-License-Identifier: GPL-3.0-or-later
// Catch2 v2 wants its main once; v3 brings its own.
#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#endif
