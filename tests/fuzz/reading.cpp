// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

#include "field/georeference.hpp"
#include "field/locate.hpp"
#include "selion/core/error.hpp"
#include "selion/field/block.hpp"
#include "selion/field/frame.hpp"

namespace selion::fuzz {
namespace {

/// A folder of this process, gone with it.
class Folder {
 public:
  Folder() : path_{std::filesystem::temp_directory_path() / ("selion_fuzz_" + std::to_string(::getpid()))} {
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  Folder(Folder&&) = delete;
  Folder& operator=(Folder&&) = delete;

  [[nodiscard]] std::filesystem::path written(const std::string& name, const std::string& bytes) const {
    std::ofstream{path_ / name, std::ios::binary} << bytes;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

void clean(const Field& field) {
  for (const Repair repair : {Repair::notes_only, Repair::accept}) {
    try {
      BlockOptions options;
      options.repair = repair;
      static_cast<void>(blocks_of(field, LocalFrame::centred(centre(field)), options));
    } catch (const InputError&) {  // said so: that is what a reader is for
    }
  }
}

}  // namespace

std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

void read_and_clean(const std::string& bytes, const std::string& ending, const ReadOptions& options) {
  static const Folder folder;
  std::istringstream nothing;
  try {
    for (const Field& field : read_fields(folder.written("field" + ending, bytes), options, nothing))
      clean(field);
  } catch (const InputError&) {  // said so
  }
}

void locate_and_clean(const RawFile& file) {
  static Georeference georeference{"OGC:CRS84", "fuzz"};
  for (const RawLayer& layer : file.layers) {
    for (const RawFeature& feature : layer.features) {
      try {
        Field field;
        field.source = "fuzz, feature " + std::to_string(feature.number);
        field.parts = located(feature, georeference, field.source, std::nullopt).polygons;
        if (!field.parts.empty() && !implausibly_large(box_of(feature), georeference)) clean(field);
      } catch (const InputError&) {  // said so
      }
    }
  }
}

}  // namespace selion::fuzz
