// SPDX-License-Identifier: GPL-3.0-or-later
// The main file of a shapefile, record by record (ESRI Shapefile Technical Description, 1998): GDAL reads on
// past much of what is broken here.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "raw.hpp"
#include "selion/core/error.hpp"

namespace selion {
namespace {

constexpr std::size_t kHeader = 100;
constexpr std::size_t kRecordHeader = 8;
constexpr std::size_t kBox = 4 + 32;  // shape type and bounding box

class Bytes {
 public:
  explicit Bytes(const std::string& all) : all_{all} {}
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] std::uint32_t big(std::size_t at) const { return word(at, true); }
  [[nodiscard]] std::uint32_t little(std::size_t at) const { return word(at, false); }
  [[nodiscard]] double number(std::size_t at) const {
    const std::uint64_t low = little(at);
    const std::uint64_t high = little(at + 4);
    return std::bit_cast<double>((high << 32) | low);
  }

 private:
  [[nodiscard]] std::uint32_t word(std::size_t at, bool big_endian) const {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k)
      value |= std::uint32_t{static_cast<unsigned char>(all_[at + k])} << (8 * (big_endian ? 3 - k : k));
    return value;
  }
  const std::string& all_;
};

/// Polylines and polygons, plain, with Z or with M: type, box, counts, parts, points.
bool has_parts(std::uint32_t type) { return type % 10 == 3 || type % 10 == 5; }

void check_parts(const Bytes& bytes, std::size_t at, std::size_t length, const std::string& where) {
  if (length < kBox + 8) throw InputError{where + " is too short for a polygon; export the shapefile anew"};
  const std::uint64_t parts = bytes.little(at + kBox);
  const std::uint64_t points = bytes.little(at + kBox + 4);
  const std::uint64_t need = kBox + 8 + 4 * parts + 16 * points;
  if (need > length)
    throw InputError{where + " claims " + std::to_string(parts) + " parts and " + std::to_string(points) +
                     " points, more than it holds; export the shapefile anew"};
  const std::size_t first = at + kBox + 8 + 4 * static_cast<std::size_t>(parts);
  for (std::size_t i = 0; i < points; ++i) {
    if (!std::isfinite(bytes.number(first + 16 * i)) || !std::isfinite(bytes.number(first + 16 * i + 8)))
      throw InputError{where + ", coordinate " + std::to_string(i + 1) +
                       " is not a finite number; correct or delete it"};
  }
}

}  // namespace

void check_shapefile(const std::string& bytes, const std::string& label) {
  const Bytes file{bytes};
  constexpr std::uint32_t kFileCode = 9994;
  if (file.size() < kHeader || file.big(0) != kFileCode)
    throw InputError{label + " is no shapefile, or cut off; export it anew"};
  const std::uint64_t claimed = std::uint64_t{file.big(24)} * 2;
  std::size_t at = kHeader;
  for (int number = 1; at < file.size() && at < claimed; ++number) {
    const std::string where = label + ", feature " + std::to_string(number);
    if (at + kRecordHeader > file.size())
      throw InputError{where + " is cut off by the end of the file; export the shapefile anew"};
    const std::uint64_t length = std::uint64_t{file.big(at + 4)} * 2;
    at += kRecordHeader;
    if (length < 4 || length > file.size() - at)
      throw InputError{where + " is " + std::to_string(length) +
                       " bytes long, past the end of the file; it is truncated: copy or export it anew"};
    if (has_parts(file.little(at))) check_parts(file, at, static_cast<std::size_t>(length), where);
    at += static_cast<std::size_t>(length);
  }
  if (claimed > file.size())
    throw InputError{label + " is truncated: " + std::to_string(file.size()) + " of " +
                     std::to_string(claimed) + " bytes are there; copy or export it anew"};
}

}  // namespace selion
