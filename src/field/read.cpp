// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/field/read.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "gdal_handles.hpp"
#include "locate.hpp"
#include "names.hpp"
#include "neighbours.hpp"
#include "selion/core/error.hpp"
#include "text.hpp"

namespace selion {
namespace {

RawFile load(const std::filesystem::path& file, const ReadOptions& options, std::istream& standard_input) {
  if (file == "-") {
    const std::string text{std::istreambuf_iterator<char>{standard_input}, {}};
    if (text.empty()) throw InputError{"standard input is empty; give the field as GeoJSON"};
    return read_json(text, "standard input", "field");
  }
  const std::string label = file.string();
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw InputError{label + " does not exist; check the name"};
  if (std::filesystem::is_directory(file, error)) return read_with_gdal(file, label);
  if (std::filesystem::file_size(file, error) == 0 && !error)
    throw InputError{label + " is empty; export it anew"};
  const std::string ending = lower(file.extension().string());
  const auto is = [&ending](const auto&... endings) { return ((ending == endings) || ...); };
  const std::string stem = file.stem().string();
  if (is(".csv", ".txt", ".tsv", ".xyz", ".dat", ".pts"))
    return read_text(file_bytes(label, label), label, stem, options);
  if (is(".geojson", ".json")) {
    const std::string text = file_bytes(label, label);
    if (is_geojson(text)) return read_json(text, label, stem);
  }
  return read_with_gdal(file, label);
}

bool has_polygons(const RawFeature& feature) { return !feature.polygons.empty(); }

/// One layer, or several folders, of a file, with its way to WGS84.
struct Source {
  const RawFile* file = nullptr;
  const RawLayer* layer = nullptr;
  std::optional<Role> role;  ///< of the whole layer
  std::optional<Georeference> georeference;

  [[nodiscard]] std::string where() const {
    return file->layers.size() > 1 ? file->label + ", layer " + layer->name : file->label;
  }
  [[nodiscard]] std::string where(const RawFeature& feature) const {
    return where() + ", feature " + std::to_string(feature.number);
  }
  [[nodiscard]] Role role_of(const RawFeature& feature) const {
    return role_of_feature(feature, where(feature)).value_or(role.value_or(Role::field));
  }
};

RawPoint first_position(const RawLayer& layer) {
  for (const RawFeature& feature : layer.features) {
    if (!feature.polygons.empty()) return feature.polygons.front().front().front();
    if (!feature.points.empty()) return feature.points.front();
    if (!feature.lines.empty() && !feature.lines.front().empty()) return feature.lines.front().front();
  }
  return {};
}

/// What the file says, else the option. @throws InputError where neither says, or both and differently.
Georeference georeference_of(const Source& source, const std::optional<std::string>& option,
                             std::vector<std::string>& notes) {
  const RawLayer& layer = *source.layer;
  if (!layer.crs && !option) {
    const RawPoint p = first_position(layer);
    const bool degrees = std::abs(p.x) <= 180 && std::abs(p.y) <= 90;
    throw InputError{source.where() + " has no CRS; its first position is " + shortest(p.x) + ", " +
                     shortest(p.y) +
                     (degrees ? ": give --crs EPSG:4326 if these are WGS84 longitude and latitude"
                              : ": give the CRS it is in, such as --crs EPSG:25832")};
  }
  if (!option || (layer.crs && !layer.crs_is_default)) {
    Georeference own{*layer.crs, source.where()};
    if (option && !same_crs(*layer.crs, *option))
      throw InputError{source.where() + " is in " + own.name() + ", but --crs says " + *option +
                       "; leave --crs out, or correct the file"};
    return own;
  }
  Georeference given{*option, "--crs " + *option};
  if (layer.crs)
    notes.push_back(source.where() + " names no CRS, and is read as " + given.name() + " as --crs says");
  return given;
}

/// Layers whose every polygon is far larger than a field (a data set's extent) hold no fields.
bool holds_fields(Source& source) {
  return std::any_of(source.layer->features.begin(), source.layer->features.end(),
                     [&](const RawFeature& feature) {
                       return has_polygons(feature) && source.role_of(feature) == Role::field &&
                              !implausibly_large(feature, *source.georeference);
                     });
}

[[noreturn]] void no_polygons(const RawFile& file) {
  for (const RawLayer& layer : file.layers)
    for (const RawFeature& feature : layer.features)
      for (const auto& line : feature.lines)
        if (line.size() > 3 && line.front() == line.back())
          throw InputError{file.label + " has no polygon: feature " + std::to_string(feature.number) +
                           " is a closed line; save the boundary as a polygon"};
  throw InputError{file.label + " has no polygon in it; give a file with the field's boundary as a polygon"};
}

std::string layer_names(const std::vector<Source>& sources) {
  std::string names;
  for (const Source& source : sources) names += (names.empty() ? "'" : ", '") + source.layer->name + "'";
  return names;
}

/// The layers to read: those named for a role, and the one (of folders: all) that holds fields.
std::vector<Source> sources_of(const RawFile& file, const ReadOptions& options,
                               std::vector<std::string>& notes) {
  std::vector<Source> with_fields;
  std::vector<Source> roles;
  for (const RawLayer& layer : file.layers) {
    Source source{&file, &layer, role_of_layer(layer.name), std::nullopt};
    const bool wanted = options.layer == layer.name;
    if (wanted || file.layers.size() == 1) source.role.reset();
    const bool polygons = std::any_of(layer.features.begin(), layer.features.end(), has_polygons);
    if (source.role && !layer.features.empty())
      roles.push_back(std::move(source));
    else if (polygons && (wanted || !options.layer))
      with_fields.push_back(std::move(source));
  }
  if (options.layer && std::none_of(file.layers.begin(), file.layers.end(),
                                    [&](const RawLayer& layer) { return layer.name == *options.layer; })) {
    std::vector<std::string> names;
    for (const RawLayer& layer : file.layers) names.push_back(layer.name);
    throw InputError{file.label + " has no layer '" + *options.layer + "'; it has " +
                     nearest_names(names, *options.layer)};
  }
  if (with_fields.empty()) no_polygons(file);
  for (Source& source : with_fields) source.georeference.emplace(georeference_of(source, options.crs, notes));
  for (Source& source : roles) source.georeference.emplace(georeference_of(source, options.crs, notes));
  if (with_fields.size() > 1) {
    std::vector<Source> kept;
    for (Source& source : with_fields) {
      if (holds_fields(source))
        kept.push_back(std::move(source));
      else
        notes.push_back(source.where() +
                        " holds no field (extents more than 100 km across, or no boundaries); skipped");
    }
    if (kept.size() > 1 && !file.layers_are_folders)
      throw InputError{file.label + " has several layers with polygons: " + layer_names(kept) +
                       "; choose one with --layer"};
    if (kept.empty())
      throw InputError{file.label +
                       " has only polygons more than 100 km across; give one with field boundaries"};
    with_fields = std::move(kept);
  }
  std::move(roles.begin(), roles.end(), std::back_inserter(with_fields));
  return with_fields;
}

/// What lies in or beside fields, not yet given to any.
struct Extras {
  std::vector<Obstacle> obstacles;
  std::vector<Gate> gates;
};

void add_extra(const RawFeature& raw, Role role, const std::string& where, Source& source,
               const ReadOptions& options, Extras& into, std::vector<std::string>& notes) {
  const Located at = located(raw, *source.georeference, where, options.accept_datum_error_m);
  std::copy(at.notes.begin(), at.notes.end(), std::back_inserter(notes));
  const std::string name = name_of(raw).value_or("");
  if (role == Role::gate) {
    if (at.points.empty() || !at.polygons.empty() || !at.lines.empty())
      throw InputError{
          where +
          " is a gate, but no point; give each gate as one point, with its width as a property width_m"};
    const auto width_m = metres_attribute(raw, "width_m", where);
    for (const LonLat p : at.points) into.gates.push_back({name, p, width_m});
    return;
  }
  const ObstacleKind kind = role == Role::water   ? ObstacleKind::water
                            : role == Role::no_go ? ObstacleKind::no_go
                                                  : ObstacleKind::obstacle;
  for (LonLatPolygon& area : outlines(at, raw, where))
    into.obstacles.push_back({name, kind, std::move(area)});
}

bool is_empty(const RawFeature& raw) {
  return raw.polygons.empty() && raw.lines.empty() && raw.points.empty();
}

/// A file of nothing but obstacles, or gates.
void read_extras(const std::filesystem::path& path, Role role, const ReadOptions& options,
                 std::istream& standard_input, Extras& into, std::vector<std::string>& notes) {
  const RawFile file = load(path, options, standard_input);
  std::copy(file.notes.begin(), file.notes.end(), std::back_inserter(notes));
  for (const RawLayer& layer : file.layers) {
    if (layer.features.empty()) continue;
    Source source{&file, &layer, role_of_layer(layer.name).value_or(role), std::nullopt};
    if (role == Role::gate) source.role = role;
    source.georeference.emplace(georeference_of(source, options.crs, notes));
    for (const RawFeature& feature : layer.features) {
      const Role own = source.role_of(feature);
      if (!is_empty(feature))
        add_extra(feature, own == Role::field ? role : own, source.where(feature), source, options, into,
                  notes);
    }
  }
}

bool near(const LonLatBox& box, const LonLatBox& other) {
  constexpr double kReach_m = 50;
  const Point low = tangent(other.low, box.low);
  const Point high = low + tangent(other.high, other.low);
  const Point far = tangent(box.high, box.low);
  return low.x_m <= far.x_m + kReach_m && high.x_m >= -kReach_m && low.y_m <= far.y_m + kReach_m &&
         high.y_m >= -kReach_m;
}

void attach(const Extras& extras, Field& field) {
  const LonLatBox box = bounds(field.parts);
  for (const Obstacle& obstacle : extras.obstacles)
    if (near(box, bounds({obstacle.area}))) field.obstacles.push_back(obstacle);
  for (const Gate& gate : extras.gates)
    if (near(box, {gate.at, gate.at})) field.gates.push_back(gate);
}

/// A field feature and where it came from.
struct Candidate {
  const RawFeature* raw = nullptr;
  Source* source = nullptr;
};

std::optional<Field> field_of(const Candidate& candidate, std::string name, const ReadOptions& options,
                              std::vector<std::string>& notes) {
  Source& source = *candidate.source;
  const std::string where = source.where(*candidate.raw);
  Located at = located(*candidate.raw, *source.georeference, where, options.accept_datum_error_m);
  if (implausibly_large(*candidate.raw, *source.georeference)) {
    notes.push_back(where + " is more than 100 km across, and no field; skipped");
    return std::nullopt;
  }
  Field field;
  field.number = candidate.raw->number;
  field.name = std::move(name);
  field.parts = std::move(at.polygons);
  field.source = where;
  field.source_crs = source.georeference->name();
  field.datum = source.georeference->datum();
  field.datum_accuracy_m = at.datum_accuracy_m;
  field.attributes = candidate.raw->attributes;
  field.notes = std::move(at.notes);
  if (!at.points.empty() || !at.lines.empty())
    field.notes.push_back(where + ": its points and lines are skipped");
  return field;
}

struct Sorted {
  std::vector<Candidate> candidates;
  Extras extras;
};

/// Features by role; those that no field can be made of are skipped with a note.
Sorted sorted_by_role(std::vector<Source>& sources, const ReadOptions& options,
                      std::vector<std::string>& notes) {
  Sorted sorted;
  for (Source& source : sources) {
    std::string skipped;
    for (const RawFeature& feature : source.layer->features) {
      const Role role = source.role_of(feature);
      if (role != Role::field && !is_empty(feature))
        add_extra(feature, role, source.where(feature), source, options, sorted.extras, notes);
      else if (has_polygons(feature))
        sorted.candidates.push_back({&feature, &source});
      else
        skipped += (skipped.empty() ? "" : ", ") + std::to_string(feature.number);
    }
    if (!skipped.empty())
      notes.push_back(source.where() + ": skipped, having no polygon: feature " + skipped);
  }
  return sorted;
}

}  // namespace

std::vector<Field> read_fields(const std::filesystem::path& path, const ReadOptions& options,
                               std::istream& standard_input) {
  const RawFile file = load(path, options, standard_input);
  std::vector<std::string> notes = file.notes;
  std::vector<Source> sources = sources_of(file, options, notes);
  Sorted sorted = sorted_by_role(sources, options, notes);
  if (sorted.candidates.empty()) no_polygons(file);
  if (options.obstacles)
    read_extras(*options.obstacles, Role::obstacle, options, standard_input, sorted.extras, notes);
  if (options.gates) read_extras(*options.gates, Role::gate, options, standard_input, sorted.extras, notes);

  std::vector<const RawFeature*> features;
  for (const Candidate& candidate : sorted.candidates) features.push_back(candidate.raw);
  const std::vector<std::string> names = unique_names(features, file.stem);
  std::vector<std::size_t> wanted(features.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = i;
  if (options.field) wanted = {selected(features, names, *options.field, file.label)};

  std::vector<Field> fields;
  for (const std::size_t i : wanted)
    if (auto field = field_of(sorted.candidates[i], names[i], options, notes))
      fields.push_back(std::move(*field));
  if (fields.empty())
    throw InputError{notes.empty() ? file.label + " holds no field"
                                   : notes.back() + "; give a file with field boundaries"};
  for (Field& field : fields) attach(sorted.extras, field);
  note_neighbours(fields);
  fields.front().notes.insert(fields.front().notes.begin(), notes.begin(), notes.end());
  return fields;
}

}  // namespace selion
