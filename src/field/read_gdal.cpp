// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>

#include "file_bytes.hpp"
#include "gdal_handles.hpp"
#include "gdal_layer.hpp"
#include "gdal_library.hpp"
#include "raw_stream.hpp"
#include "selion/core/error.hpp"
#include "text.hpp"

namespace selion {
namespace {

/// Attributes that GDAL makes of KML's drawing instructions.
constexpr std::array<std::string_view, 6> kKmlDrawing{"tessellate", "extrude", "visibility",
                                                      "drawOrder",  "icon",    "altitudeMode"};

constexpr unsigned long long kMostUnpacked_bytes = 1ULL << 28U;

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

using Dataset = std::unique_ptr<void, Close>;

struct Destroy {
  void operator()(void* feature) const { SELION_GDAL(OGR_F_Destroy)(static_cast<OGRFeatureH>(feature)); }
};

/// Names of the views of a database, in lower case.
std::set<std::string> stored_queries(const Dataset& dataset) {
  OGRLayerH found = SELION_GDAL(GDALDatasetExecuteSQL)(
      dataset.get(), "SELECT lower(name) FROM sqlite_master WHERE type = 'view'", nullptr, nullptr);
  std::set<std::string> names;
  if (found == nullptr) return names;
  while (const std::unique_ptr<void, Destroy> row{SELION_GDAL(OGR_L_GetNextFeature)(found)})
    names.insert(SELION_GDAL(OGR_F_GetFieldAsString)(static_cast<OGRFeatureH>(row.get()), 0));
  SELION_GDAL(GDALDatasetReleaseResultSet)(dataset.get(), found);
  return names;
}

/// The first layer that is a view.
std::optional<std::string> stored_query_in(const Dataset& dataset) {
  const std::string_view driver =
      SELION_GDAL(GDALGetDriverShortName)(SELION_GDAL(GDALGetDatasetDriver)(dataset.get()));
  if (driver != "GPKG" && driver != "SQLite") return std::nullopt;
  const std::set<std::string> queries = stored_queries(dataset);
  for (int i = 0; i < SELION_GDAL(GDALDatasetGetLayerCount)(dataset.get()); ++i) {
    std::string name = SELION_GDAL(OGR_L_GetName)(SELION_GDAL(GDALDatasetGetLayer)(dataset.get(), i));
    if (queries.contains(lower(name))) return name;
  }
  return std::nullopt;
}

/// Nobody can say how long a query runs, or whether it ends.
void refuse_stored_queries(const Dataset& dataset, const std::string& label) {
  if (const auto name = stored_query_in(dataset))
    throw InputError{label + ": layer '" + *name +
                     "' is a stored query (a view), not a table; export the fields to a file of their own"};
}

Dataset opened(const std::string& path, const std::string& label, const GdalMessages& messages) {
  Dataset dataset{SELION_GDAL(GDALOpenEx)(path.c_str(),
                                          GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                          gdal_drivers(), nullptr, nullptr)};
  if (dataset) {
    refuse_stored_queries(dataset, label);
    return dataset;
  }
  const bool unknown =
      !messages.failures.empty() &&
      messages.failures.front().find("not recognized as a supported file format") != std::string::npos;
  if (!unknown) throw_first(messages, path, label);
  throw InputError{label +
                   " is no vector file that GDAL reads; export the field as GeoJSON, KML or shapefile"};
}

void add_warnings(const GdalMessages& messages, const std::string& path, const std::string& label,
                  std::vector<std::string>& notes) {
  for (const std::string& warning : messages.warnings)
    if (!warning.starts_with("Non closed ring"))  // said with the ring's name when it is closed
      notes.push_back(label + ": GDAL warns: " + in_our_words(warning, path, label));
}

/// Appends the layers of one data set.
void read_dataset(const std::string& path, const std::string& label, RawFile& into) {
  const GdalMessages messages;
  const Dataset dataset = opened(path, label, messages);
  const std::string driver =
      SELION_GDAL(GDALGetDriverShortName)(SELION_GDAL(GDALGetDatasetDriver)(dataset.get()));
  into.layers_are_folders = driver == "LIBKML" || driver == "KML";
  using Names = std::span<const std::string_view>;
  const Names skipped = into.layers_are_folders ? Names{kKmlDrawing} : Names{};
  for (int i = 0; i < SELION_GDAL(GDALDatasetGetLayerCount)(dataset.get()); ++i)
    into.layers.push_back(read_layer(SELION_GDAL(GDALDatasetGetLayer)(dataset.get(), i), skipped));
  throw_first(messages, path, label);
  add_warnings(messages, path, label, into.notes);
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

std::string without_dbf(const std::string& label) {
  return label + ": its .dbf is missing; fields have no attributes";
}

void read_shapefile(const std::string& path, const std::string& label, RawFile& into) {
  const std::string bytes = gdal_file_bytes(path, label);
  check_shapefile(bytes, label);
  if (sibling(path, "shx"))
    read_dataset(path, label, into);
  else
    read_without_index(path, bytes, label, into);
  if (!sibling(path, "dbf")) into.notes.push_back(without_dbf(label));
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

/// All files in the archive, in order of their names.
std::vector<std::string> members(const std::string& archive) {
  GdalMessages messages;
  char** list = SELION_GDAL(VSIReadDirRecursive)(archive.c_str());
  std::vector<std::string> found;
  for (char** one = list; one != nullptr && *one != nullptr; ++one) found.push_back(archive + "/" + *one);
  SELION_GDAL(CSLDestroy)(list);
  std::sort(found.begin(), found.end());
  return found;
}

/// Those with this ending.
std::vector<std::string> with_ending(std::vector<std::string> files, std::string_view ending) {
  std::erase_if(files, [&](const std::string& one) {
    return extension(one) != ending || file_name(one).starts_with("._");
  });
  return files;
}

/// Half a megabyte may unpack to gigabytes: asked before any is. Boundaries become a tenth as large at best.
void refuse_bomb(const std::string& archive, const std::vector<std::string>& files,
                 const std::string& label) {
  constexpr unsigned long long kTimes = 100;
  unsigned long long sum = 0;
  for (const std::string& file : files) sum += gdal_file_size(file);
  if (sum > kMostUnpacked_bytes && sum > kTimes * gdal_file_size(archive))
    throw InputError{
        label +
        " unpacks to more than 256 MB, a hundred times its size; unpack it, and give the field file in it"};
}

void read_archive(const std::string& file, const std::string& label, RawFile& into) {
  const std::string archive = "/vsizip/{" + file + "}";
  const std::vector<std::string> all = members(archive);
  refuse_bomb(file, all, label);
  for (const std::string_view ending : {"shp", "kml", "gpkg", "fgb", "gml", "geojson", "json", "tab"}) {
    const auto found = with_ending(all, ending);
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

/// A data set that stays open while its features are read one at a time.
class OpenDataset {
 public:
  OpenDataset(std::string path, std::string label) : path_{std::move(path)}, label_{std::move(label)} {
    const GdalMessages messages;
    dataset_ = opened(path_, label_, messages);
    for (int i = 0; i < SELION_GDAL(GDALDatasetGetLayerCount)(dataset_.get()); ++i)
      layers_.push_back(cursor(dataset_, i).about());
    throw_first(messages, path_, label_);
    add_warnings(messages, path_, label_, notes_);
  }

  [[nodiscard]] std::vector<RawLayer> layers() const { return layers_; }
  [[nodiscard]] std::vector<std::string> notes() const { return notes_; }

  void rewind(std::size_t layer) {
    const GdalMessages silence;
    cursor_.emplace(cursor(dataset_, static_cast<int>(layer)));
  }
  std::optional<RawFeature> next() {
    const GdalMessages messages;
    auto feature = cursor_->next();
    throw_first(messages, path_, label_);
    return feature;
  }
  /// By a second handle: the first keeps its place.
  std::optional<RawFeature> at(std::size_t layer, std::int64_t id, int number) {
    const GdalMessages messages;
    if (!again_) again_ = opened(path_, label_, messages);
    return cursor(again_, static_cast<int>(layer)).at(id, number);
  }

 private:
  static LayerCursor cursor(const Dataset& dataset, int layer) {
    return {SELION_GDAL(GDALDatasetGetLayer)(dataset.get(), layer), {}};
  }

  std::string path_;
  std::string label_;
  Dataset dataset_;
  Dataset again_;
  std::vector<RawLayer> layers_;
  std::vector<std::string> notes_;
  std::optional<LayerCursor> cursor_;
};

/// The path of a shapefile of which one of the other files is named.
std::string path_for_gdal(const std::filesystem::path& file) {
  const std::string path = file.string();
  const std::string ending = extension(path);
  const bool part = ending == "shx" || ending == "dbf";
  return part ? sibling(path, "shp").value_or(path) : path;
}

bool is_archive(const std::string& ending) { return ending == "zip" || ending == "kmz" || ending == "shz"; }

/// Whether GDAL reads it where it lies: XML is checked and read from memory, archives have several files.
bool is_read_in_place(const std::string& path, const std::string& label) {
  const std::string ending = extension(path);
  if (is_archive(ending)) return false;
  if (ending == "shp") return sibling(path, "shx").has_value();
  return std::filesystem::is_directory(path) ? ending == "gdb" : !starts_as_xml(path, label);
}

}  // namespace

std::optional<RawStream> stream_with_gdal(const std::filesystem::path& file, const std::string& label) {
  const GdalMessages silence;
  const std::string path = path_for_gdal(file);
  if (!is_read_in_place(path, label)) return std::nullopt;
  if (extension(path) == "shp") check_shapefile(gdal_file_bytes(path, label), label);
  const auto dataset = std::make_shared<OpenDataset>(path, label);
  RawStream stream;
  stream.about = {label, file.stem().string(), dataset->layers(), false, dataset->notes()};
  if (extension(path) == "shp" && !sibling(path, "dbf")) stream.about.notes.push_back(without_dbf(label));
  stream.rewind = [dataset](std::size_t layer) { dataset->rewind(layer); };
  stream.next = [dataset] { return dataset->next(); };
  stream.at = [dataset](std::size_t layer, std::int64_t id, int number) {
    return dataset->at(layer, id, number);
  };
  return stream;
}

RawFile read_with_gdal(const std::filesystem::path& file, const std::string& label) {
  const GdalMessages silence;
  RawFile raw;
  raw.label = label;
  raw.stem = file.stem().string();
  const std::string path = path_for_gdal(file);
  const std::string ending = extension(path);
  if (std::filesystem::is_directory(file)) {
    if (ending != "gdb") throw InputError{label + " is a folder; give the field file in it"};
    read_dataset(path, label, raw);
  } else if (is_archive(ending)) {
    read_archive(path, label, raw);
  } else {
    read_one(path, label, raw);
  }
  return raw;
}

}  // namespace selion
