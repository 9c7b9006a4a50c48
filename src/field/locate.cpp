// SPDX-License-Identifier: GPL-3.0-or-later
#include "locate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "selion/core/error.hpp"
#include "selion/core/units.hpp"
#include "text.hpp"

namespace selion {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAxis_m = 6378137;  // WGS84
constexpr double kEccentricitySquared = 0.00669437999014;

class Locator {
 public:
  Locator(Georeference& georeference, std::string where)
      : georeference_{georeference}, where_{std::move(where)} {}

  void choose_step(RawPoint middle, Located& into, std::optional<double> accept_m) {
    step_ = &georeference_.step_at(middle);
    into.datum_accuracy_m = step_->accuracy_m;
    if (auto note = georeference_.outside_area_of_use(middle, where_)) into.notes.push_back(std::move(*note));
    if (auto note = datum_note(accept_m)) into.notes.push_back(std::move(*note));
  }

  void check(const std::vector<RawPoint>& points, const std::string& what) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::string at = where_ + what + ", coordinate " + std::to_string(i + 1);
      if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y))
        throw InputError{at + " is not a finite number; correct or delete it"};
      georeference_.check(points[i], at);
    }
  }

  [[nodiscard]] std::vector<LonLat> line(const std::vector<RawPoint>& points) const {
    std::vector<LonLat> line;
    line.reserve(points.size());
    for (const RawPoint p : points) line.push_back(georeference_.converted(p, *step_));
    return line;
  }

  LonLatRing ring(RawRing raw, const std::string& what, std::vector<std::string>& notes) const {
    const std::size_t given = raw.size();
    const bool closed = given > 1 && raw.front() == raw.back();
    if (closed) raw.pop_back();
    if (raw.size() < 3)
      throw InputError{where_ + what + " has " + std::to_string(given) +
                       " positions, a closed ring needs 4; correct or delete it"};
    if (!closed) notes.push_back(where_ + what + " is not closed; its last corner is joined to its first");
    LonLatRing ring = line(raw);
    double turn_deg = 0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      turn_deg += std::remainder(ring[i].lon_deg - ring[j].lon_deg, 360);
    if (std::abs(turn_deg) > 180)
      throw InputError{where_ + what + " goes around a pole; such a field cannot be planned"};
    return ring;
  }

 private:
  [[nodiscard]] std::optional<std::string> datum_note(std::optional<double> accept_m) const {
    constexpr double kWorthANote_m = 1;
    constexpr double kMost_m = 5;
    constexpr double kUnknown_m = 1000;  // a step without a datum shift can be hundreds of metres off
    const double accuracy = step_->accuracy_m.value_or(kUnknown_m);
    if (accuracy <= kWorthANote_m) return std::nullopt;
    std::string grids;
    for (const std::string& grid : step_->missing_grids) grids += (grids.empty() ? "" : ", ") + grid;
    const std::string better =
        grids.empty() ? "PROJ knows no better way" : "PROJ's grid " + grids + " is missing: install it";
    const std::string text = where_ + ": the step from the datum of " + georeference_.name() + " to WGS84 (" +
                             step_->name + ") is " +
                             (step_->accuracy_m ? "good to " + shortest(accuracy) + " m only"
                                                : "of unknown accuracy, perhaps hundreds of metres off");
    if (accuracy > accept_m.value_or(kMost_m))
      throw InputError{text + "; " + better + ", or go on with --accept-datum-error " + shortest(accuracy)};
    return text + "; " + better;
  }

  Georeference& georeference_;
  std::string where_;
  const DatumStep* step_ = nullptr;
};

std::string part_name(const RawFeature& feature, std::size_t part, std::size_t ring) {
  const std::string of_part = feature.polygons.size() > 1 ? ", part " + std::to_string(part + 1) : "";
  return of_part + ", ring " + std::to_string(ring + 1);
}

}  // namespace

RawBox box_of(const RawFeature& feature) {
  RawBox box;
  for (const RawPolygon& polygon : feature.polygons)
    for (const RawRing& ring : polygon)
      for (const RawPoint p : ring) box.add(p);
  for (const auto& line : feature.lines)
    for (const RawPoint p : line) box.add(p);
  for (const RawPoint p : feature.points) box.add(p);
  return box;
}

Located located(const RawFeature& feature, Georeference& georeference, const std::string& where,
                std::optional<double> accept_datum_error_m) {
  Located result;
  result.notes = feature.notes;
  for (std::string& note : result.notes) note.insert(0, where + ": ");
  Locator locator{georeference, where};
  for (std::size_t part = 0; part < feature.polygons.size(); ++part)
    for (std::size_t ring = 0; ring < feature.polygons[part].size(); ++ring)
      locator.check(feature.polygons[part][ring], part_name(feature, part, ring));
  for (const auto& line : feature.lines) locator.check(line, ", line");
  locator.check(feature.points, "");
  const RawBox box = box_of(feature);
  if (box.empty()) return result;
  locator.choose_step(box.middle(), result, accept_datum_error_m);
  for (std::size_t part = 0; part < feature.polygons.size(); ++part) {
    LonLatPolygon polygon;
    for (std::size_t ring = 0; ring < feature.polygons[part].size(); ++ring) {
      LonLatRing one =
          locator.ring(feature.polygons[part][ring], part_name(feature, part, ring), result.notes);
      if (ring == 0)
        polygon.shell = std::move(one);
      else
        polygon.holes.push_back(std::move(one));
    }
    result.polygons.push_back(std::move(polygon));
  }
  for (const auto& line : feature.lines) result.lines.push_back(locator.line(line));
  result.points = locator.line(feature.points);
  return result;
}

bool implausibly_large(const RawBox& box, Georeference& georeference) {
  constexpr double kLargest_m = 100e3;
  if (box.empty() || !std::isfinite(box.low.x + box.low.y) || !std::isfinite(box.high.x + box.high.y))
    return false;
  const DatumStep& step = georeference.step_at(box.middle());
  const LonLat low = georeference.converted(box.low, step);
  const LonLat high = georeference.converted(box.high, step);
  if (!(std::abs(low.lat_deg) <= 90) || !(std::abs(high.lat_deg) <= 90))
    return false;  // out of range: said elsewhere
  return length_m(tangent(high, low)) > kLargest_m;
}

Point tangent(LonLat p, LonLat reference) {
  const double lat_rad = radians_of_degrees(reference.lat_deg);
  const double w2 = 1 - kEccentricitySquared * std::sin(lat_rad) * std::sin(lat_rad);
  const double normal_m = kAxis_m / std::sqrt(w2);
  const double meridian_m = normal_m * (1 - kEccentricitySquared) / w2;
  return {
      radians_of_degrees(std::remainder(p.lon_deg - reference.lon_deg, 360)) * normal_m * std::cos(lat_rad),
      radians_of_degrees(p.lat_deg - reference.lat_deg) * meridian_m};
}

LonLat from_tangent(Point p, LonLat reference) {
  const LonLat next{reference.lon_deg + 1e-3, reference.lat_deg + 1e-3};
  const Point scale = 1e3 * tangent(next, reference);  // metres in a degree, both ways
  return {reference.lon_deg + p.x_m / scale.x_m, reference.lat_deg + p.y_m / scale.y_m};
}

LonLatBox bounds(const std::vector<LonLatPolygon>& polygons) {
  LonLatBox box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const LonLatPolygon& polygon : polygons) {
    for (const LonLat p : polygon.shell) {
      const double reference = box.low.lon_deg == kInfinity ? p.lon_deg : box.low.lon_deg;
      const double lon = reference + std::remainder(p.lon_deg - reference, 360);
      box.low = {std::min(box.low.lon_deg, lon), std::min(box.low.lat_deg, p.lat_deg)};
      box.high = {std::max(box.high.lon_deg, lon), std::max(box.high.lat_deg, p.lat_deg)};
    }
  }
  return box;
}

}  // namespace selion
