// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/record.hpp"

#include "cli/text_file.hpp"
#include "geometry/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string_view>

namespace orograph {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Cell& cell) {
  return std::visit(
      [](const auto& value) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
          return nullptr;
        else
          return value;
      },
      cell);
}

Json row_json(const std::vector<Column>& columns, const std::vector<Cell>& row) {
  Json json = Json::object();
  for (std::size_t i = 0; i < columns.size(); ++i) json[columns[i].name] = json_of(row[i]);
  return json;
}

Json json_of(const Preview& preview) {
  Json json{{"size_mm", {preview.width_mm, preview.height_mm}}, {"layers", Json::array()}};
  for (const PreviewLayer& layer : preview.layers)
    json["layers"].push_back({{"name", layer.name},
                              {"pen_mm", layer.pen_mm},
                              {"grey", layer.grey},
                              {"path", layer.path}});
  return json;
}

std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<Cell> cell_of(const Json& json) {
  if (json.is_null()) return Cell();
  if (json.is_number_integer()) return Cell(json.get<std::int64_t>());
  if (json.is_number()) return Cell(json.get<double>());
  if (json.is_string()) return Cell(json.get<std::string>());
  return std::nullopt;
}

// Only where all columns are there, in their order.
std::optional<std::vector<Cell>> row_of(const Json& json, const std::vector<Column>& columns) {
  if (!json.is_object() || json.size() != columns.size()) return std::nullopt;
  std::vector<Cell> row;
  for (const auto& [name, value] : json.items()) {
    const auto cell = cell_of(value);
    if (!cell || name != columns[row.size()].name) return std::nullopt;
    row.push_back(*cell);
  }
  return row;
}

// One object, in two lines: what is read by itself needs no search.
constexpr auto kBeforeRow = "{\"row\":", kBetween = ",\n\"preview\":", kAfterPreview = "}\n";

struct RecordParts {
  std::string_view row, preview;
};
std::optional<RecordParts> parts_of(std::string_view text) {
  const std::size_t between = text.find(kBetween);
  if (between == std::string_view::npos || !text.starts_with(kBeforeRow) ||
      !text.ends_with(kAfterPreview))
    return std::nullopt;
  RecordParts parts{text.substr(0, between), text.substr(between)};
  parts.row.remove_prefix(std::string_view(kBeforeRow).size());
  parts.preview.remove_prefix(std::string_view(kBetween).size());
  parts.preview.remove_suffix(std::string_view(kAfterPreview).size());
  return parts;
}

std::string quoted_csv(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

} // namespace

std::string record_path(const std::string& out_dir, const Plan& plan, std::size_t view) {
  return (std::filesystem::path(out_dir) / "rows" / (plan.views[view].name + ".json")).string();
}

void write_record(const std::string& out_dir, const Plan& plan, std::size_t view,
                  const std::vector<Cell>& row, const std::optional<Preview>& preview) {
  write_text(kBeforeRow + dump(row_json(plan.columns, row)) + kBetween +
                 (preview ? dump(json_of(*preview)) : "null") + kAfterPreview,
             record_path(out_dir, plan, view), true);
}

std::optional<ViewRecord> read_record(const std::string& out_dir, const Plan& plan,
                                      std::size_t view) {
  const std::string path = record_path(out_dir, plan, view);
  const auto text = whole_file(path);
  if (!text) return std::nullopt;
  const auto parts = parts_of(*text);
  const auto row =
      parts ? row_of(Json::parse(parts->row, nullptr, /*allow_exceptions=*/false), plan.columns)
            : std::nullopt;
  const bool failed = row && std::holds_alternative<std::string>((*row)[kErrorColumn]);
  if (!row || (*row)[kViewColumn] != Cell(static_cast<std::int64_t>(view)) ||
      (*row)[kNameColumn] != Cell(plan.views[view].name) ||
      (!failed && (*row)[kErrorColumn] != Cell()) || !Json::accept(parts->preview))
    throw Error(path + " is no row of this sweep", "its view has to be drawn again (--resume)");
  return ViewRecord{*row, std::string(parts->preview), failed};
}

std::string csv_line(const std::vector<Cell>& row) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) line += ',';
    if (const auto* text = std::get_if<std::string>(&row[i]))
      line += quoted_csv(*text);
    else if (!std::holds_alternative<std::monostate>(row[i]))
      line += dump(json_of(row[i]));
  }
  return line + "\n";
}

std::string json_row(const std::vector<Column>& columns, const std::vector<Cell>& row) {
  return dump(row_json(columns, row));
}

} // namespace orograph
