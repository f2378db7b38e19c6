// SPDX-License-Identifier: GPL-3.0-or-later
// What files make GDAL open besides themselves: other files, and servers. A DEM that somebody sent
// isn't to tell them who opens it, nor to reach what only this machine can.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {

/// Whether GDAL would ask a server for what has this name: a URL, /vsicurl/ and its kin, a
/// database's or a service's prefix such as PG: or WMS:, or the XML that describes a service.
bool is_on_network(std::string_view name);

/// As long as it lives, GDAL asks no server in this thread, unless `is_allowed` or one of the
/// inputs is itself on the network. Of GDAL's parts that don't keep to that, databases and netCDF,
/// the names in VRTs are looked at before anything is opened.
class NetworkGate {
public:
  /// Throws Error where one of the inputs names something on the network that it mayn't ask.
  NetworkGate(const std::vector<std::string>& inputs, bool is_allowed);
  ~NetworkGate();
  NetworkGate(const NetworkGate&) = delete;
  NetworkGate& operator=(const NetworkGate&) = delete;

  /// About files outside of the folder of the VRT that names them.
  const std::vector<std::string>& doubts() const { return doubts_; }

private:
  struct Closed;
  std::unique_ptr<Closed> closed_; ///< null: it is open
  std::vector<std::string> doubts_;
};

} // namespace orograph
