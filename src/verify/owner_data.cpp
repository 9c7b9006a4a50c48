// SPDX-License-Identifier: GPL-3.0-or-later
#include "owner_data.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>
#include <string_view>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <nlohmann/json.hpp>

#include "letters.hpp"
#include "ogr.hpp"
#include "selion/core/error.hpp"

namespace selion::verifying {
namespace {

namespace fs = std::filesystem;

/// A folder in memory: OGR may write there.
class MemoryFolder {
 public:
  MemoryFolder() : path_{"/vsimem/selion_owner_" + std::to_string(reinterpret_cast<std::uintptr_t>(this))} {}
  ~MemoryFolder() { SELION_OGR(VSIRmdirRecursive)(path_.c_str()); }
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;
  MemoryFolder(MemoryFolder&&) = delete;
  MemoryFolder& operator=(MemoryFolder&&) = delete;

  std::string add(const std::string& name, const std::string& text) {
    std::string path = path_ + "/" + name;
    VSILFILE* file = SELION_OGR(VSIFOpenL)(path.c_str(), "wb");
    SELION_OGR(VSIFWriteL)(text.data(), 1, text.size(), file);
    SELION_OGR(VSIFCloseL)(file);
    return path;
  }

 private:
  std::string path_;
};

std::string ending_of(const fs::path& path) { return lower(path.extension().string()); }

bool is_there(const fs::path& path) {
  VSIStatBufL about{};
  return SELION_OGR(VSIStatExL)(path.c_str(), &about, VSI_STAT_EXISTS_FLAG) == 0;
}

/// The file of the same name with another ending, in small letters or capitals.
std::optional<fs::path> beside(fs::path path, std::string ending) {
  if (is_there(path.replace_extension(ending))) return path;
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return is_there(path.replace_extension(ending)) ? std::optional{path} : std::nullopt;
}

std::string text_of(const fs::path& path) {
  VSILFILE* file = SELION_OGR(VSIFOpenL)(path.c_str(), "rb");
  if (file == nullptr) return {};
  std::string text;
  std::array<char, 65536> some{};
  while (const std::size_t read = SELION_OGR(VSIFReadL)(some.data(), 1, some.size(), file))
    text.append(some.data(), read);
  SELION_OGR(VSIFCloseL)(file);
  return text;
}

/// All but those that open whatever place the file's text names; a null ends them.
std::vector<const char*> trusted_drivers() {
  SELION_OGR(GDALAllRegister)();
  std::vector<const char*> names;
  for (int i = 0; i < SELION_OGR(GDALGetDriverCount)(); ++i) {
    const char* name = SELION_OGR(GDALGetDriverShortName)(SELION_OGR(GDALGetDriver)(i));
    if (std::string_view{name} != "OGR_VRT" && std::string_view{name} != "WFS") names.push_back(name);
  }
  names.push_back(nullptr);
  return names;
}

/// `kept` stays as long as the data set is open.
OwnerData opened(const std::string& path, const std::string& label,
                 const std::shared_ptr<MemoryFolder>& kept) {
  static const std::vector<const char*> drivers = trusted_drivers();
  void* data = SELION_OGR(GDALOpenEx)(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers.data(),
                                      nullptr, nullptr);
  if (data == nullptr)
    throw InputError{label + ": OGR cannot read it; give the field as a vector file with polygons"};
  return {{data, [kept, close = SELION_OGR(GDALClose)](void* open) { close(open); }}, label, path};
}

/// Its records are counted anew, in a copy: OGR writes the count beside the file.
OwnerData opened_without_index(const fs::path& path, const std::string& label) {
  const auto folder = std::make_shared<MemoryFolder>();
  for (const char* ending : {".dbf", ".prj", ".cpg"})
    if (const auto other = beside(path, ending)) folder->add(path.stem().string() + ending, text_of(*other));
  const std::string copy = folder->add(path.stem().string() + ".shp", text_of(path));
  const auto set = SELION_OGR(CPLSetThreadLocalConfigOption);
  set("SHAPE_RESTORE_SHX", "YES");
  const std::shared_ptr<void> unset{nullptr, [set](void*) { set("SHAPE_RESTORE_SHX", nullptr); }};
  return opened(copy, label, folder);
}

/// KML parts positions at blanks; "9.8, 56.4, 0" is meant as "9.8,56.4,0".
std::string without_blanks_at_commas(std::string_view kml) {
  constexpr std::string_view kBlanks = " \t\r\n";
  std::string tidy;
  bool inside = false;
  for (std::size_t i = 0; i < kml.size(); ++i) {
    if (kml[i] == '<') inside = kml.substr(i).starts_with("<coordinates>");
    const std::size_t next = kml.find_first_not_of(kBlanks, i);
    const bool at_comma = tidy.ends_with(',') || (next != std::string_view::npos && kml[next] == ',');
    const bool drop = inside && at_comma && kBlanks.find(kml[i]) != std::string_view::npos;
    if (!drop) tidy += kml[i];
  }
  return tidy;
}

OwnerData opened_one(const fs::path& path, const std::string& label) {
  const std::string ending = ending_of(path);
  if (ending == ".shp" && !beside(path, ".shx")) return opened_without_index(path, label);
  if (ending != ".kml") return opened(path.string(), label, nullptr);
  const auto folder = std::make_shared<MemoryFolder>();
  return opened(folder->add(path.filename().string(), without_blanks_at_commas(text_of(path))), label,
                folder);
}

/// By their names.
std::vector<std::string> members(const std::string& archive, const std::string& ending) {
  std::vector<std::string> found;
  char** names = SELION_OGR(VSIReadDirRecursive)(archive.c_str());
  for (char** name = names; name != nullptr && *name != nullptr; ++name)
    if (ending_of(*name) == ending && !fs::path{*name}.filename().string().starts_with("._"))
      found.emplace_back(*name);
  SELION_OGR(CSLDestroy)(names);
  std::ranges::sort(found);
  return found;
}

std::vector<OwnerData> opened_archive(const std::string& file) {
  const std::string archive = "/vsizip/{" + file + "}";
  const std::string label = file + ": ";
  for (const char* ending : {".shp", ".kml", ".gpkg", ".fgb", ".gml", ".geojson", ".json", ".tab"}) {
    std::vector<OwnerData> all;
    for (const std::string& name : members(archive, ending))
      all.push_back(opened_one(fs::path{archive} / name, label + name));
    if (!all.empty()) return all;
  }
  throw InputError{file + " is an archive without a shapefile or another field file in it"};
}

}  // namespace

std::vector<OwnerData> owner_data(const fs::path& file) {
  const std::string ending = ending_of(file);
  if (ending == ".zip" || ending == ".kmz" || ending == ".shz") return opened_archive(file.string());
  const bool of_shapefile = ending == ".shx" || ending == ".dbf";
  return {opened_one(of_shapefile ? beside(file, ".shp").value_or(file) : file, file.string())};
}

bool is_plain_geojson(const OwnerData& data) {
  if (std::string_view{SELION_OGR(GDALGetDriverShortName)(
          SELION_OGR(GDALGetDatasetDriver)(data.handle.get()))} != "GeoJSON")
    return false;
  using Json = nlohmann::json;
  const auto only_crs = [](int depth, Json::parse_event_t event, const Json& value) {
    return depth != 1 || event != Json::parse_event_t::key || value == "crs";
  };
  const Json root = Json::parse(text_of(data.path), only_crs, false);
  return root.is_object() && (!root.contains("crs") || root["crs"].is_null());
}

}  // namespace selion::verifying
