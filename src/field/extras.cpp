// SPDX-License-Identifier: GPL-3.0-or-later
#include "extras.hpp"

#include "locate.hpp"
#include "selion/core/error.hpp"

namespace selion {
namespace {

ObstacleKind kind_of(Role role) {
  if (role == Role::water) return ObstacleKind::water;
  return role == Role::no_go ? ObstacleKind::no_go : ObstacleKind::obstacle;
}

std::string text_of(Role role) {
  switch (role) {
    case Role::gate:
      return "a gate";
    case Role::water:
      return "water";
    case Role::no_go:
      return "a no-go area";
    default:
      return "an obstacle";
  }
}

void add_gates(const RawFeature& raw, const Located& at, const std::string& where, std::vector<Gate>& into) {
  if (at.points.empty() || !at.polygons.empty() || !at.lines.empty())
    throw InputError{
        where +
        " is a gate, but no point; give each gate as one point, with its width as a property width_m"};
  const std::string name = name_of(raw).value_or("");
  const auto width_m = metres_attribute(raw, "width_m", where);
  for (const LonLat p : at.points) into.push_back({name, p, width_m});
}

bool near(const LonLatBox& box, const LonLatBox& other) {
  constexpr double kReach_m = 50;
  const Point low = tangent(other.low, box.low);
  const Point high = low + tangent(other.high, other.low);
  const Point far = tangent(box.high, box.low);
  return low.x_m <= far.x_m + kReach_m && high.x_m >= -kReach_m && low.y_m <= far.y_m + kReach_m &&
         high.y_m >= -kReach_m;
}

}  // namespace

void add_extra(const RawFeature& feature, Role role, Source& source, Extras& into, Reading& reading) {
  const std::string where = source.where(feature);
  if (feature.is_empty())  // of an obstacle that was lost nobody would know
    throw InputError{where + " is " + text_of(role) +
                     ", but has no geometry that can be read; give it one, or delete the feature"};
  const Located at = located(feature, *source.georeference, where, reading.options.accept_datum_error_m);
  reading.notes.insert(reading.notes.end(), at.notes.begin(), at.notes.end());
  if (role == Role::gate) {
    add_gates(feature, at, where, into.gates);
    return;
  }
  const std::string name = name_of(feature).value_or("");
  for (LonLatPolygon& area : outlines(at, feature, where))
    into.obstacles.push_back({name, kind_of(role), std::move(area)});
}

void read_extras(const std::filesystem::path& path, Role role, Extras& into, Reading& reading) {
  const RawFile file = read_raw(path, reading.options, reading.standard_input);
  reading.notes.insert(reading.notes.end(), file.notes.begin(), file.notes.end());
  for (const RawLayer& layer : file.layers) {
    if (layer.features.empty()) continue;
    Source source{&file, &layer, role_of_layer(layer.name).value_or(role), std::nullopt};
    if (role == Role::gate) source.role = role;
    georeference(source, reading);
    for (const RawFeature& feature : layer.features) {
      const Role own = source.role_of(feature);
      add_extra(feature, own == Role::field ? role : own, source, into, reading);
    }
  }
}

void attach(const Extras& extras, Field& field) {
  const LonLatBox box = bounds(field.parts);
  for (const Obstacle& obstacle : extras.obstacles)
    if (near(box, bounds({obstacle.area}))) field.obstacles.push_back(obstacle);
  for (const Gate& gate : extras.gates)
    if (near(box, {gate.at, gate.at})) field.gates.push_back(gate);
}

}  // namespace selion
