// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace orograph {

/// A file of devices/, as it stands there.
struct KnownDevice {
  std::string_view name, toml;
};

std::span<const KnownDevice> known_devices();

} // namespace orograph
