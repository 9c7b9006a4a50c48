// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <memory>
#include <span>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>

#include "file_bytes.hpp"
#include "gdal_handles.hpp"
#include "gdal_layer.hpp"
#include "gdal_library.hpp"
#include "raw.hpp"
#include "selion/core/error.hpp"
#include "text.hpp"

namespace selion {
namespace {

/// Attributes that GDAL makes of KML's drawing instructions.
constexpr std::array<std::string_view, 6> kKmlDrawing{"tessellate", "extrude", "visibility",
                                                      "drawOrder",  "icon",    "altitudeMode"};

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

struct Close {
  void operator()(void* dataset) const { SELION_GDAL(GDALClose)(dataset); }
};

/// Appends the layers of one data set.
void read_dataset(const std::string& path, const std::string& label, RawFile& into) {
  SELION_GDAL(GDALAllRegister)();
  GdalMessages messages;
  const std::unique_ptr<void, Close> dataset{SELION_GDAL(GDALOpenEx)(
      path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr, nullptr)};
  if (!dataset) {
    throw_first(messages, path, label);
    throw InputError{label +
                     " is no vector file that GDAL reads; export the field as GeoJSON, KML or shapefile"};
  }
  const std::string driver =
      SELION_GDAL(GDALGetDriverShortName)(SELION_GDAL(GDALGetDatasetDriver)(dataset.get()));
  into.layers_are_folders = driver == "LIBKML" || driver == "KML";
  using Names = std::span<const std::string_view>;
  const Names skipped = into.layers_are_folders ? Names{kKmlDrawing} : Names{};
  for (int i = 0; i < SELION_GDAL(GDALDatasetGetLayerCount)(dataset.get()); ++i)
    into.layers.push_back(read_layer(SELION_GDAL(GDALDatasetGetLayer)(dataset.get(), i), skipped));
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
    if (gdal_file_exists(without_extension(path) + "." + one)) return without_extension(path) + "." + one;
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
    others[i] = gdal_file_bytes(*beside, label);
    folder.add(stem + "." + endings[i], others[i]);
  }
  const std::string copy = folder.add(stem + ".shp", bytes);
  SELION_GDAL(CPLSetThreadLocalConfigOption)("SHAPE_RESTORE_SHX", "YES");
  try {
    read_dataset(copy, label, into);
  } catch (...) {
    SELION_GDAL(CPLSetThreadLocalConfigOption)("SHAPE_RESTORE_SHX", nullptr);
    throw;
  }
  SELION_GDAL(CPLSetThreadLocalConfigOption)("SHAPE_RESTORE_SHX", nullptr);
  into.notes.push_back(label + ": its .shx is missing; the records are counted anew");
}

void read_shapefile(const std::string& path, const std::string& label, RawFile& into) {
  const std::string bytes = gdal_file_bytes(path, label);
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
  VSILFILE* file = SELION_GDAL(VSIFOpenL)(path.c_str(), "rb");
  if (file == nullptr) refuse_unreadable(label);
  std::string start(64, ' ');
  start.resize(SELION_GDAL(VSIFReadL)(start.data(), 1, start.size(), file));
  SELION_GDAL(VSIFCloseL)(file);
  const auto first = start.find_first_not_of(std::string_view{"\xEF\xBB\xBF\xFF\xFE \t\r\n\0", 10});
  return first != std::string::npos && start[first] == '<';
}

void read_one(const std::string& path, const std::string& label, RawFile& into) {
  if (extension(path) == "shp") {
    read_shapefile(path, label, into);
  } else if (starts_as_xml(path, label)) {
    const std::string bytes = gdal_file_bytes(path, label);
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
  char** list = SELION_GDAL(VSIReadDirRecursive)(archive.c_str());
  std::vector<std::string> found;
  for (char** one = list; one != nullptr && *one != nullptr; ++one)
    if (extension(*one) == ending && !file_name(*one).starts_with("._"))
      found.push_back(archive + "/" + *one);
  SELION_GDAL(CSLDestroy)(list);
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
        RawFile inside = read_json(gdal_file_bytes(one, name), name, file_name(without_extension(one)));
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
