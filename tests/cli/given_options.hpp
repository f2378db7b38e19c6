// SPDX-License-Identifier: GPL-3.0-or-later
// What `render` makes of options, for tests of them.
#pragma once

#include "cli/options/options.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"

#include <string>
#include <vector>

namespace orograph::given_options {

using Arguments = std::vector<std::string>;

inline Arguments with_names(Arguments options) {
  options.insert(options.end(), {"in.tif", "out.svg"});
  return options;
}

inline RenderSettings given(const Arguments& options) {
  const auto settings = parse_render(with_names(options));
  REQUIRE(settings);
  return *settings;
}

/// The message of the UsageError that these options get, or "accepted".
inline std::string refusal_of(const Arguments& arguments) {
  try {
    parse_render(arguments);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

inline std::string refusal(const Arguments& options) {
  return refusal_of(with_names(options));
}

inline void check_refused(const Arguments& options, const std::string& fragment) {
  const std::string message = refusal(options);
  INFO(options.front() << ": " << message);
  CHECK(message.find(fragment) != std::string::npos);
  CHECK(message.find(": ") != std::string::npos);
  CHECK(message.find('\n') == std::string::npos);
}

} // namespace orograph::given_options
