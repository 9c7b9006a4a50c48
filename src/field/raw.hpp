// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "selion/field/read.hpp"

namespace selion {

/// What a file holds before anyone knows where on earth it lies: its own coordinates, x (easting, longitude)
/// first.
struct RawPoint {
  double x = 0;
  double y = 0;

  friend bool operator==(const RawPoint&, const RawPoint&) = default;
};
/// As the file has it; closed where its last corner repeats the first.
using RawRing = std::vector<RawPoint>;
/// Shell first, then holes.
using RawPolygon = std::vector<RawRing>;

struct RawFeature {
  int number = 1;       ///< in its layer, from 1
  std::int64_t id = 0;  ///< by which its data set finds it again
  std::vector<RawPolygon> polygons;
  std::vector<std::vector<RawPoint>> lines;
  std::vector<RawPoint> points;
  std::map<std::string, std::string> attributes;
  std::vector<std::string> attribute_order;  ///< keys of `attributes` as the file orders them
  std::vector<std::string> notes;

  [[nodiscard]] bool has_polygons() const { return !polygons.empty(); }
  [[nodiscard]] bool is_empty() const { return polygons.empty() && lines.empty() && points.empty(); }
};

struct RawLayer {
  std::string name;
  std::optional<std::string> crs;  ///< "EPSG:28992" or WKT, as PROJ takes it
  bool crs_is_default = false;  ///< the format's own (WGS84), not said in the file: an option may replace it
  std::vector<RawFeature> features;
};

struct RawFile {
  std::string label;  ///< what messages call it
  std::string stem;   ///< name of fields that have none
  std::vector<RawLayer> layers;
  bool layers_are_folders = false;  ///< KML: read together
  std::vector<std::string> notes;
};

/// A field file with the reader that suits it; "-" is GeoJSON on `standard_input`.
RawFile read_raw(const std::filesystem::path& path, const ReadOptions& options, std::istream& standard_input);
/// Whether GDAL reads it, by its name. @throws InputError where there is no such file, or nothing in it.
bool is_for_gdal(const std::filesystem::path& path);
RawFile read_json(const std::string& bytes, const std::string& label, const std::string& stem);
/// Whether the text is GeoJSON by its first members; other JSON (TopoJSON, Esri) is for GDAL.
bool is_geojson(const std::string& text);
RawFile read_text(const std::string& bytes, const std::string& label, const std::string& stem,
                  const ReadOptions& options);
/// Any file that GDAL reads; zip archives are looked into.
RawFile read_with_gdal(const std::filesystem::path& file, const std::string& label);

/// @throws InputError for entities (they can blow up), ISOXML, and KML coordinates that are no numbers.
/// @returns notes on what was repaired.
std::vector<std::string> check_xml(const std::string& text, const std::string& label);
/// Part of check_xml. @throws InputError for polygons of two outer rings, or of inner ones only: GDAL takes
/// one and says nothing.
void check_kml_rings(std::string_view text, const std::string& label);
/// Walks over the records of a .shp. @throws InputError naming the record that is cut off, too long or not
/// finite.
void check_shapefile(const std::string& bytes, const std::string& label);

std::string as_utf8(const std::string& text, bool& was_latin1);

}  // namespace selion
