// SPDX-License-Identifier: GPL-3.0-or-later
// Owners' files of every kind that can be planned.
#include "test.hpp"

#include <filesystem>
#include <fstream>

#include "field/gdal_library.hpp"
#include "field_samples.hpp"
#include "selion/core/error.hpp"
#include "selion/core/format.hpp"
#include "verify_samples.hpp"

using namespace selion;

namespace {

namespace fs = std::filesystem;

/// By GDAL, out of archives and into them.
void copy_file(const std::string& from, const std::string& to) {
  REQUIRE(reinterpret_cast<int (*)(const char*, const char*)>(gdal_function("CPLCopyFile"))(
              to.c_str(), from.c_str()) == 0);
}

/// An archive beside that file, of files and their names in it.
fs::path archive(const fs::path& beside, const std::string& name,
                 const std::vector<std::pair<std::string, std::string>>& files) {
  const fs::path zip = beside.parent_path() / "made.zip";
  void* open = reinterpret_cast<void* (*)(const char*, const char*)>(gdal_function("VSIFOpenL"))(
      ("/vsizip/" + zip.string()).c_str(), "wb");
  for (const auto& [file, inside] : files) copy_file(file, "/vsizip/" + zip.string() + "/" + inside);
  reinterpret_cast<int (*)(void*)>(gdal_function("VSIFCloseL"))(open);
  fs::rename(zip, beside.parent_path() / name);
  return beside.parent_path() / name;
}

std::string of_shapefile(const std::string& ending) {
  return "/vsizip/{" + sample_file("f1.zip").string() + "}/f1" + ending;
}

std::string text_of(const PlanFile& plan, const GivenField& given) { return text_of(verify(plan, given)); }

/// 71 m by 78 m with a hole.
const std::string kSquare =
    "10 50\n10.001 50\n10.001 50.0007\n10 50.0007\n\n10.0004 50.0003\n10.0006 50.0003\n10.0006 50.0004\n";

PlanFile square_plan() {
  const TemporaryFile file{"square.csv", kSquare};
  return written(read_file(file.path()).at(0), "");
}

std::string text_of(const PlanFile& plan, const std::string& text, GivenField given) {
  const TemporaryFile file{"square.csv", text};
  given.file = file.path();
  return text_of(plan, given);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

}  // namespace

TEST_CASE("a plan is held against coordinates as text, however they are written", "[verify][files]") {
  const PlanFile plan = square_plan();
  const std::string backwards =
      "50 10\n50 10.001\n50.0007 10.001\n50.0007 10\n\n50.0003 10.0004\n50.0003 10.0006\n50.0004 10.0006\n";
  for (const std::string& text :
       {kSquare, replaced(kSquare, " ", ", "), replaced(kSquare, " ", "\t"), replaced(kSquare, " ", "   +"),
        replaced(replaced(kSquare, " ", ";"), ".", ","), replaced(kSquare, " ", "\xC2\xB0; "),
        "# by GPS\n" + replaced(kSquare, "01\n", "01 # m\n# n\n"),
        "Lon (x), LAT\n" + replaced(kSquare, " ", ", "), "\xEF\xBB\xBF" + replaced(kSquare, "\n", "\r\n"),
        replaced(kSquare, " ", " N"), "id lat lng\n" + replaced("\n" + backwards, "\n50", "\n7 50").substr(1),
        replaced(backwards, " ", "N, ")}) {
    CAPTURE(text);
    CHECK(text_of(plan, text, {}) == "");
  }
  CHECK(text_of(plan, backwards, {.file = {}, .order = TextOrder::latlon}) == "");
  CHECK_THAT(text_of(plan, backwards, {}), Catch::StartsWith("given_field"));
  CHECK_THAT(text_of(plan, kSquare.substr(0, kSquare.find("\n\n")), {}), Catch::StartsWith("given_left_out"));
  CHECK_THROWS_WITH(text_of(plan, kSquare + "10 fifty\n", {}), Catch::Contains("line 9"));
  CHECK_THROWS_WITH(text_of(plan, kSquare + "-10W 50N\n", {}), Catch::Contains("line 9"));
  CHECK_THROWS_WITH(text_of(plan, "", {}), Catch::Contains("no coordinates"));
}

TEST_CASE("a file's coordinate system is its own or the option's, never a guess", "[verify][files]") {
  const PlanFile plan = square_plan();
  const std::string metres =
      "571666.448 5539109.815\n571738.113 5539110.774\n571737.071 5539188.601\n571665.407 5539187.642\n\n"
      "571694.667 5539143.553\n571709.000 5539143.745\n571708.852 5539154.863\n";  // by PROJ's cs2cs
  CHECK(text_of(plan, metres, {.file = {}, .crs = "EPSG:25832"}) == "");
  CHECK_THAT(text_of(plan, metres, {.file = {}, .crs = "EPSG:25833"}), Catch::StartsWith("given_field"));
  CHECK_THROWS_WITH(text_of(plan, metres, {}), Catch::Contains("--crs"));
  CHECK_THROWS_WITH(text_of(plan, metres, {.file = {}, .crs = "EPSG:0"}), Catch::Contains("EPSG:0"));

  const PlanFile of_f1 = written(sample("f1.geojson"), "");
  const TemporaryFile place{"f1.shp", ""};
  for (const char* ending : {".shp", ".shx", ".dbf"})
    copy_file(of_shapefile(ending), fs::path{place.path()}.replace_extension(ending).string());
  CHECK_THROWS_WITH(text_of(of_f1, GivenField{.file = place.path()}), Catch::Contains("--crs"));
  CHECK(text_of(of_f1, GivenField{.file = place.path(), .crs = "EPSG:4326"}) == "");
  CHECK_THROWS_WITH(text_of(of_f1, GivenField{.file = sample_file("f1.zip"), .crs = "EPSG:25832"}),
                    Catch::Contains("--crs says EPSG:25832"));
  CHECK(text_of(of_f1, GivenField{.file = sample_file("f1.geojson"), .crs = "EPSG:4326"}) == "");
}

TEST_CASE("a shapefile without an index is read, and none is written beside it", "[verify][files]") {
  const TemporaryFile place{"f1.shp", ""};
  for (const char* ending : {".shp", ".dbf", ".prj"})
    copy_file(of_shapefile(ending), fs::path{place.path()}.replace_extension(ending).string());
  CHECK(text_of(written(sample("f1.geojson"), ""), GivenField{.file = place.path()}) == "");
  CHECK_FALSE(fs::exists(fs::path{place.path()}.replace_extension(".shx")));
}

TEST_CASE("archives are looked into, folders and all", "[verify][files]") {
  const TemporaryFile place{"here", ""};
  const fs::path zip =
      archive(place.path(), "f1.zip",
              {{of_shapefile(".shp"), "farm/2026/f1.shp"}, {of_shapefile(".prj"), "farm/2026/f1.prj"}});
  CHECK(text_of(written(sample("f1.geojson"), ""), GivenField{.file = zip}) == "");
  const fs::path kmz = archive(place.path(), "f3.kmz", {{sample_file("f3.kml").string(), "doc.kml"}});
  CHECK(text_of(written(sample("f3.geojson"), ""), GivenField{.file = kmz}) == "");
  CHECK_THROWS_WITH(text_of(square_plan(), GivenField{.file = archive(place.path(), "none.zip", {})}),
                    Catch::Contains("none.zip"));
}

TEST_CASE("blanks beside commas of KML part no positions", "[verify][files]") {
  std::ifstream kml{sample_file("f3.kml")};
  const std::string text{std::istreambuf_iterator<char>{kml}, {}};
  const std::size_t from = text.find("<coordinates>");
  REQUIRE(from != std::string::npos);
  const TemporaryFile spaced{"f3.kml", text.substr(0, from) + replaced(text.substr(from), ",", " , ")};
  CHECK(text_of(written(sample("f3.geojson"), ""), GivenField{.file = spaced.path()}) == "");
}

TEST_CASE("of fields that overlap the one is taken that is most nearly the plan's", "[verify][files]") {
  const Polygon own{{{0, 0}, {80, 0}, {80, 60}, {0, 60}}, {}};
  const Polygon extent{{{-9000, -9000}, {9000, -9000}, {9000, 9000}, {-9000, 9000}}, {}};
  const TemporaryFile file{"farm.geojson",
                           collection_of({feature_of({extent}, "{}"), feature_of({own}, "{}")})};
  CHECK(text_of(written(field_of_metres({own}), ""), GivenField{.file = file.path()}) == "");
}

TEST_CASE("a field is found by its number and by each name that a plan gives it", "[verify][files]") {
  const Polygon near{{{0, 0}, {80, 0}, {80, 60}, {0, 60}}, {}};
  const Polygon far{{{200, 0}, {280, 0}, {280, 60}, {200, 60}}, {}};
  const PlanFile plan = written(field_of_metres({near}), "");
  const auto text = [&](const std::string& properties, const std::string& name) {
    const TemporaryFile file{"farm.geojson",
                             collection_of({feature_of({far}, properties), feature_of({near}, properties)})};
    return text_of(plan, GivenField{.file = file.path(), .name = name});
  };
  for (const char* name : {"2", "home", "home (2)"}) CHECK(text(R"({"name":"home"})", name) == "");
  CHECK(text("{}", "farm 2") == "");
  CHECK_THAT(text("{}", "farm 1"), Catch::StartsWith("given_outside"));
  for (const char* name : {"hom", "home (old)", "home ("})
    CHECK_THAT(text(R"({"name":"home"})", name), Catch::StartsWith("given_field"));
}

TEST_CASE("layers called so hold obstacles, beside the one that is asked for too", "[verify][files]") {
  const auto folder = [](const std::string& name, double from_m, double to_m) {
    const Ring corners{{from_m, from_m}, {to_m, from_m}, {to_m, to_m}, {from_m, to_m}, {from_m, from_m}};
    std::string text;
    for (const LonLat p : polygon_of_metres({corners, {}}).shell)
      text += fixed(p.lon_deg, 9) + "," + fixed(p.lat_deg, 9) + " ";
    return "<Folder><name>" + name + "</name><Placemark><Polygon><outerBoundaryIs><LinearRing><coordinates>" +
           text + "</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></Folder>";
  };
  const TemporaryFile file{"farm.kml", "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>" +
                                           folder("fields", 0, 80) + folder("Water", 30, 40) +
                                           "</Document></kml>"};
  const PlanFile with_pond = written(read_file(file.path()).at(0), "");
  const PlanFile without = written(field_of_metres({{{{0, 0}, {80, 0}, {80, 80}, {0, 80}}, {}}}), "");
  for (const auto& layer : {std::optional<std::string>{}, std::optional<std::string>{"fields"}}) {
    const GivenField given{.file = file.path(), .layer = layer};
    CHECK(text_of(with_pond, given) == "");
    CHECK_THAT(text_of(without, given), Catch::StartsWith("given_obstacle: 100.00 m2"));
  }
  CHECK_THROWS_WITH(text_of(without, GivenField{.file = file.path(), .layer = "barns"}),
                    Catch::Contains("barns"));
}
