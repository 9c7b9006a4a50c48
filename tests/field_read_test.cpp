// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include "field/gdal_library.hpp"
#include "field_samples.hpp"
#include "files.hpp"

using namespace selion;

namespace {

const std::string kSquare = "[[[10,50],[10.001,50],[10.001,50.001],[10,50.001],[10,50]]]";

std::string feature(const std::string& coordinates, const std::string& properties) {
  return R"({"type":"Feature","properties":)" + properties +
         R"(,"geometry":{"type":"Polygon","coordinates":)" + coordinates + "}}";
}

std::string point(const std::string& at, const std::string& properties) {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":{"type":"Point","coordinates":)" +
         at + "}}";
}

std::string collection(const std::vector<std::string>& features) {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  for (std::size_t i = 0; i < features.size(); ++i) text += (i == 0 ? "" : ",") + features[i];
  return text + "]}";
}

std::string shifted(double by_deg) {
  std::string text = "[[";
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}})
    text += (text.size() > 2 ? ",[" : "[") + std::to_string(10 + by_deg + x * 1e-3) + "," +
            std::to_string(50 + y * 1e-3) + "]";
  return text + "]]";
}

/// Reads this text as coordinates; the field's corners.
LonLatRing corners(const std::string& text, const ReadOptions& options) {
  const TemporaryFile file{"field.csv", text};
  const auto fields = read_file(file.path(), options);
  REQUIRE(fields.size() == 1);
  return fields.front().parts.front().shell;
}

}  // namespace

TEST_CASE("a position that is none is named by ring and coordinate", "[field][read]") {
  const std::string message = error_of(
      [] { read_stdin(R"({"type":"Polygon","coordinates":[[[9,50],[9.1,50],[9.1,null],[9,50]]]})"); });
  CHECK(message ==
        "standard input, part 1, ring 1, coordinate 3: a position needs two numbers, and has [9.1,null]; "
        "correct "
        "the file");
}

TEST_CASE("a file without polygons says what it has instead", "[field][read]") {
  const auto with = [](const std::string& geometry) { return error_of([&] { read_stdin(geometry); }); };
  CHECK(mentions(with(R"({"type":"Point","coordinates":[9,50]})"), "only points"));
  CHECK(mentions(with(R"({"type":"LineString","coordinates":[[9,50],[9.1,50]]})"), "only lines"));
  // walked round, but not back to the very first position
  CHECK(mentions(with(R"({"type":"LineString","coordinates":[[9,50],[9.01,50],[9.01,50.01],[9,50.01]]})"),
                 "feature 1 is a line around an area"));
  CHECK(mentions(with(R"({"type":"LineString","coordinates":[[9,50],[9.01,50],[9.02,50],[9.03,50]]})"),
                 "only lines"));
}

TEST_CASE("thousands of namesakes are numbered without delay", "[field][read]") {
  std::vector<std::string> features;
  for (int i = 0; i < 20000; ++i) features.push_back(feature(kSquare, R"({"name":"Hof"})"));
  features.push_back(feature(kSquare, R"x({"name":"Hof (2)"})x"));
  ReadOptions options;
  options.field = "20000";
  CHECK(read_stdin(collection(features), options).front().name == "Hof (20000)");
  options.field = "20001";
  CHECK(read_stdin(collection(features), options).front().name == "Hof (2) (2)");
}

TEST_CASE("fields are named by their attributes, and namesakes are numbered", "[field][read]") {
  const auto fields = read_stdin(
      collection({feature(kSquare, R"({"NAME":"Hof"})"), feature(shifted(0.01), R"({"name":"Hof"})"),
                  feature(shifted(0.02), R"({"id":7})"), feature(shifted(0.03), "{}")}));
  REQUIRE(fields.size() == 4);
  CHECK(fields[0].name == "Hof");
  CHECK(fields[1].name == "Hof (2)");
  CHECK(fields[2].name == "7");
  CHECK(fields[3].name == "field 4");
  CHECK(fields[3].number == 4);
  CHECK(fields[0].attributes.at("NAME") == "Hof");
  CHECK(fields[0].source_crs == "OGC:CRS84 (WGS 84 (CRS84))");
  CHECK(fields[0].datum == "World Geodetic System 1984");
  CHECK(fields[0].datum_accuracy_m == 0.0);
}

TEST_CASE("one field is chosen by name or number, and a wrong name lists the nearest", "[field][read]") {
  const std::string file =
      collection({feature(kSquare, R"({"name":"Long acre"})"), feature(shifted(0.01), R"({"name":"Mill"})")});
  ReadOptions options;
  options.field = "Mill";
  REQUIRE(read_stdin(file, options).size() == 1);
  CHECK(read_stdin(file, options).front().number == 2);
  options.field = "1";
  CHECK(read_stdin(file, options).front().name == "Long acre");
  options.field = "Mil";
  CHECK(mentions(error_of([&] { read_stdin(file, options); }), "'Mill', 'Long acre'"));
}

TEST_CASE("features by role become gates and obstacles of the fields beside them", "[field][read]") {
  const auto fields = read_stdin(collection({
      feature(kSquare, "{}"),
      feature(shifted(1), "{}"),
      point("[10.0005,50]", R"({"selion":"gate","name":"north","width_m":6})"),
      point("[10.0005,50.0005]", R"({"selion":"obstacle","radius_m":0.5})"),
      feature("[[[10.0001,50.0001],[10.0002,50.0001],[10.0002,50.0002],[10.0001,50.0001]]]",
              R"({"selion":"water"})"),
  }));
  REQUIRE(fields.size() == 2);
  REQUIRE(fields[0].gates.size() == 1);
  CHECK(fields[0].gates.front().name == "north");
  CHECK(fields[0].gates.front().width_m == 6.0);
  REQUIRE(fields[0].obstacles.size() == 2);
  CHECK(fields[0].obstacles[0].area.shell.size() == 16);
  CHECK(fields[0].obstacles[1].kind == ObstacleKind::water);
  CHECK(fields[1].gates.empty());
  CHECK(fields[1].obstacles.empty());
}

TEST_CASE("a pole without a radius, a gate with an area and an unknown role are errors", "[field][read]") {
  const auto error = [](const std::string& extra) {
    return error_of([&] { read_stdin(collection({feature(kSquare, "{}"), extra})); });
  };
  CHECK(mentions(error(point("[10,50]", R"({"selion":"obstacle"})")), "radius_m"));
  CHECK(mentions(error(point("[10,50]", R"({"selion":"obstacle","radius_m":"wide"})")), "'wide'"));
  CHECK(mentions(error(feature(kSquare, R"({"selion":"gate"})")), "gate"));
  CHECK(mentions(error(point("[10,50]", R"({"selion":"tree"})")), "'tree'"));
}

TEST_CASE("gates and obstacles come from files of their own too", "[field][read]") {
  const TemporaryFile gates{"g.geojson", collection({point("[10.0005,50]", R"({"name":"A"})")})};
  const TemporaryFile poles{"p.geojson", collection({point("[10.0005,50.0005]", R"({"radius_m":1})")})};
  ReadOptions options;
  options.gates = gates.path();
  options.obstacles = poles.path();
  const auto fields = read_stdin(feature(kSquare, "{}"), options);
  CHECK(fields.front().gates.size() == 1);
  CHECK(fields.front().obstacles.size() == 1);
}

TEST_CASE("coordinate text is read with any separator, header and hemisphere", "[field][read]") {
  const LonLatRing expected{{9.5, 56.25}, {9.75, 56.25}, {9.75, 56.5}};
  const std::vector<std::string> texts{
      "9.5,56.25\n9.75,56.25\n9.75,56.5\n",
      "# a comment\nlat,lon\n56.25,9.5\n56.25,9.75 # in a line too\n56.5,9.75\n56.25,9.5\n",
      "longitude;latitude;height\n9,5;56,25;12\n9,75;56,25;12\n9,75;56,5;12",
      "9.5\t56.25\r\n9.75\t56.25\r\n9.75\t56.5\r\n",
      "  9.5   56.25\n  9.75  56.25\n  9.75  56.5\n",
      "N 56.25, E 9.5\nN 56.25, E 9.75\nN 56.5, E 9.75\n",
      "id,Latitude [deg],Longitude [deg]\n1,56.25,9.5\n2,56.25,9.75\n3,56.5,9.75\n",
      "\xEF\xBB\xBF\"x\",\"y\"\n\"9.5\",\"56.25\"\n\"9.75\",\"56.25\"\n\"9.75\",\"56.5\"\n",
  };
  for (const std::string& text : texts) {
    CAPTURE(text);
    CHECK(corners(text, {}) == expected);
  }
  CHECK(corners("lon,lat,alt,n\n9,56,1,1\n9.5,56.25,1,1\n9.75,56.25,1,1\n", {}).front() == LonLat{9, 56});
  ReadOptions latitude_first;
  latitude_first.axis = AxisOrder::latlon;
  CHECK(corners("56.25 9.5\n56.25 9.75\n56.5 9.75\n", latitude_first) == expected);
  CHECK(corners("9.5W,56.25S\n9.25W,56.25S\n9.25W,56S\n", {}).front() == LonLat{-9.5, -56.25});
}

TEST_CASE("a blank line in coordinate text begins a hole", "[field][read]") {
  const TemporaryFile file{"f.txt",
                           "0,0\n0.01,0\n0.01,0.01\n0,0.01\n\n\n0.002,0.002\n0.004,0.002\n0.004,0.004\n"};
  const auto field = read_file(file.path()).front();
  REQUIRE(field.parts.size() == 1);
  CHECK(field.parts.front().shell.size() == 4);
  CHECK(field.parts.front().holes.size() == 1);
}

TEST_CASE("errors in coordinate text name the line", "[field][read]") {
  const auto error = [](const std::string& text) {
    const TemporaryFile file{"f.csv", text};
    return error_of([&] { read_file(file.path()); });
  };
  CHECK(mentions(error("9,56\n9.1,56\n9.1,abc\n"), "line 3"));
  CHECK(mentions(error("9,56\n9.1\n"), "line 2"));
  CHECK(mentions(error("56.1,168.9\n"), "latitude 168.9"));
  CHECK(mentions(error("9,5,56,4\n"), "semicolons"));
  CHECK(mentions(error("9,nan\n"), "line 1"));
  for (const char* lon : {"-5.0W", "W -5.0", "+5.0 W", "-5.0E"}) {
    CAPTURE(lon);
    CHECK(mentions(error("5W,52N\n" + std::string{lon} + ",52N\n"),
                   "line 2: '" + std::string{lon} + "' has a sign"));
  }
  CHECK(mentions(error("# nothing\n"), "no coordinates"));
  CHECK(mentions(error("9,56\n9.1,56\n"), "2 positions"));
}

TEST_CASE("what is wrong in GeoJSON is named by feature, ring and coordinate", "[field][read]") {
  const auto error = [](const std::string& text) { return error_of([&] { read_stdin(text); }); };
  const std::string third = "[[[10,50],[10.001,50],[10.001,null],[10,50]]]";
  CHECK(mentions(error(collection({feature(kSquare, "{}"), feature(third, "{}")})), "feature 2"));
  CHECK(mentions(error(feature(third, "{}")), "ring 1, coordinate 3"));
  CHECK(mentions(error("{\"type\":\n\"Polygon\",\n\"coordinates\":[[[1e999,2]]]}"), "line 3"));
  CHECK(mentions(error(R"({"type":"Polygon","coordinates":[[[1,2],[)"), "ends early"));
  CHECK(mentions(error(R"({"type":"feature","geometry":null})"), "'feature' is no type of GeoJSON"));
  CHECK(mentions(error(std::string{R"({"type":"Polygon","coordinates":[]})"} + '\0' + "{"),
                 "line 1, byte 36: a NUL"));
  CHECK(mentions(error(R"({"type":"Blob","coordinates":[]})"), "'Blob'"));
  CHECK(mentions(error("[1,2,3]"), "not GeoJSON"));
  CHECK(mentions(error(""), "empty"));
  CHECK(mentions(error(std::string(200000, '[')), "nested"));
  CHECK(mentions(error(feature("[[[10,91],[10.001,91],[10.001,91.001],[10,91]]]", "{}")), "latitude 91"));
  CHECK(mentions(
      error(R"({"type":"Polygon","crs":{"type":"name","properties":{"name":"EPSG:99999"}},"coordinates":)" +
            kSquare + "}"),
      "EPSG:99999"));
}

TEST_CASE("a CRS is taken from the option only where the file has none", "[field][read]") {
  const std::string utm = "[[[554600,6257900],[554800,6257900],[554800,6258100],[554600,6257900]]]";
  ReadOptions options;
  options.crs = "EPSG:25832";
  const auto field = read_stdin(feature(utm, "{}"), options).front();
  CHECK(field.parts.front().shell.front().lon_deg == Approx(9.886).margin(0.01));
  CHECK(any_mentions(field.notes, "--crs"));
  CHECK(mentions(error_of([&] { read_stdin(feature(utm, "{}")); }), "--crs"));
  const std::string said =
      R"({"type":"Feature","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::28992"}},"properties":{},
    "geometry":{"type":"Polygon","coordinates":[[[122000,490000],[122300,490000],[122300,490200],[122000,490000]]]}})";
  const std::string message = error_of([&] { read_stdin(said, options); });
  CHECK(mentions(message, "28992"));
  CHECK(mentions(message, "25832"));
  options.crs = "EPSG:28992";
  CHECK(read_stdin(said, options).front().datum == "Amersfoort");
  options.crs = "nonsense";
  CHECK(mentions(error_of([&] { read_stdin(feature(utm, "{}"), options); }), "nonsense"));
}

TEST_CASE("swapped axes of a projected CRS are found by its area of use", "[field][read]") {
  ReadOptions options;
  options.crs = "EPSG:28992";
  const std::string swapped = "[[[490000,122000],[490000,122300],[490200,122300],[490000,122000]]]";
  CHECK(mentions(error_of([&] { read_stdin(feature(swapped, "{}"), options); }), "swapped"));
}

TEST_CASE("a poor datum step is a note, and a bad one an error unless it is accepted", "[field][read]") {
  ReadOptions options;
  options.crs = "EPSG:4269";  // NAD83: 4 m by EPSG's count
  const std::string us = "[[[-120,37],[-119.999,37],[-119.999,37.001],[-120,37]]]";
  const auto field = read_stdin(feature(us, "{}"), options).front();
  CHECK(field.datum_accuracy_m == 4.0);
  CHECK(any_mentions(field.notes, "good to 4 m"));
  options.crs = "EPSG:4267";  // NAD27
  const std::string message = error_of([&] { read_stdin(feature(us, "{}"), options); });
  CHECK(mentions(message, "--accept-datum-error"));
  options.accept_datum_error_m = 50;
  CHECK(*read_stdin(feature(us, "{}"), options).front().datum_accuracy_m > 5);
}

TEST_CASE("archives, missing files and folders are told apart", "[field][read]") {
  const TemporaryFile text{"a.zip", "no archive"};
  CHECK(mentions(error_of([&] { read_file(text.path()); }), "archive"));
  CHECK(mentions(error_of([&] { read_file(text.path().parent_path()); }), "folder"));
  CHECK(mentions(error_of([&] { read_file("nowhere.geojson"); }), "does not exist"));
  const TemporaryFile tiff{"a.tif", std::string{"II*\0\x08\0\0\0", 8}};
  CHECK(mentions(error_of([&] { read_file(tiff.path()); }), "is no vector file"));
}

TEST_CASE("an archive that would fill the memory is refused before it is unpacked", "[field][read]") {
  const TemporaryFile place{"small", ""};
  const auto zip_of = [&](const std::string& name, int mebibytes) {
    const std::string zip = (place.path().parent_path() / name).string();
    void* open = reinterpret_cast<void* (*)(const char*, const char*)>(gdal_function("VSIFOpenL"))(
        ("/vsizip/" + zip + "/doc.kml").c_str(), "wb");
    const std::string blanks(1U << 20U, ' ');
    for (int i = 0; i < mebibytes; ++i)
      reinterpret_cast<std::size_t (*)(const void*, std::size_t, std::size_t, void*)>(
          gdal_function("VSIFWriteL"))(blanks.data(), 1, blanks.size(), open);
    reinterpret_cast<int (*)(void*)>(gdal_function("VSIFCloseL"))(open);
    return zip;
  };
  const std::string bomb = zip_of("bomb.zip", 257);
  CHECK(std::filesystem::file_size(bomb) < 1 << 20);
  CHECK(mentions(error_of([&] { read_file(bomb); }), "unpacks to more than 256 MB"));
  CHECK(mentions(error_of([&] { read_file(zip_of("blank.zip", 1)); }), "is no complete XML file"));
}

TEST_CASE("the paper's field is the same from GeoJSON, zipped shapefile, CSV and KML", "[field][read]") {
  const std::filesystem::path data = data_dir() / "fields";
  for (const auto& [one, other] :
       {std::pair{"f1.geojson", "f1.zip"}, {"f2.geojson", "f2.csv"}, {"f3.geojson", "f3.kml"}}) {
    CAPTURE(one);
    const double area_m2 = blocks_area_m2(read_file(data / one).front());
    CHECK(area_m2 > 4e4);
    CHECK(blocks_area_m2(read_file(data / other).front()) == Approx(area_m2).epsilon(1e-6));
  }
}

TEST_CASE("a KML file is read across its folders and repaired with notes", "[field][read]") {
  const auto placemark = [](const std::string& name, const std::string& coordinates) {
    return "<Folder><name>" + name + "</name><Placemark><name>" + name +
           "</name><Polygon><outerBoundaryIs><LinearRing><coordinates>" + coordinates +
           "</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></Folder>";
  };
  const auto kml = [](const std::string& inside) {
    return "<?xml version=\"1.0\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>" + inside +
           "</Document></kml>";
  };
  const TemporaryFile file{"f.kml",
                           kml(placemark("A", "10,50,0 10.001,50,0 10.001,50.001,0") +
                               placemark("B", "11, 50, 0 11.001, 50, 0\n 11.001, 50.001, 0 11, 50, 0"))};
  const auto fields = read_file(file.path());
  REQUIRE(fields.size() == 2);
  CHECK(fields[0].name == "A");
  CHECK(fields[1].name == "B");
  CHECK(any_mentions(fields[0].notes, "not closed"));
  CHECK(any_mentions(fields[0].notes, "blanks"));
  const TemporaryFile words{"w.kml", kml(placemark("A", "10,50 10.001,fifty 10.001,50.001"))};
  CHECK(mentions(error_of([&] { read_file(words.path()); }), "'10.001,fifty'"));
  const std::string whole = kml(placemark("A", "10,50 10.001,50 10.001,50.001"));
  const TemporaryFile cut{"c.kml", whole.substr(0, whole.find("10.001,50.001"))};
  CHECK(mentions(error_of([&] { read_file(cut.path()); }), "truncated"));
  const TemporaryFile open{"o.kml", whole.substr(0, whole.size() - 20)};
  CHECK(mentions(error_of([&] { read_file(open.path()); }), "cannot be read"));
  const TemporaryFile bomb{"b.kml", "<!DOCTYPE k [<!ENTITY a \"aaaa\">]><kml>&a;</kml>"};
  CHECK(mentions(error_of([&] { read_file(bomb.path()); }), "entities"));
}

TEST_CASE("a KML polygon has one outer ring, or is refused by line", "[field][read]") {
  const std::string ring =
      "<kml:LinearRing><kml:coordinates>10,50 10.001,50 10.001,50.001 "
      "10,50</kml:coordinates></kml:LinearRing>";
  const auto side = [&](const std::string& name) {
    return "<kml:" + name + ">" + ring + "</kml:" + name + ">\n";
  };
  const std::string outer = side("outerBoundaryIs");
  const std::string inner = side("innerBoundaryIs");
  const auto error = [](const std::string& polygon) {
    const TemporaryFile file{"f.kml",
                             "<?xml version=\"1.0\"?>\n<kml:kml xmlns:kml=\"http://www.opengis.net/kml/2.2\">"
                             "<kml:Placemark>\n<kml:Polygon>\n" +
                                 polygon + "</kml:Polygon>\n</kml:Placemark></kml:kml>"};
    return error_of([&] { read_file(file.path()); });
  };
  CHECK(mentions(error(outer + outer), "f.kml, line 6: Polygon 1 has more than one outer ring"));
  CHECK(mentions(error("<kml:outerBoundaryIs>" + ring + ring + "</kml:outerBoundaryIs>"),
                 "more than one outer"));
  CHECK(mentions(error(inner), "line 5: Polygon 1 has an inner ring"));
  CHECK(error(outer + inner + inner) == "");
  CHECK(error(inner + outer + "<!-- " + outer + " -->") == "");
}

TEST_CASE("a function that the installed GDAL lacks is refused by name", "[field][read]") {
  CHECK_THROWS_WITH(gdal_function("GDALNoSuchFunction"), Catch::Contains("GDALNoSuchFunction"));
}

TEST_CASE("a file whose text names another place to read is not followed", "[field][read]") {
  const TemporaryFile secret{"secret.geojson", R"({"type":"Polygon","coordinates":)" + kSquare + "}"};
  const auto refused = [](const char* name, const std::string& text) {
    const TemporaryFile file{name, text};
    return mentions(error_of([&] { read_file(file.path()); }), "is no vector file that GDAL reads");
  };
  CHECK(refused("field.vrt", "<OGRVRTDataSource><OGRVRTLayer name=\"secret\"><SrcDataSource>" +
                                 secret.path().string() +
                                 "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>"));
  CHECK(refused("field.xml", "<OGRWFSDataSource><URL>http://localhost:9/wfs</URL></OGRWFSDataSource>"));
}

TEST_CASE("reading leaves nothing beside the file", "[field][read]") {
  const std::string gml =
      R"(<?xml version="1.0"?><ogr:FeatureCollection xmlns:ogr="http://ogr.maptools.org/" xmlns:gml="http://www.opengis.net/gml/3.2"><ogr:featureMember><ogr:field gml:id="f1"><ogr:geom><gml:Polygon srsName="urn:ogc:def:crs:EPSG::4326" gml:id="g1"><gml:exterior><gml:LinearRing><gml:posList>50 10 50 10.001 50.001 10.001 50 10</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon></ogr:geom></ogr:field></ogr:featureMember></ogr:FeatureCollection>)";
  const TemporaryFile file{"f.gml", gml};
  CHECK(read_file(file.path()).front().parts.front().shell.front() == LonLat{10, 50});
  const auto folder = std::filesystem::directory_iterator{file.path().parent_path()};
  CHECK(std::distance(begin(folder), end(folder)) == 1);
}

TEST_CASE("standard input that does not end is refused", "[field][read]") {
  struct Endless : std::streambuf {
    std::string blanks = std::string(1U << 16U, ' ');
    int underflow() override {
      setg(blanks.data(), blanks.data(), blanks.data() + blanks.size());
      return traits_type::to_int_type(blanks.front());
    }
  } endless;
  std::istream stream{&endless};
  CHECK_THROWS_WITH(read_fields("-", {}, stream), Catch::Contains("does not end within 256 MB"));
}

TEST_CASE("a plan of ours is not taken for fields", "[field]") {
  std::string plan = collection({feature(kSquare, "{}")});
  plan.insert(plan.find('{') + 1, R"("selion": {"format": 1, "job": {}}, )");
  CHECK(mentions(error_of([&] { read_stdin(plan); }), "is a plan, not a field"));
  CHECK(read_stdin(collection({feature(kSquare, R"({"selion": "field"})")})).size() == 1);
}

TEST_CASE("of a field that is there many times ten others are named", "[field][read]") {
  constexpr int kTimes = 14;
  std::string features;
  for (int i = 0; i < kTimes; ++i)
    features += std::string{i == 0 ? "" : ","} +
                R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":)"
                R"([[[9,56],[9.001,56],[9.001,56.001],[9,56.001],[9,56]]]}})";
  const TemporaryFile file{"twins.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}"};

  const std::vector<Field> fields = read_file(file.path());

  REQUIRE(fields.size() == kTimes);
  const auto named = [](const Field& field) {
    return std::count_if(field.notes.begin(), field.notes.end(),
                         [](const std::string& note) { return mentions(note, "has the same boundary"); });
  };
  CHECK(named(fields[3]) == 3);
  CHECK(named(fields.back()) == 10);
  CHECK_FALSE(any_mentions(fields[10].notes, "overlaps other features too"));
  CHECK(any_mentions(fields[11].notes, "overlaps other features too"));
}
