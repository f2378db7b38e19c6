// SPDX-License-Identifier: GPL-3.0-or-later
// Small sweeps by the built program, and what they leave in their folders.
#pragma once

#include "tests/cli/made_files.hpp"
#include "tests/cli/run_program.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace orograph {

using Words = std::vector<std::string>;

/// At spaces.
Words words(const std::string& text);
Words operator+(Words a, const Words& b);

/// A small hill, `hill.asc`, of 24 x 24 vertices 10 m apart from (0, 0) to (240, 240), 90 to 310 m
/// high; `fine.asc`, the same in 120 x 120 for views that take longer; `other.asc`, a vertex of the
/// first one 1 m higher; `utm.asc`, the first in UTM zone 32.
void make_terrains(const MadeFolder& folder);

/// A page that is quick to draw on.
extern const Words kSmall;

/// `orograph sweep` or another command in the folder.
ProgramRun run(const MadeFolder& folder, const Words& arguments,
               std::optional<std::uint64_t> largest_file_bytes = {});
/// The same, which must end with 0.
void run_well(const MadeFolder& folder, const Words& arguments);

/// Bytes by path of all files under a folder of `folder`.
std::map<std::string, std::string> contents(const MadeFolder& folder, const std::string& name);

/// Which paths differ, or are in one alone; empty where both are the same.
std::string differences(const std::map<std::string, std::string>& a,
                        const std::map<std::string, std::string>& b);

/// Tells a file from one that was written in its place.
struct FileIdentity {
  std::uint64_t inode = 0, size = 0;
  std::int64_t changed_ns = 0;
  bool operator==(const FileIdentity&) const = default;
};
std::map<std::string, FileIdentity> identities(const MadeFolder& folder, const std::string& name);

/// A GeoJSON file with a LineString in the plane's coordinates, which are beyond degrees.
std::string line_text(const std::string& coordinates);

} // namespace orograph
