// SPDX-License-Identifier: GPL-3.0-or-later
// How much memory this process may take without hurting others.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace orograph {

/// Bytes that can be had without others' being moved to a disk: as the kernel estimates it for the
/// machine, and no more than this process's container and limit of address space leave. None where
/// neither is told.
std::optional<std::uint64_t> free_memory_bytes();

/// Throws an Error where `what` would take more than `most` bytes, if there is such a limit.
/// `right` is what else could be asked for; that more may be allowed (`max_memory`) is added. What
/// a file claims of itself may be more bytes than a whole number holds.
void check_memory(double bytes, std::optional<std::uint64_t> most, std::string_view what,
                  std::string_view right);

} // namespace orograph
