// SPDX-License-Identifier: GPL-3.0-or-later
#include "input.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "selion/core/error.hpp"
#include "selion/core/input_file.hpp"
#include "selion/core/version.hpp"
#include "selion/plan/job_file.hpp"

namespace selion {
namespace {

namespace fs = std::filesystem;

constexpr auto kEndings =
    std::to_array<std::string_view>({".geojson", ".json", ".gpkg", ".shp", ".shz", ".zip", ".kml", ".kmz",
                                     ".gml", ".fgb", ".gdb", ".tab", ".mif", ".sqlite", ".csv", ".tsv"});

/// Files of the same name that have a say in the fields of one with this ending.
struct Companions {
  std::string_view of;
  std::array<const char*, 4> endings;  // null: no more
};
constexpr auto kCompanions = std::to_array<Companions>({{".shp", {".shx", ".dbf", ".prj", ".cpg"}},
                                                        {".tab", {".dat", ".map", ".id", ".ind"}},
                                                        {".mif", {".mid"}},
                                                        {".gml", {".gfs", ".xsd"}}});

std::string lower_ending(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

bool is_field_file(const fs::path& path) {
  return !path.filename().string().starts_with('.') &&
         std::ranges::find(kEndings, lower_ending(path)) != kEndings.end();
}

void collect(const fs::path& root, const fs::path& left_out, std::vector<InputFile>& files) {
  const auto options = fs::directory_options::skip_permission_denied;
  for (auto entry = fs::recursive_directory_iterator{root, options};
       entry != fs::recursive_directory_iterator{}; ++entry) {
    const fs::path& path = entry->path();
    std::error_code ignored;
    const bool folder = entry->is_directory(ignored);
    const bool dataset = folder && lower_ending(path) == ".gdb";
    const bool hidden = path.filename().string().starts_with('.');
    if (folder && (dataset || hidden || fs::equivalent(path, left_out, ignored)))
      entry.disable_recursion_pending();
    const bool endless = entry->is_fifo(ignored) || entry->is_character_file(ignored);  // or never written to
    if (is_field_file(path) && (!folder || dataset) && !endless)
      files.push_back({path, path.lexically_relative(root).generic_string()});
  }
}

/// Of many bytes, quickly; no protection against forgery.
class Hash {
 public:
  void add(std::string_view bytes) {
    for (; bytes.size() >= 8; bytes.remove_prefix(8)) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data(), 8);
      mix(word);
    }
    std::uint64_t rest = bytes.size() + 1;
    for (const char byte : bytes) rest = rest << 8U | static_cast<unsigned char>(byte);
    mix(rest);
  }
  void add_file(const fs::path& path) {
    refuse_endless(path);
    std::ifstream file{path, std::ios::binary};
    std::string block(1U << 20U, '\0');
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())), file.gcount() > 0)
      add(std::string_view{block}.substr(0, static_cast<std::size_t>(file.gcount())));
    add(file.is_open() ? "read" : "unreadable");
  }
  [[nodiscard]] std::string text() const {
    std::string digits(16, '0');
    std::uint64_t rest = state_;
    for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, rest >>= 4U)
      *digit = "0123456789abcdef"[rest & 15U];
    return digits;
  }

 private:
  void mix(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x9e3779b97f4a7c15;
    state_ ^= state_ >> 32U;
  }
  std::uint64_t state_ = 0xcbf29ce484222325;
};

void add_companion(Hash& hash, const fs::path& path, std::string ending) {
  hash.add_file(fs::path{path}.replace_extension(ending));
  for (char& c : ending) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  hash.add_file(fs::path{path}.replace_extension(ending));
}

void add_input(Hash& hash, const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    std::vector<fs::path> parts;
    for (const fs::directory_entry& entry : fs::directory_iterator{path, ignored})
      parts.push_back(entry.path());
    std::ranges::sort(parts);
    for (const fs::path& part : parts) hash.add_file(part);
    return;
  }
  hash.add_file(path);
  for (const Companions& companions : kCompanions)
    if (lower_ending(path) == companions.of)
      for (const char* ending : companions.endings)
        if (ending != nullptr) add_companion(hash, path, ending);
  // SQLite keeps the latest edits here until it is told to tidy up; one that is empty says no more than none
  const fs::path log = path.string() + "-wal";
  if (std::error_code none; fs::file_size(log, none) > 0 && !none) hash.add_file(log);
}

std::string input_hash(const BatchOptions& options, const std::vector<InputFile>& files) {
  Hash hash;
  for (const InputFile& file : files) {
    hash.add(file.name);
    add_input(hash, file.path);
  }
  for (const auto& extra : {options.read.obstacles, options.read.gates}) {
    hash.add(extra ? "extra" : "none");
    if (extra) add_input(hash, *extra);
  }
  return hash.text();
}

std::string options_hash(const BatchOptions& options) {
  const ReadOptions& read = options.read;
  Hash hash;
  for (const auto& text : {read.layer, read.crs, options.date}) hash.add(text ? "=" + *text : "none");
  hash.add(read.axis == AxisOrder::lonlat ? "lonlat" : "latlon");
  hash.add(read.accept_datum_error_m ? std::to_string(*read.accept_datum_error_m) : "none");
  hash.add(options.repair == Repair::accept ? "repair" : "none");
  hash.add(options.check == BatchCheck::verify ? "verify" : "none");
  hash.add(options.maps == BatchMaps::drawn ? "maps" : "none");
  return hash.text();
}

}  // namespace

std::vector<InputFile> input_files(const fs::path& fields, const fs::path& batch_folder) {
  std::error_code ignored;
  if (!fs::exists(fields, ignored)) throw InputError{fields.string() + " does not exist; check the name"};
  if (!fs::is_directory(fields, ignored) || lower_ending(fields) == ".gdb")
    return {{fields, fields.filename().string()}};
  if (fs::equivalent(fields, batch_folder, ignored))
    throw InputError{fields.string() +
                     " is to be read and written to: plans would lie among the fields; give another -o DIR"};
  std::vector<InputFile> files;
  collect(fields, batch_folder, files);
  std::ranges::sort(files, {}, &InputFile::name);
  if (files.empty()) {
    std::string endings;
    for (const std::string_view ending : kEndings)
      endings += (endings.empty() ? "" : " ") + std::string{ending};
    throw InputError{fields.string() + " holds no field file (" + endings + "), nor do the folders below it"};
  }
  return files;
}

BatchIdentity identity_of(const BatchOptions& options, const std::vector<InputFile>& files) {
  Hash job;
  job.add(job_json(options.job));
  return {std::string{version()}, input_hash(options, files), job.text(), options_hash(options)};
}

}  // namespace selion
