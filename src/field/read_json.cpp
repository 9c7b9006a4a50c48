// SPDX-License-Identifier: GPL-3.0-or-later
// GeoJSON (RFC 7946), strictly: GDAL would pass over much that is broken, and drop what it cannot read.
#include <algorithm>
#include <array>
#include <string_view>

#include <nlohmann/json.hpp>

#include "raw.hpp"
#include "selion/core/error.hpp"

namespace selion {
namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 64;  // GeoJSON itself needs 8 and one more for each collection in a collection

/// Stops at the first error and at endless nesting, and remembers where.
class SyntaxCheck : public nlohmann::json_sax<Json> {
 public:
  std::size_t at = 0;
  std::string error;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return deeper(); }
  bool start_array(std::size_t) override { return deeper(); }
  bool end_object() override { return --depth_ >= 0; }
  bool end_array() override { return --depth_ >= 0; }
  bool parse_error(std::size_t position, const std::string& token, const Json::exception& what) override {
    at = position;
    constexpr std::size_t kShown = 40;
    error = std::string_view{what.what()}.find("number overflow") != std::string_view::npos
                ? "the number is not finite"
                : "this is not valid JSON";
    if (!token.empty())
      error += " near '" + token.substr(token.size() - std::min(kShown, token.size())) + "'";
    return false;
  }

 private:
  bool deeper() {
    if (++depth_ <= kDeepest) return true;
    error = "arrays or objects are nested more than " + std::to_string(kDeepest) + " deep";
    return false;
  }
  int depth_ = 0;
};

/// Where the text is no JSON, `check` says why.
bool is_valid(const std::string& text, SyntaxCheck& check) {
  if (!Json::sax_parse(text, &check)) {
    if (check.at >= text.size() && check.at > 0) check.error = "the JSON ends early";
    return false;
  }
  const std::size_t nul = text.find('\0');  // the library takes it for the end of the text
  if (nul == std::string::npos) return true;
  check.at = nul + 1;
  check.error = "a NUL stands behind the JSON";
  return false;
}

Json parsed(const std::string& text, const std::string& label) {
  SyntaxCheck check;
  if (!is_valid(text, check)) {
    const auto upto = text.begin() + static_cast<std::ptrdiff_t>(std::min(check.at, text.size()));
    const std::string where = check.at == 0
                                  ? ""
                                  : " at line " + std::to_string(1 + std::count(text.begin(), upto, '\n')) +
                                        ", byte " + std::to_string(check.at);
    throw InputError{label + where + ": " + check.error + "; export the file anew as GeoJSON"};
  }
  return Json::parse(text);
}

std::string member(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

/// Reads one geometry into a feature.
class Geometry {
 public:
  Geometry(RawFeature& into, std::string where) : into_{into}, where_{std::move(where)} {}

  void read(const Json& geometry) {
    if (!geometry.is_object()) fail("its geometry is no object");
    const std::string type = member(geometry, "type");
    if (type == "GeometryCollection") {
      for (const Json& one : array(geometry, "geometries")) read(one);
      return;
    }
    const auto coordinates = [&]() -> const Json& { return array(geometry, "coordinates"); };
    if (type == "Polygon")
      polygon(coordinates());
    else if (type == "MultiPolygon")
      for (const Json& one : coordinates()) polygon(one);
    else if (type == "Point")
      into_.points.push_back(position(coordinates(), ""));
    else if (type == "MultiPoint")
      for (const Json& one : coordinates()) into_.points.push_back(position(one, ""));
    else if (type == "LineString")
      into_.lines.push_back(positions(coordinates(), ""));
    else if (type == "MultiLineString")
      for (const Json& one : coordinates()) into_.lines.push_back(positions(one, ""));
    else
      fail("'" + type + "' is no type of GeoJSON");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { fail("", what); }
  /// `at`: ", ring 1, coordinate 2"
  [[noreturn]] void fail(const std::string& at, const std::string& what) const {
    throw InputError{where_ + at + ": " + what + "; correct the file"};
  }

  const Json& array(const Json& object, const char* key) const {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_array())
      fail(std::string{"its geometry has no array '"} + key + "'");
    return *found;
  }

  void polygon(const Json& rings) {
    const std::string part = ", part " + std::to_string(into_.polygons.size() + 1);
    if (!rings.is_array()) fail(part, "its coordinates are nested too little for a polygon");
    RawPolygon polygon;
    for (const Json& ring : rings)
      polygon.push_back(positions(ring, part + ", ring " + std::to_string(polygon.size() + 1)));
    if (!polygon.empty()) into_.polygons.push_back(std::move(polygon));
  }

  [[nodiscard]] std::vector<RawPoint> positions(const Json& list, const std::string& where) const {
    if (!list.is_array()) fail(where, "coordinates are missing");
    std::vector<RawPoint> points;
    points.reserve(list.size());
    for (const Json& one : list)
      points.push_back(position(one, where + ", coordinate " + std::to_string(points.size() + 1)));
    return points;
  }

  [[nodiscard]] RawPoint position(const Json& list, const std::string& where) const {
    if (list.is_number()) fail(where, "a list of positions has one level of brackets too few");
    if (!list.is_array() || list.size() < 2)
      fail(where, "a position needs two numbers, longitude and latitude");
    if (!list[0].is_number() || !list[1].is_number())
      fail(where, "a position needs two numbers, and has " + list.dump().substr(0, 60));
    return {list[0].get<double>(), list[1].get<double>()};
  }

  RawFeature& into_;
  std::string where_;
};

void read_attributes(const Json& feature, RawFeature& into) {
  const auto add = [&into](const std::string& key, const Json& value) {
    if (value.is_null() || into.attributes.contains(key)) return;
    into.attributes[key] = value.is_string() ? value.get<std::string>() : value.dump();
    into.attribute_order.push_back(key);
  };
  if (const auto properties = feature.find("properties");
      properties != feature.end() && properties->is_object())
    for (const auto& [key, value] : properties->items()) add(key, value);
  if (const auto id = feature.find("id"); id != feature.end()) add("id", *id);
}

RawFeature read_feature(const Json& feature, int number, const std::string& label) {
  const std::string where = label + ", feature " + std::to_string(number);
  if (!feature.is_object() || member(feature, "type") != "Feature")
    throw InputError{where + ": it is no GeoJSON Feature; correct the file"};
  RawFeature raw;
  raw.number = number;
  read_attributes(feature, raw);
  const auto geometry = feature.find("geometry");
  if (geometry != feature.end() && !geometry->is_null()) Geometry{raw, where}.read(*geometry);
  return raw;
}

/// The `crs` member of the 2008 draft, still written by GDAL and QGIS.
void read_crs(const Json& root, RawLayer& layer, const std::string& label) {
  layer.crs = "OGC:CRS84";
  layer.crs_is_default = true;
  const auto crs = root.find("crs");
  if (crs == root.end() || crs->is_null()) return;
  const auto properties = crs->is_object() ? crs->find("properties") : crs->end();
  if (!crs->is_object() || member(*crs, "type") != "name" || properties == crs->end() ||
      member(*properties, "name").empty())
    throw InputError{
        label +
        ": its 'crs' member names no CRS; remove it where the coordinates are WGS84 longitude and latitude"};
  layer.crs = member(*properties, "name");
  layer.crs_is_default = false;
  if (layer.crs->find("CRS84") != std::string::npos) layer.crs = "OGC:CRS84";
}

/// Its blocks and headlands are areas too: they must not pass for fields.
bool is_plan(const Json& root) {
  const auto own = root.find("selion");
  return own != root.end() && own->is_object() && own->contains("format") && own->contains("job");
}

}  // namespace

bool is_geojson(const std::string& text) {
  // TopoJSON and Esri JSON start with members of their own; whatever else is JSON is held to be meant as
  // GeoJSON.
  const std::string_view start = std::string_view{text}.substr(0, 2000);
  constexpr std::array<std::string_view, 4> kOthers{"\"Topology\"", "\"esriGeometry", "\"geometryType\"",
                                                    "\"spatialReference\""};
  return std::none_of(kOthers.begin(), kOthers.end(),
                      [start](std::string_view mark) { return start.find(mark) != std::string_view::npos; });
}

RawFile read_json(const std::string& bytes, const std::string& label, const std::string& stem) {
  RawFile file;
  file.label = label;
  file.stem = stem;
  bool was_latin1 = false;
  std::string text = as_utf8(bytes, was_latin1);
  if (was_latin1) file.notes.push_back(label + " is not UTF-8; its names are read as Latin-1");
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  const Json root = parsed(text, label);
  const std::string type = root.is_object() ? member(root, "type") : std::string{};
  RawLayer layer;
  if (type.empty())
    throw InputError{label + " is JSON, but not GeoJSON: it has no 'type'; export the field as GeoJSON"};
  if (is_plan(root))
    throw InputError{label + " is a plan, not a field; give the file that it was planned from"};
  layer.name = member(root, "name").empty() || type != "FeatureCollection" ? stem : member(root, "name");
  read_crs(root, layer, label);
  if (type == "FeatureCollection") {
    const auto features = root.find("features");
    if (features == root.end() || !features->is_array())
      throw InputError{label + ": the FeatureCollection has no array 'features'; correct the file"};
    for (const Json& one : *features)
      layer.features.push_back(read_feature(one, static_cast<int>(layer.features.size()) + 1, label));
  } else if (type == "Feature") {
    layer.features.push_back(read_feature(root, 1, label));
  } else {
    RawFeature raw;
    Geometry{raw, label}.read(root);
    layer.features.push_back(std::move(raw));
  }
  file.layers.push_back(std::move(layer));
  return file;
}

}  // namespace selion
