// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <memory>

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "gdal_handles.hpp"
#include "raw.hpp"
#include "selion/core/error.hpp"
#include "text.hpp"

namespace selion {
namespace {

using Geometry = std::unique_ptr<OGRGeometry>;

RawRing ring_of(const OGRLineString& line, bool swap) {
  RawRing ring;
  ring.reserve(static_cast<std::size_t>(line.getNumPoints()));
  for (int i = 0; i < line.getNumPoints(); ++i) {
    const RawPoint p{line.getX(i), line.getY(i)};
    ring.push_back(swap ? RawPoint{p.y, p.x} : p);
  }
  return ring;
}

void collect(const OGRGeometry& geometry, bool swap, RawFeature& into) {
  constexpr double kStep_deg = 0.5;  // a chord leaves its arc by 5 mm at a radius of 500 m
  if (geometry.IsEmpty()) return;
  if (geometry.hasCurveGeometry(TRUE) != 0) {
    const Geometry linear{geometry.getLinearGeometry(kStep_deg, nullptr)};
    if (linear) collect(*linear, swap, into);
    return;
  }
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPolygon:
    case wkbTriangle: {
      RawPolygon polygon;
      for (const auto* ring : *geometry.toPolygon()) polygon.push_back(ring_of(*ring, swap));
      into.polygons.push_back(std::move(polygon));
      return;
    }
    case wkbLineString:
      into.lines.push_back(ring_of(*geometry.toLineString(), swap));
      return;
    case wkbPoint: {
      const RawPoint p{geometry.toPoint()->getX(), geometry.toPoint()->getY()};
      into.points.push_back(swap ? RawPoint{p.y, p.x} : p);
      return;
    }
    case wkbMultiPolygon:
    case wkbMultiLineString:
    case wkbMultiPoint:
    case wkbGeometryCollection:
      for (const auto* part : *geometry.toGeometryCollection()) collect(*part, swap, into);
      return;
    default:
      into.notes.push_back(std::string{"a geometry of type "} + geometry.getGeometryName() + " is left out");
  }
}

std::string text_of(const OGRFeature& feature, int i) {
  if (feature.GetFieldDefnRef(i)->GetType() != OFTStringList) return feature.GetFieldAsString(i);
  std::string joined;
  for (char** one = feature.GetFieldAsStringList(i); one != nullptr && *one != nullptr; ++one)
    joined += (joined.empty() ? "" : "; ") + std::string{*one};
  return joined;
}

void collect_attributes(const OGRFeature& feature, bool is_kml, RawFeature& into) {
  constexpr std::array<std::string_view, 6> kKmlDrawing{"tessellate", "extrude", "visibility",
                                                        "drawOrder",  "icon",    "altitudeMode"};
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    if (feature.IsFieldSetAndNotNull(i) == FALSE) continue;
    const std::string name = feature.GetFieldDefnRef(i)->GetNameRef();
    if (is_kml && std::find(kKmlDrawing.begin(), kKmlDrawing.end(), name) != kKmlDrawing.end()) continue;
    bool was_latin1 = false;
    const std::string value = as_utf8(text_of(feature, i), was_latin1);
    if (value.empty()) continue;
    if (was_latin1) into.notes.push_back("its attribute '" + name + "' is not UTF-8, and is read as Latin-1");
    into.attributes[name] = value;
    into.attribute_order.push_back(name);
  }
}

/// A code where the definition is, beyond doubt, one of EPSG's, else WKT. Absent: the file has no usable CRS.
std::optional<std::string> definition(const OGRSpatialReference* srs) {
  if (srs == nullptr || srs->IsEmpty()) return std::nullopt;
  const char* name = srs->GetName();
  if (name != nullptr && std::string_view{name}.starts_with("Undefined "))
    return std::nullopt;  // of GeoPackages
  OGRSpatialReference flat{*srs};
  flat.StripVertical();
  const auto code = [](const OGRSpatialReference& one) -> std::optional<std::string> {
    const char* authority = one.GetAuthorityName(nullptr);
    const char* number = one.GetAuthorityCode(nullptr);
    if (authority == nullptr || number == nullptr) return std::nullopt;
    return std::string{authority} + ":" + number;
  };
  if (auto own = code(flat)) return own;
  constexpr int kSure = 90;
  const std::unique_ptr<OGRSpatialReference> match{flat.FindBestMatch(kSure, nullptr, nullptr)};
  if (match) return code(*match);
  char* wkt = nullptr;
  const std::array<const char*, 2> options{"FORMAT=WKT2_2019", nullptr};
  flat.exportToWkt(&wkt, options.data());
  std::string text = wkt == nullptr ? "" : wkt;
  CPLFree(wkt);
  return text;
}

/// Vector drivers give x (easting, longitude) first, whatever the CRS says, unless they say that they do not.
bool northing_first(const OGRSpatialReference* srs) {
  return srs != nullptr && srs->GetAxisMappingStrategy() == OAMS_AUTHORITY_COMPLIANT &&
         (srs->EPSGTreatsAsLatLong() != 0 || srs->EPSGTreatsAsNorthingEasting() != 0);
}

RawLayer read_layer(OGRLayer& layer, bool is_kml) {
  RawLayer raw;
  raw.name = layer.GetName();
  raw.crs = definition(layer.GetSpatialRef());
  const bool swap = northing_first(layer.GetSpatialRef());
  layer.ResetReading();
  while (const auto feature = std::unique_ptr<OGRFeature>{layer.GetNextFeature()}) {
    RawFeature one;
    one.number = static_cast<int>(raw.features.size()) + 1;
    collect_attributes(*feature, is_kml, one);
    if (feature->GetGeometryRef() != nullptr) collect(*feature->GetGeometryRef(), swap, one);
    raw.features.push_back(std::move(one));
  }
  return raw;
}

/// GDAL's words, with its name of the file replaced by the user's.
std::string in_our_words(std::string text, const std::string& path, const std::string& label) {
  for (auto at = text.find(path); at != std::string::npos; at = text.find(path, at + label.size()))
    text.replace(at, path.size(), label);
  while (!text.empty() && (text.back() == '.' || text.back() == '\n')) text.pop_back();
  return text;
}

void throw_first(const GdalMessages& messages, const std::string& path, const std::string& label) {
  if (!messages.failures.empty())
    throw InputError{label + " cannot be read: " + in_our_words(messages.failures.front(), path, label) +
                     "; export it anew"};
}

/// Appends the layers of one data set.
void read_dataset(const std::string& path, const std::string& label, RawFile& into) {
  GDALAllRegister();
  GdalMessages messages;
  const std::unique_ptr<GDALDataset> dataset{
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR)};
  if (!dataset) {
    throw_first(messages, path, label);
    throw InputError{label +
                     " is no vector file that GDAL reads; export the field as GeoJSON, KML or shapefile"};
  }
  const std::string driver = dataset->GetDriverName();
  into.layers_are_folders = driver == "LIBKML" || driver == "KML";
  for (OGRLayer* layer : dataset->GetLayers())
    into.layers.push_back(read_layer(*layer, into.layers_are_folders));
  throw_first(messages, path, label);
  for (const std::string& warning : messages.warnings)
    if (!warning.starts_with("Non closed ring"))  // said with the ring's name when it is closed
      into.notes.push_back(label + ": GDAL warns: " + in_our_words(warning, path, label));
}

std::string extension(const std::string& path) {
  const auto dot = path.find_last_of("./");
  return dot == std::string::npos || path[dot] == '/' ? "" : lower(path.substr(dot + 1));
}

std::string without_extension(const std::string& path) {
  return path.substr(0, path.size() - extension(path).size() - 1);
}

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

std::optional<std::string> sibling(const std::string& path, const std::string& other) {
  std::string upper = other;
  for (char& c : upper) c = static_cast<char>(c - 'a' + 'A');
  for (const std::string& one : {other, upper})
    if (file_exists(without_extension(path) + "." + one)) return without_extension(path) + "." + one;
  return std::nullopt;
}

/// Restores a lost index in memory: GDAL would write it beside the file.
void read_without_index(const std::string& path, const std::string& bytes, const std::string& label,
                        RawFile& into) {
  MemoryFolder folder;
  std::array<std::string, 3> others;
  const std::array<const char*, 3> endings{"dbf", "prj", "cpg"};
  const std::string stem = file_name(without_extension(path));
  for (std::size_t i = 0; i < endings.size(); ++i) {
    const auto beside = sibling(path, endings[i]);
    if (!beside) continue;
    others[i] = file_bytes(*beside, label);
    folder.add(stem + "." + endings[i], others[i]);
  }
  const std::string copy = folder.add(stem + ".shp", bytes);
  CPLSetThreadLocalConfigOption("SHAPE_RESTORE_SHX", "YES");
  try {
    read_dataset(copy, label, into);
  } catch (...) {
    CPLSetThreadLocalConfigOption("SHAPE_RESTORE_SHX", nullptr);
    throw;
  }
  CPLSetThreadLocalConfigOption("SHAPE_RESTORE_SHX", nullptr);
  into.notes.push_back(label + ": its .shx is missing; the records are counted anew");
}

void read_shapefile(const std::string& path, const std::string& label, RawFile& into) {
  const std::string bytes = file_bytes(path, label);
  check_shapefile(bytes, label);
  if (sibling(path, "shx"))
    read_dataset(path, label, into);
  else
    read_without_index(path, bytes, label, into);
  if (!sibling(path, "dbf")) into.notes.push_back(label + ": its .dbf is missing; fields have no attributes");
}

bool starts_as_xml(const std::string& path, const std::string& label) {
  constexpr std::array<std::string_view, 6> kXml{"xml", "kml", "gml", "gpx", "xsd", "isoxml"};
  if (std::find(kXml.begin(), kXml.end(), extension(path)) != kXml.end()) return true;
  VSILFILE* file = VSIFOpenL(path.c_str(), "rb");
  if (file == nullptr) throw InputError{label + " cannot be read; check the name and the permissions"};
  std::string start(64, ' ');
  start.resize(VSIFReadL(start.data(), 1, start.size(), file));
  VSIFCloseL(file);
  const auto first = start.find_first_not_of(std::string_view{"\xEF\xBB\xBF\xFF\xFE \t\r\n\0", 10});
  return first != std::string::npos && start[first] == '<';
}

void read_one(const std::string& path, const std::string& label, RawFile& into) {
  if (extension(path) == "shp") {
    read_shapefile(path, label, into);
  } else if (starts_as_xml(path, label)) {
    const std::string bytes = file_bytes(path, label);
    for (std::string& note : check_xml(bytes, label)) into.notes.push_back(std::move(note));
    MemoryFolder folder;
    read_dataset(folder.add(file_name(path), bytes), label, into);
  } else {
    read_dataset(path, label, into);
  }
}

/// Every file in the archive with one of these endings, in order of their names.
std::vector<std::string> members(const std::string& archive, std::string_view ending) {
  GdalMessages messages;
  char** list = VSIReadDirRecursive(archive.c_str());
  std::vector<std::string> found;
  for (char** one = list; one != nullptr && *one != nullptr; ++one)
    if (extension(*one) == ending && !file_name(*one).starts_with("._"))
      found.push_back(archive + "/" + *one);
  CSLDestroy(list);
  std::sort(found.begin(), found.end());
  return found;
}

void read_archive(const std::string& file, const std::string& label, RawFile& into) {
  const std::string archive = "/vsizip/{" + file + "}";
  for (const std::string_view ending : {"shp", "kml", "gpkg", "fgb", "gml", "geojson", "json", "tab"}) {
    const auto found = members(archive, ending);
    for (const std::string& one : found) {
      const std::string name = label + ": " + one.substr(archive.size() + 1);
      if (ending == "geojson" || ending == "json") {
        RawFile inside = read_json(file_bytes(one, name), name, file_name(without_extension(one)));
        into.notes.insert(into.notes.end(), inside.notes.begin(), inside.notes.end());
        into.layers.push_back(std::move(inside.layers.front()));
      } else {
        read_one(one, name, into);
      }
    }
    if (!found.empty()) return;
  }
  throw InputError{label +
                   " is an archive without a shapefile or another field file in it; check how it was packed"};
}

}  // namespace

RawFile read_with_gdal(const std::filesystem::path& file, const std::string& label) {
  const GdalMessages silence;
  RawFile raw;
  raw.label = label;
  raw.stem = file.stem().string();
  std::string path = file.string();
  const std::string ending = extension(path);
  if ((ending == "shx" || ending == "dbf") && sibling(path, "shp")) path = *sibling(path, "shp");
  if (std::filesystem::is_directory(file)) {
    if (ending != "gdb") throw InputError{label + " is a folder; give the field file in it"};
    read_dataset(path, label, raw);
  } else if (ending == "zip" || ending == "kmz" || ending == "shz") {
    read_archive(path, label, raw);
  } else {
    read_one(path, label, raw);
  }
  return raw;
}

}  // namespace selion
