// SPDX-License-Identifier: GPL-3.0-or-later
// What measuring commands write: rows of measures as a table to read, CSV and JSON, and plots by
// gnuplot, which runs nowhere else.
#pragma once

#include "text/csv_text.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace orograph {

/// A value of a record; none: it isn't known.
using Value = std::variant<std::monostate, bool, double, std::uint64_t, std::string>;
/// Names and values, in order.
using Record = std::vector<std::pair<std::string, Value>>;

/// As in JSON, and in a table of comma-separated values, where what isn't known is empty.
std::string json_text(const Value& value);
std::string csv_value(const Value& value);

/// `1.5` as a value, or that it isn't known.
template <class Optional>
Value known(const Optional& x) {
  return x ? Value(*x) : Value();
}

/// Seconds as milliseconds, with so many decimals.
std::string milliseconds(double seconds, int decimals);

/// A line of names and a line for each record; texts quoted, empty where nothing is known. REQUIRES
/// that all records have the same names.
std::string csv_of(const std::vector<Record>& records);

struct NamedRecords {
  std::string name;
  std::vector<Record> records;
};
/// `"schema": 1`, the program's version, the terrain that was measured, and the lists.
std::string json_of(const std::string& terrain, const std::vector<NamedRecords>& lists);

/// Quoted for gnuplot: nothing inside single quotes has a meaning but they themselves. Control
/// characters are left out.
std::string quoted_for_gnuplot(const std::string& text);

/// Throws Error where gnuplot can't be started, before anything is measured; `what` is what it
/// draws
/// ("the curve").
void check_gnuplot(const std::string& what);

/// Runs a script that writes to `path`, an existing file or a new one. Throws Error where gnuplot
/// fails; `what` as above. REQUIRES `check_gnuplot`.
void run_gnuplot(const std::string& script, const std::string& path, const std::string& what);

} // namespace orograph
