// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_bytes.hpp"
#include "raw.hpp"
#include "selion/core/error.hpp"
#include "selion/core/input_file.hpp"
#include "text.hpp"

namespace selion {
namespace {

RawFile read_stream(std::istream& standard_input) {
  const std::string text = text_of_stream(standard_input, "standard input");
  if (text.empty()) throw InputError{"standard input is empty; give the field as GeoJSON"};
  return read_json(text, "standard input", "field");
}

/// @throws InputError where there is no such file, nothing in it, or no end to it.
void check_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw InputError{path.string() + " does not exist; check the name"};
  refuse_endless(path);
  if (!std::filesystem::is_directory(path, error) && std::filesystem::file_size(path, error) == 0 && !error)
    throw InputError{path.string() + " is empty; export it anew"};
}

/// How the file is read, by its ending; of JSON its first bytes tell more.
enum class Way { text, json, gdal };

Way way_of(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return Way::gdal;
  const std::string ending = lower(path.extension().string());
  const auto is = [&ending](const auto&... endings) { return ((ending == endings) || ...); };
  if (is(".csv", ".txt", ".tsv", ".xyz", ".dat", ".pts")) return Way::text;
  return is(".geojson", ".json") ? Way::json : Way::gdal;
}

}  // namespace

bool is_for_gdal(const std::filesystem::path& path) {
  if (path == "-") return false;
  check_file(path);
  return way_of(path) == Way::gdal;
}

RawFile read_raw(const std::filesystem::path& path, const ReadOptions& options,
                 std::istream& standard_input) {
  if (path == "-") return read_stream(standard_input);
  const std::string label = path.string();
  check_file(path);
  const std::string stem = path.stem().string();
  switch (way_of(path)) {
    case Way::text:
      return read_text(file_bytes(path, label), label, stem, options);
    case Way::json:
      if (const std::string text = file_bytes(path, label); is_geojson(text))
        return read_json(text, label, stem);
      break;
    case Way::gdal:
      break;
  }
  return read_with_gdal(path, label);
}

}  // namespace selion
