// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "selion/field/field.hpp"

namespace selion {

enum class ColumnType { text, whole, real };

struct TableColumn {
  std::string name;
  ColumnType type = ColumnType::text;
};

/// Of its column's type, or absent.
using TableCell = std::variant<std::monostate, std::string, long long, double>;

/// A GeoPackage of one layer of areas in WGS84, written row by row. Same rows, same bytes: it holds no date.
class GeoPackageTable {
 public:
  /// @throws InputError where the file cannot be written.
  GeoPackageTable(const std::filesystem::path& file, const std::string& layer,
                  const std::vector<TableColumn>& columns);
  GeoPackageTable(const GeoPackageTable&) = delete;
  GeoPackageTable& operator=(const GeoPackageTable&) = delete;
  GeoPackageTable(GeoPackageTable&&) = delete;
  GeoPackageTable& operator=(GeoPackageTable&&) = delete;
  ~GeoPackageTable();

  /// `id`: greater than that of the row before. @throws InputError as the constructor.
  void add(long long id, const std::vector<TableCell>& cells, const std::vector<LonLatPolygon>& area);
  /// All rows are on the disk after it. @throws InputError as the constructor.
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace selion
