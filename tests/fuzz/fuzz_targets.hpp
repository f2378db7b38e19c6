// SPDX-License-Identifier: GPL-3.0-or-later
// What is tried with made-up bytes (docs/stability.md): each target is one door by which bytes from
// outside come in, or one stage whose result can be judged.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace orograph {

using FuzzBytes = std::span<const std::uint8_t>;

/// What a target throws where the bytes have shown a fault.
class FuzzFinding : public std::logic_error {
public:
  using logic_error::logic_error;
};

struct FuzzTarget {
  std::string_view name;
  /// Takes any bytes. Throws FuzzFinding, or whatever the code under trial shouldn't have thrown.
  void (*run)(FuzzBytes bytes);
};

/// All targets of this program; those of the command's own readers only where it has the command.
std::span<const FuzzTarget> fuzz_targets();

inline void expect(bool holds, const std::string& what) {
  if (!holds) throw FuzzFinding(what);
}

// Readers, each behind its own door: the bytes are the file.
void fuzz_raster(FuzzBytes bytes);
void fuzz_off(FuzzBytes bytes);
void fuzz_ply(FuzzBytes bytes);
void fuzz_obj(FuzzBytes bytes);
void fuzz_stl(FuzzBytes bytes);
void fuzz_landxml(FuzzBytes bytes);
void fuzz_points(FuzzBytes bytes);
void fuzz_vector(FuzzBytes bytes);
void fuzz_overlay(FuzzBytes bytes);
void fuzz_places(FuzzBytes bytes);
void fuzz_levels(FuzzBytes bytes);
void fuzz_view(FuzzBytes bytes);
void fuzz_view_list(FuzzBytes bytes);
void fuzz_scene(FuzzBytes bytes);
void fuzz_pens(FuzzBytes bytes);
void fuzz_device(FuzzBytes bytes);

// The command's own: none of them is there where a program is linked without it.
[[gnu::weak]] void fuzz_settings(FuzzBytes bytes);
[[gnu::weak]] void fuzz_report(FuzzBytes bytes);
[[gnu::weak]] void fuzz_plan(FuzzBytes bytes);
[[gnu::weak]] void fuzz_rows(FuzzBytes bytes);
[[gnu::weak]] void fuzz_options(FuzzBytes bytes);
[[gnu::weak]] void fuzz_values(FuzzBytes bytes);

/// `clip` against the exact one.
void fuzz_clip(FuzzBytes bytes);
/// What a view of a small lattice shows, against sight through all of its triangles.
void fuzz_pass(FuzzBytes bytes);

// Writers, read back.
void fuzz_svg(FuzzBytes bytes);
void fuzz_hpgl(FuzzBytes bytes);
void fuzz_gcode(FuzzBytes bytes);

} // namespace orograph
