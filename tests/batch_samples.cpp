// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch_samples.hpp"

#include <fstream>
#include <iterator>
#include <random>

#include "selion/core/format.hpp"
#include "selion/plan/job_file.hpp"

namespace selion {

namespace fs = std::filesystem;

BatchScratch::BatchScratch()
    : at{fs::temp_directory_path() / ("selion-batch-" + std::to_string(std::random_device{}()))} {
  fs::create_directories(at);
}
BatchScratch::~BatchScratch() {
  std::error_code ignored;
  fs::remove_all(at, ignored);
}

fs::path small_fields(const fs::path& folder, int count) {
  fs::path file = folder / "small.geojson";
  std::ofstream out{file};
  out << R"({"type":"FeatureCollection","features":[)";
  for (int i = 1; i <= count; ++i) {
    const double west = 3.43 + 0.002 * i;
    const double east = west + (i % 3 == 0 ? 0.00004 : 0.0008);
    const double low = 46.336;
    const double high = low + 0.0006 + 0.00001 * i;
    const auto at = [](double lon, double lat) { return "[" + fixed(lon, 7) + "," + fixed(lat, 7) + "]"; };
    const bool crossed = i % 5 == 0;
    out << (i == 1 ? "" : ",") << R"({"type":"Feature","properties":{"name":"field, )" << i
        << R"("},"geometry":{"type":"Polygon","coordinates":[[)" << at(west, low) << ','
        << at(crossed ? west : east, crossed ? high : low) << ',' << at(east, crossed ? low : high) << ','
        << at(crossed ? east : west, high) << ',' << at(west, low) << "]]}}";
  }
  out << "]}";
  return file;
}

BatchOptions small_batch(const fs::path& fields, const fs::path& folder) {
  BatchOptions options;
  options.fields = fields;
  options.folder = folder;
  options.job = job_of({});
  return options;
}

BatchWatch nobody() {
  return {[](const BatchProgress&) {}, [](const std::string&) {}, [] { return false; }};
}

std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder}) {
    if (!entry.is_regular_file()) continue;
    std::ifstream stream{entry.path(), std::ios::binary};
    files[entry.path().lexically_relative(folder).string()] =
        std::string{std::istreambuf_iterator<char>{stream}, {}};
  }
  return files;
}

}  // namespace selion
