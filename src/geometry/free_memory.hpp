// SPDX-License-Identifier: GPL-3.0-or-later
// How much memory this process may take without hurting others.
#pragma once

#include <cstdint>
#include <optional>

namespace orograph {

/// Bytes that can be had without others' being moved to a disk: as the kernel estimates it for the
/// machine, and no more than this process's container and limit of address space leave. None where
/// neither is told.
std::optional<std::uint64_t> free_memory_bytes();

} // namespace orograph
