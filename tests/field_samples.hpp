// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "selion/field/block.hpp"
#include "selion/field/read.hpp"

namespace selion {

/// A file in the system's temporary folder, gone with its folder at the end.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, std::string_view content);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path folder_;
  std::filesystem::path path_;
};

std::vector<Field> read_file(const std::filesystem::path& file);
std::vector<Field> read_file(const std::filesystem::path& file, const ReadOptions& options);
/// GeoJSON on standard input.
std::vector<Field> read_stdin(const std::string& geojson);
std::vector<Field> read_stdin(const std::string& geojson, const ReadOptions& options);
/// A field of these parts: shell and holes in metres around 10 E 50 N.
Field field_of_metres(const std::vector<Polygon>& parts);
LonLatPolygon polygon_of_metres(const Polygon& area);
Blocks blocks_of(const Field& field);
double blocks_area_m2(const Field& field);

/// The message of the InputError that the call throws; empty where it throws none.
template <class Call>
std::string error_of(const Call& call);

/// Whether `where` holds `word`, in any case.
bool mentions(const std::string& where, const std::string& word);
bool any_mentions(const std::vector<std::string>& notes, const std::string& word);

/// What is wrong with the area by brute force: rings that cross or touch themselves or each other, edges
/// below 1 mm, wrong winding, holes outside. Empty where nothing is.
std::string fault(const Polygon& area);

}  // namespace selion

#include "selion/core/error.hpp"

template <class Call>
std::string selion::error_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}
