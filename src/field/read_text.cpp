// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates as people type them or survey programs write them: one position a line.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "raw.hpp"
#include "selion/core/error.hpp"
#include "text.hpp"

namespace selion {
namespace {

constexpr std::string_view kBlanks = " \t\r\"'";

std::string_view trimmed(std::string_view text) {
  const auto from = text.find_first_not_of(kBlanks);
  return from == std::string_view::npos ? std::string_view{}
                                        : text.substr(from, text.find_last_not_of(kBlanks) - from + 1);
}

std::vector<std::string_view> split(std::string_view line, std::string_view separators) {
  std::vector<std::string_view> tokens;
  while (true) {
    const auto end = line.find_first_of(separators);
    tokens.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return tokens;
    line.remove_prefix(end + 1);
  }
}

/// The separator is the strongest one in the line; with any but the comma itself, a comma is a decimal one.
std::vector<std::string_view> columns(std::string_view line) {
  for (const std::string_view separator : {";", "\t", ","})
    if (line.find(separator) != std::string_view::npos) return split(line, separator);
  std::vector<std::string_view> tokens = split(line, " ");
  std::erase_if(tokens, [](std::string_view token) { return token.empty(); });
  return tokens;
}

enum class Axis { unknown, lon, lat };

struct Ordinate {
  double value = 0;
  Axis axis = Axis::unknown;  ///< where a hemisphere letter says
  bool signed_twice = false;  ///< "-5 W": by the sign and by the letter
};

struct Hemisphere {
  Axis axis = Axis::unknown;
  double sign = 1;
};

std::optional<Hemisphere> hemisphere(char letter) {
  switch (letter) {
    case 'N':
    case 'n':
      return Hemisphere{Axis::lat, 1};
    case 'S':
    case 's':
      return Hemisphere{Axis::lat, -1};
    case 'E':
    case 'e':
      return Hemisphere{Axis::lon, 1};
    case 'W':
    case 'w':
      return Hemisphere{Axis::lon, -1};
    default:
      return std::nullopt;
  }
}

/// Takes the letter off one end of `text`.
Hemisphere take_hemisphere(std::string_view& text) {
  if (text.empty()) return {};
  if (const auto before = hemisphere(text.front())) {
    text = trimmed(text.substr(1));
    return *before;
  }
  if (const auto behind = hemisphere(text.back())) {
    text = trimmed(text.substr(0, text.size() - 1));
    return *behind;
  }
  return {};
}

/// "9.887", "-9,887", "E 9.887", "9.887 W", "9.887°".
std::optional<Ordinate> ordinate(std::string_view text) {
  std::string token{text};
  std::replace(token.begin(), token.end(), ',', '.');
  if (const auto degree = token.find("\xC2\xB0"); degree != std::string::npos) token.erase(degree, 2);
  std::string_view rest = trimmed(token);
  const Hemisphere side = take_hemisphere(rest);
  const bool signed_twice = side.axis != Axis::unknown && (rest.starts_with('-') || rest.starts_with('+'));
  if (rest.starts_with('+')) rest.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc{} || end != rest.data() + rest.size() || !std::isfinite(value)) return std::nullopt;
  return Ordinate{side.sign * value, side.axis, signed_twice};
}

struct Columns {
  std::size_t lon = 0;
  std::size_t lat = 1;
};

/// Of a header such as "id;Latitude [deg];Longitude".
std::optional<Columns> header(const std::vector<std::string_view>& names) {
  constexpr std::array<std::string_view, 7> kLon{"lon", "long", "longitude", "lng", "x", "easting", "east"};
  constexpr std::array<std::string_view, 5> kLat{"lat", "latitude", "y", "northing", "north"};
  std::optional<std::size_t> lon;
  std::optional<std::size_t> lat;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = lower(names[i]);
    const std::string word = name.substr(0, name.find_first_of(" _([/"));
    if (!lon && std::find(kLon.begin(), kLon.end(), word) != kLon.end()) lon = i;
    if (!lat && std::find(kLat.begin(), kLat.end(), word) != kLat.end()) lat = i;
  }
  if (!lon || !lat) return std::nullopt;
  return Columns{*lon, *lat};
}

class TextReader {
 public:
  TextReader(std::string label, const ReadOptions& options)
      : label_{std::move(label)}, degrees_{!options.crs} {
    if (options.axis == AxisOrder::latlon) columns_ = {1, 0};
  }

  void line(std::string_view whole) {
    ++number_;
    const bool is_comment = whole.find('#') != std::string_view::npos;
    const std::string_view text = whole.substr(0, whole.find('#'));
    if (trimmed(text).empty()) {
      if (!is_comment) end_ring();  // a comment between two positions does not part them
      return;
    }
    const auto tokens = columns(text);
    if (!seen_data_ && take_header(tokens)) return;
    seen_data_ = true;
    ring_.push_back(position(tokens));
  }

  RawPolygon finish() {
    end_ring();
    if (polygon_.empty())
      throw InputError{label_ + " holds no coordinates; give one 'longitude, latitude' a line"};
    return std::move(polygon_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError{label_ + ", line " + std::to_string(number_) + ": " + what};
  }

  void end_ring() {
    if (ring_.empty()) return;
    if (ring_.size() < 3)
      fail("a ring of " + std::to_string(ring_.size()) + " positions ends here; it needs 3 at least");
    if (!(ring_.front() == ring_.back()))
      ring_.push_back(ring_.front());  // nobody types the first position twice
    polygon_.push_back(std::move(ring_));
    ring_.clear();
  }

  bool take_header(const std::vector<std::string_view>& tokens) {
    const auto found = header(tokens);
    if (found) columns_ = *found, named_ = tokens.size();
    return found.has_value();
  }

  [[nodiscard]] RawPoint position(const std::vector<std::string_view>& tokens) const {
    if (tokens.size() <= std::max(columns_.lon, columns_.lat))
      fail(
          "two numbers are needed, longitude and latitude in decimal degrees, such as '9.8876350, "
          "56.4645152'");
    const bool decimal_commas = tokens.size() == 4 && named_ != tokens.size() &&
                                std::all_of(tokens.begin(), tokens.end(), [](std::string_view token) {
                                  return token.find_first_not_of("0123456789-+") == std::string_view::npos;
                                });
    if (decimal_commas) fail("decimal commas need semicolons or tabs between the numbers");
    auto lon = number(tokens[columns_.lon]);
    auto lat = number(tokens[columns_.lat]);
    if (lon.axis == Axis::lat || lat.axis == Axis::lon) std::swap(lon, lat);
    if (lon.axis == Axis::lat || lat.axis == Axis::lon) fail("both numbers carry letters of the same axis");
    if (degrees_) check_range(lon.value, lat.value);
    return {lon.value, lat.value};
  }

  [[nodiscard]] Ordinate number(std::string_view token) const {
    const auto found = ordinate(token);
    if (!found)
      fail("'" + std::string{token.substr(0, 40)} +
           "' is no number in decimal degrees; correct it, or put '#' before a comment");
    if (found->signed_twice)
      fail("'" + std::string{token.substr(0, 40)} + "' has a sign and a letter; leave one of them out");
    return *found;
  }

  void check_range(double lon, double lat) const {
    if (std::abs(lat) > 90)
      fail("latitude " + shortest(lat) +
           " is outside -90 to 90; are longitude and latitude swapped (--axis latlon)?");
    if (std::abs(lon) > 180)
      fail("longitude " + shortest(lon) + " is outside -180 to 180; for metres give their --crs EPSG:CODE");
  }

  std::string label_;
  bool degrees_;
  Columns columns_;
  std::size_t named_ = 0;  // columns, by a header
  int number_ = 0;
  bool seen_data_ = false;
  RawRing ring_;
  RawPolygon polygon_;
};

}  // namespace

RawFile read_text(const std::string& bytes, const std::string& label, const std::string& stem,
                  const ReadOptions& options) {
  if (bytes.find('\0') != std::string::npos)
    throw InputError{label + " is no text file; give one 'longitude, latitude' a line"};
  TextReader reader{label, options};
  std::string_view rest = bytes;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  while (!rest.empty()) {
    const auto end = rest.find('\n');
    reader.line(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  RawFeature feature;
  feature.polygons.push_back(reader.finish());
  RawFile file;
  file.label = label;
  file.stem = stem;
  file.layers.push_back({stem, "OGC:CRS84", true, {std::move(feature)}});
  return file;
}

}  // namespace selion
