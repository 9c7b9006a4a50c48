// SPDX-License-Identifier: GPL-3.0-or-later
// Broken, tricky and real files that are not part of the project.
#include "test.hpp"

#include <fstream>
#include <map>

#include "field_samples.hpp"
#include "files.hpp"

using namespace selion;

namespace {

const std::filesystem::path kShared = shared_dir() / "fields";

bool absent() {
  if (std::filesystem::exists(kShared / "invalid" / "EXPECTED.tsv")) return false;
  WARN("skipped: no folder of shared fields");
  return true;
}

/// What becomes of a file: an area (all fields together) with perhaps a word of a note, or a word of the
/// error.
struct Outcome {
  double area_m2 = 0;  ///< 0: refused
  std::string word;
};

constexpr double kTShape_m2 = 32980.7;
constexpr double kQuad_m2 = 14666;
constexpr double kPonds_m2 = 24627.5;

const std::map<std::string, Outcome>& outcomes() {
  static const std::map<std::string, Outcome> all{
      {"bowtie.geojson", {0, "crosses itself near 168.97018"}},
      {"figure8_touch_vertex.geojson", {7332.9, "touches itself"}},
      {"dup_points.geojson", {kTShape_m2, "dropped"}},
      {"near_dup_points.geojson", {kTShape_m2, "dropped"}},
      {"collinear_points.geojson", {kQuad_m2, ""}},
      {"unclosed_ring.geojson", {kTShape_m2, "not closed"}},
      {"wrong_winding.geojson", {kPonds_m2, ""}},
      {"hole_touches_shell_at_point.geojson", {14204.2, ""}},
      {"hole_touches_shell_edge_midspan.geojson", {14204, "reaches out"}},
      {"hole_shares_shell_edge.geojson", {13241.2, "notch"}},
      {"hole_outside.geojson", {0, "outside"}},
      {"hole_partly_outside.geojson", {0, "outside"}},
      {"hole_equals_shell.geojson", {0, "zero area"}},
      {"holes_overlap.geojson", {0, "another hole"}},
      {"hole_in_hole.geojson", {0, "another hole"}},
      {"holes_touch_each_other.geojson", {12025.8, ""}},
      {"tiny_hole_1m2.geojson", {14665, ""}},
      {"multipolygon_nested.geojson", {0, "part 2 shares"}},
      {"multipolygon_overlap.geojson", {0, "part 2 shares"}},
      {"multipolygon_shared_edge.geojson", {kQuad_m2, "joined"}},
      {"zero_area_line.geojson", {0, "3 positions"}},
      {"zero_area_collinear.geojson", {0, "zero area"}},
      {"point_repeated.geojson", {0, "zero area"}},
      {"too_few_positions.geojson", {8778.1, "not closed"}},
      {"spike.geojson", {kQuad_m2, "spike"}},
      {"micro_field_1m2.geojson", {0.9459, ""}},
      {"swapped_latlon_detectable.geojson", {0, "swapped"}},
      {"swapped_latlon_silent.geojson", {58288, ""}},
      {"projected_no_crs.geojson", {0, "--crs"}},
      {"legacy_crs_member_28992.geojson", {60009.4, ""}},
      {"legacy_crs_member_crs84.geojson", {kTShape_m2, ""}},
      {"huge_coordinates.geojson", {0, "outside -90 to 90"}},
      {"overflow_1e400.geojson", {0, "not finite"}},
      {"nan_literal.geojson", {0, "not valid JSON"}},
      {"null_coordinate.geojson", {0, "two numbers"}},
      {"string_coordinates.geojson", {0, "two numbers"}},
      {"one_ordinate.geojson", {0, "two numbers"}},
      {"depth_error.geojson", {0, "brackets"}},
      {"null_geometry.geojson", {kTShape_m2, "skipped"}},
      {"empty_coordinates.geojson", {0, "no polygon"}},
      {"empty_collection.geojson", {0, "no polygon"}},
      {"mixed_types.geojson", {kQuad_m2, "skipped"}},
      {"geometrycollection.geojson", {kQuad_m2, "points"}},
      {"bare_geometry.geojson", {kTShape_m2, ""}},
      {"bare_feature.geojson", {kTShape_m2, ""}},
      {"z_coordinates.geojson", {kTShape_m2, ""}},
      {"zm_4_ordinates.geojson", {kTShape_m2, ""}},
      {"antimeridian_unsplit.geojson", {141564, ""}},
      {"antimeridian_split.geojson", {141564, "joined"}},
      {"polar.geojson", {0, "pole"}},
      {"truncated.geojson", {0, "ends early"}},
      {"empty_file.geojson", {0, "empty"}},
      {"bom_utf8.geojson", {kTShape_m2, ""}},
      {"latin1_name.geojson", {kTShape_m2, "Latin-1"}},
      {"duplicate_features.geojson", {2 * kTShape_m2, "same boundary"}},
      {"overlapping_fields.geojson", {17599.9, "overlaps"}},
      {"not_geojson.geojson", {0, "not valid JSON"}},
      {"deep_nesting.geojson", {0, "nested"}},
      {"shp_missing_prj/field.shp", {0, "--crs EPSG:25832"}},
      {"shp_missing_prj_degrees/field.shp", {0, "--crs EPSG:4326"}},
      {"shp_wrong_prj_says_wgs84/field.shp", {0, "outside -90 to 90"}},
      {"shp_empty_prj/field.shp", {0, "--crs EPSG:25832"}},
      {"shp_missing_dbf/field.shp", {kTShape_m2, ".dbf is missing"}},
      {"shp_missing_shx/field.shp", {kTShape_m2, ".shx is missing"}},
      {"shp_empty_layer/field.shp", {0, "no polygon"}},
      {"shp_null_shape/field.shp", {kTShape_m2, "skipped"}},
      {"shp_linestring/field.shp", {0, "only lines"}},
      {"shp_polygonz/field.shp", {kTShape_m2, ""}},
      {"shp_truncated/field.shp", {0, "truncated"}},
      {"shp_bad_record_length/field.shp", {0, "feature 1 claims"}},
      {"shp_nan_vertex/field.shp", {0, "not a finite number"}},
      {"shp_no_orientation_hole_first/field.shp", {kTShape_m2, ""}},
      {"empty_layer.gpkg", {0, "no polygon"}},
      {"two_layers.gpkg", {0, "'fields', 'old_fields'"}},
      {"undefined_srs.gpkg", {0, "no CRS"}},
      {"curve_polygon_pivot.gpkg", {125763, ""}},
      {"ok_field.kml", {kTShape_m2, ""}},
      {"kml_space_after_comma.kml", {kTShape_m2, "blanks"}},
      {"kml_unclosed.kml", {kTShape_m2, "not closed"}},
      {"kml_latlon_order.kml", {0, "latitude 168.97"}},
      {"kml_only_path.kml", {0, "line around an area"}},
      {"kml_entity_bomb.kml", {0, "entities"}},
      {"gml_4326_latlon.gml", {kTShape_m2, ""}},
      {"gml_4326_wrong_axis_lonlat.gml", {0, "latitude 168.97"}},
      {"isoxml_unclosed_ring.xml", {0, "not supported yet"}},
      {"isoxml_hole_before_shell.xml", {0, "not supported yet"}},
      {"isoxml_pfd_without_pln.xml", {0, "not supported yet"}},
      {"isoxml_lat_lon_range.xml", {0, "not supported yet"}},
      {"real/sk_ring_self_intersection.geojson", {147246, "touches itself"}},
      {"real/isoxml_two_exteriors_one_pln.xml", {0, "not supported yet"}},
      {"real/isoxml_5_pfd_no_boundary.xml", {0, "not supported yet"}},
      {"real/be_wal_3035_with_envelope_feature.gml", {197599, "100 km"}},
      {"real/lem_no_prj/LEM_dataset.shp", {0, "--crs EPSG:4326"}},
  };
  return all;
}

/// All fields of a file: their area, every note, and whether each block is clean.
double read_whole(const std::filesystem::path& file, const ReadOptions& options,
                  std::vector<std::string>& notes) {
  double sum_m2 = 0;
  for (const Field& field : read_file(file, options)) {
    const Blocks blocks = blocks_of(field);
    notes.insert(notes.end(), field.notes.begin(), field.notes.end());
    notes.insert(notes.end(), blocks.notes.begin(), blocks.notes.end());
    for (const Block& block : blocks.blocks) {
      CAPTURE(field.source, block.number);
      CHECK(fault(block.area) == "");
      CHECK(fault(block.free) == "");
      sum_m2 += area_m2(block.area);
    }
  }
  return sum_m2;
}

}  // namespace

TEST_CASE("every broken or tricky file ends as described", "[field][shared]") {
  if (absent()) return;
  std::ifstream table{kShared / "invalid" / "EXPECTED.tsv"};
  std::size_t seen = 0;
  std::string line;
  for (std::getline(table, line); std::getline(table, line);) {
    const std::string name = line.substr(0, line.find('\t'));
    CAPTURE(line);
    ++seen;
    const auto found = outcomes().find(name);
    REQUIRE(found != outcomes().end());
    const Outcome& outcome = found->second;
    std::vector<std::string> notes;
    double sum_m2 = 0;
    const std::string message = error_of([&] { sum_m2 = read_whole(kShared / "invalid" / name, {}, notes); });
    CAPTURE(message);
    if (outcome.area_m2 == 0) {
      CHECK(mentions(message, outcome.word));
      CHECK(mentions(message, name));
    } else {
      CHECK(message == "");
      CHECK(sum_m2 == Approx(outcome.area_m2).epsilon(1e-4));
      CHECK((outcome.word.empty() || any_mentions(notes, outcome.word)));
    }
  }
  CHECK(seen == outcomes().size());
}

TEST_CASE("a CRS given by hand makes the files without one readable", "[field][shared]") {
  if (absent()) return;
  std::vector<std::string> notes;
  ReadOptions options;
  options.crs = "EPSG:25832";
  CHECK(read_whole(kShared / "invalid/shp_missing_prj/field.shp", options, notes) ==
        Approx(kTShape_m2).epsilon(1e-4));
  options.crs = "EPSG:4326";
  CHECK(read_file(kShared / "invalid/real/lem_no_prj/LEM_dataset.shp", options).size() == 195);
}

TEST_CASE("the public fields have the areas that their table says", "[field][shared]") {
  if (absent()) return;
  std::size_t compared = 0;
  std::ifstream table{kShared / "public" / "README.md"};
  for (std::string line; std::getline(table, line);) {
    if (!line.starts_with("| ")) continue;
    std::vector<std::string> cells;
    for (std::size_t from = 2; from < line.size();) {
      const std::size_t end = std::min(line.find(" | ", from), line.size());
      cells.push_back(line.substr(from, end - from));
      from = end + 3;
    }
    const std::filesystem::path file = kShared / "public" / (cells.front() + ".geojson");
    if (cells.size() < 10 || !std::filesystem::exists(file)) continue;
    CAPTURE(cells.front());
    std::vector<std::string> notes;
    const double area_ha = std::stod(cells[3]);
    CHECK(read_whole(file, {}, notes) / 1e4 ==
          Approx(area_ha).epsilon(2e-3).margin(6e-4));  // planar UTM, three decimals
    ++compared;
  }
  CHECK(compared >= 30);
}

TEST_CASE("original files are read in their own CRS", "[field][shared]") {
  if (absent()) return;
  struct Original {
    std::string file;
    std::size_t fields;
    double area_ha;
  };
  for (const auto& [file, fields, area_ha] :
       {Original{"original/de_sh_feldbloecke_100_epsg4647.gpkg", 100, 502.8},
        Original{"original/nl_brp2023_100.gpkg", 100, 63.23},
        Original{"original/se_2023_shapefile/arslager_skiftePolygon.shp", 10, 20.3},
        Original{"adjacent_block_nl.geojson", 13, 38.74}, Original{"two_fields_converted.kml", 2, 5.757}}) {
    CAPTURE(file);
    std::vector<std::string> notes;
    CHECK(read_whole(kShared / "public" / file, {}, notes) / 1e4 == Approx(area_ha).epsilon(2e-3));
    CHECK(read_file(kShared / "public" / file).size() == fields);
  }
}
