// SPDX-License-Identifier: GPL-3.0-or-later
#include "table.hpp"

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "folder.hpp"
#include "selion/core/error.hpp"
#include "selion/core/format.hpp"
#include "selion/core/units.hpp"
#include "selion/field/geopackage.hpp"

namespace selion {
namespace {

namespace fs = std::filesystem;

struct Column {
  const char* name;
  ColumnType type;
  int decimals;
  TableCell (*cell)(const BatchResult&);
};

TableCell text(const std::string& value) {
  if (value.empty()) return std::monostate{};
  return value;
}

/// Of a figure that only plans have.
template <class Get>
TableCell figure(const BatchResult& result, const Get& get) {
  if (!result.figures) return std::monostate{};
  return get(*result.figures);
}

TableCell percent(const BatchResult& result, double BatchFigures::*part) {
  if (!result.figures || !result.area_m2 || *result.area_m2 <= 0) return std::monostate{};
  return 100 * (*result.figures.*part) / *result.area_m2;
}

using Row = const BatchResult&;

constexpr auto kColumns = std::to_array<Column>({
    {"number", ColumnType::whole, 0, [](Row r) -> TableCell { return static_cast<long long>(r.number); }},
    {"file", ColumnType::text, 0, [](Row r) { return text(r.file); }},
    {"layer", ColumnType::text, 0, [](Row r) { return text(r.layer); }},
    {"feature", ColumnType::whole, 0,
     [](Row r) -> TableCell {
       if (!r.feature) return std::monostate{};
       return static_cast<long long>(*r.feature);
     }},
    {"name", ColumnType::text, 0, [](Row r) { return text(r.name); }},
    {"status", ColumnType::text, 0,
     [](Row r) { return text(std::string{kBatchStatusNames.at(static_cast<std::size_t>(r.status))}); }},
    {"reason", ColumnType::text, 0, [](Row r) { return text(r.reason); }},
    {"area_ha", ColumnType::real, 4,
     [](Row r) -> TableCell {
       if (!r.area_m2) return std::monostate{};
       return hectares_of_m2(*r.area_m2);
     }},
    {"covered_percent", ColumnType::real, 2, [](Row r) { return percent(r, &BatchFigures::covered_m2); }},
    {"worked_twice_percent", ColumnType::real, 2,
     [](Row r) { return percent(r, &BatchFigures::worked_twice_m2); }},
    {"swaths", ColumnType::whole, 0,
     [](Row r) {
       return figure(r, [](const BatchFigures& f) -> TableCell { return static_cast<long long>(f.swaths); });
     }},
    {"passes", ColumnType::whole, 0,
     [](Row r) {
       return figure(r, [](const BatchFigures& f) -> TableCell { return static_cast<long long>(f.passes); });
     }},
    {"length_m", ColumnType::real, 1,
     [](Row r) { return figure(r, [](const BatchFigures& f) -> TableCell { return f.length_m; }); }},
    {"duration_s", ColumnType::real, 1,
     [](Row r) { return figure(r, [](const BatchFigures& f) -> TableCell { return f.duration_s; }); }},
    {"verified", ColumnType::text, 0, [](Row r) { return text(r.verified); }},
    {"plan", ColumnType::text, 0, [](Row r) { return text(r.plan); }},
});

std::string quoted(const std::string& value) {
  if (value.find_first_of("\",\r\n") == std::string::npos) return value;
  std::string out = "\"";
  for (const char c : value) {
    out += c;
    if (c == '"') out += '"';
  }
  return out + '"';
}

std::string csv_cell(const Column& column, const TableCell& cell) {
  if (const auto* words = std::get_if<std::string>(&cell)) return quoted(*words);
  if (const auto* whole = std::get_if<long long>(&cell)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&cell)) return fixed(*real, column.decimals);
  return "";
}

std::string csv_header() {
  std::string line;
  for (const Column& column : kColumns) line += (line.empty() ? "" : ",") + std::string{column.name};
  return line + "\n";
}

std::string csv_line(const BatchResult& result) {
  std::string line;
  for (const Column& column : kColumns)
    line += (&column == kColumns.data() ? "" : ",") + csv_cell(column, column.cell(result));
  return line + "\n";
}

/// What the CSV says: the two tables are to agree to the last digit.
TableCell rounded(const Column& column, TableCell cell) {
  if (const auto* real = std::get_if<double>(&cell)) {
    const double scale = std::pow(10, column.decimals);
    return std::round(*real * scale) / scale;
  }
  return cell;
}

std::vector<TableColumn> table_columns() {
  std::vector<TableColumn> columns;
  columns.reserve(kColumns.size());
  for (const Column& column : kColumns) columns.push_back({column.name, column.type});
  return columns;
}

std::vector<TableCell> cells_of(const BatchResult& result) {
  std::vector<TableCell> cells;
  cells.reserve(kColumns.size());
  for (const Column& column : kColumns) cells.push_back(rounded(column, column.cell(result)));
  return cells;
}

}  // namespace

void write_tables(const fs::path& folder, const fs::path& part_folder, const EachResult& each) {
  const fs::path csv_part = part_folder / kBatchTables[0];
  const fs::path gpkg_part = part_folder / kBatchTables[1];
  std::error_code ignored;
  fs::remove(gpkg_part, ignored);
  std::ofstream csv{csv_part, std::ios::binary | std::ios::trunc};
  GeoPackageTable geopackage{gpkg_part, "results", table_columns()};
  csv << csv_header();
  each([&](const BatchResult& result) {
    csv << csv_line(result);
    geopackage.add(static_cast<long long>(result.number), cells_of(result), result.boundary);
  });
  csv.close();
  if (!csv) throw InputError{(folder / kBatchTables[0]).string() + " cannot be written; is the disk full?"};
  geopackage.close();
  put_in_place(csv_part, folder / kBatchTables[0]);
  put_in_place(gpkg_part, folder / kBatchTables[1]);
}

}  // namespace selion
