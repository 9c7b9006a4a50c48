// SPDX-License-Identifier: GPL-3.0-or-later
#include <iterator>

#include "file_bytes.hpp"
#include "raw.hpp"
#include "selion/core/error.hpp"
#include "text.hpp"

namespace selion {
namespace {

RawFile read_stream(std::istream& standard_input) {
  const std::string text{std::istreambuf_iterator<char>{standard_input}, {}};
  if (text.empty()) throw InputError{"standard input is empty; give the field as GeoJSON"};
  return read_json(text, "standard input", "field");
}

}  // namespace

RawFile read_raw(const std::filesystem::path& path, const ReadOptions& options,
                 std::istream& standard_input) {
  if (path == "-") return read_stream(standard_input);
  const std::string label = path.string();
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw InputError{label + " does not exist; check the name"};
  if (std::filesystem::is_directory(path, error)) return read_with_gdal(path, label);
  if (std::filesystem::file_size(path, error) == 0 && !error)
    throw InputError{label + " is empty; export it anew"};
  const std::string ending = lower(path.extension().string());
  const auto is = [&ending](const auto&... endings) { return ((ending == endings) || ...); };
  const std::string stem = path.stem().string();
  if (is(".csv", ".txt", ".tsv", ".xyz", ".dat", ".pts"))
    return read_text(file_bytes(path, label), label, stem, options);
  if (is(".geojson", ".json")) {
    const std::string text = file_bytes(path, label);
    if (is_geojson(text)) return read_json(text, label, stem);
  }
  return read_with_gdal(path, label);
}

}  // namespace selion
