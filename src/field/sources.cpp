// SPDX-License-Identifier: GPL-3.0-or-later
#include "sources.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "locate.hpp"
#include "selion/core/error.hpp"
#include "text.hpp"

namespace selion {
namespace {

RawPoint first_position(const RawLayer& layer) {
  for (const RawFeature& feature : layer.features) {
    for (const RawPolygon& polygon : feature.polygons)
      for (const RawRing& ring : polygon)
        if (!ring.empty()) return ring.front();
    if (!feature.points.empty()) return feature.points.front();
    if (!feature.lines.empty() && !feature.lines.front().empty()) return feature.lines.front().front();
  }
  return {};
}

[[noreturn]] void refuse_without_crs(const Source& source) {
  const RawPoint p = first_position(*source.layer);
  const bool degrees = std::abs(p.x) <= 180 && std::abs(p.y) <= 90;
  throw InputError{source.where() + " has no CRS; its first position is " + shortest(p.x) + ", " +
                   shortest(p.y) +
                   (degrees ? ": give --crs EPSG:4326 if these are WGS84 longitude and latitude"
                            : ": give the CRS it is in, such as --crs EPSG:25832")};
}

Georeference georeference_of(const Source& source, Reading& reading) {
  const RawLayer& layer = *source.layer;
  const auto& option = reading.options.crs;
  if (!layer.crs && !option) refuse_without_crs(source);
  if (!option || (layer.crs && !layer.crs_is_default)) {
    Georeference own{*layer.crs, source.where()};
    if (option && !same_crs(*layer.crs, *option))
      throw InputError{source.where() + " is in " + own.name() + ", but --crs says " + *option +
                       "; leave --crs out, or correct the file"};
    return own;
  }
  Georeference given{*option, "--crs " + *option};
  if (layer.crs)
    reading.notes.push_back(source.where() + " names no CRS, and is read as " + given.name() +
                            " as --crs says");
  return given;
}

/// @throws InputError where the file lacks the layer that was asked for.
void check_wanted_layer(const RawFile& file, const std::optional<std::string>& wanted) {
  if (!wanted) return;
  std::vector<std::string> names;
  names.reserve(file.layers.size());
  for (const RawLayer& layer : file.layers) names.push_back(layer.name);
  if (std::find(names.begin(), names.end(), *wanted) == names.end())
    throw InputError{file.label + " has no layer '" + *wanted + "'; it has " + nearest_names(names, *wanted)};
}

struct LayersByUse {
  std::vector<Source> for_fields;
  std::vector<Source> for_roles;
};

LayersByUse layers_by_use(const RawFile& file, const std::optional<std::string>& wanted_name) {
  LayersByUse layers;
  for (const RawLayer& layer : file.layers) {
    Source source{&file, &layer, role_of_layer(layer.name), std::nullopt};
    const bool wanted = wanted_name == layer.name;
    if (wanted || file.layers.size() == 1) source.role.reset();
    const bool polygons = std::any_of(layer.features.begin(), layer.features.end(),
                                      [](const RawFeature& feature) { return feature.has_polygons(); });
    if (source.role && !layer.features.empty())
      layers.for_roles.push_back(std::move(source));
    else if (polygons && (wanted || !wanted_name))
      layers.for_fields.push_back(std::move(source));
  }
  return layers;
}

/// Layers whose every polygon is far larger than a field (a data set's extent) hold no fields.
bool holds_fields(Source& source) {
  return std::any_of(source.layer->features.begin(), source.layer->features.end(),
                     [&](const RawFeature& feature) {
                       return feature.has_polygons() && source.role_of(feature) == Role::field &&
                              !implausibly_large(box_of(feature), *source.georeference);
                     });
}

/// A line that comes back to where it starts, or as near as a side of it is long on average.
bool is_boundary(const std::vector<RawPoint>& line) {
  if (line.size() < 4) return false;
  const auto length = [](RawPoint a, RawPoint b) { return std::hypot(b.x - a.x, b.y - a.y); };
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += length(line[i - 1], line[i]);
  return length(line.front(), line.back()) <= sum / static_cast<double>(line.size() - 1);
}

std::string layer_names(const std::vector<Source>& sources) {
  std::string names;
  for (const Source& source : sources) names += (names.empty() ? "'" : ", '") + source.layer->name + "'";
  return names;
}

/// Of several layers with polygons those that hold fields; more than one may of folders only.
std::vector<Source> with_fields(std::vector<Source> sources, const RawFile& file,
                                std::vector<std::string>& notes) {
  std::vector<Source> kept;
  for (Source& source : sources) {
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
  return kept;
}

void refuse_line_around_area(const RawFile& file, const RawFeature& feature) {
  if (std::any_of(feature.lines.begin(), feature.lines.end(), is_boundary))
    throw InputError{file.label + " has no polygon: feature " + std::to_string(feature.number) +
                     " is a line around an area; save the boundary as a polygon"};
}

const char* instead_of_polygons(bool lines, bool points) {
  if (lines && points) return ", only lines and points";
  if (lines) return ", only lines";
  return points ? ", only points" : "";
}

}  // namespace

std::string Source::where() const {
  return file->layers.size() > 1 ? file->label + ", layer " + layer->name : file->label;
}

std::string Source::where(const RawFeature& feature) const {
  return where() + ", feature " + std::to_string(feature.number);
}

Role Source::role_of(const RawFeature& feature) const {
  return role_of_feature(feature, where(feature)).value_or(role.value_or(Role::field));
}

void georeference(Source& source, Reading& reading) {
  source.georeference.emplace(georeference_of(source, reading));
}

std::vector<Source> sources_of(const RawFile& file, Reading& reading) {
  check_wanted_layer(file, reading.options.layer);
  LayersByUse layers = layers_by_use(file, reading.options.layer);
  if (layers.for_fields.empty()) refuse_without_polygons(file);
  for (Source& source : layers.for_fields) georeference(source, reading);
  for (Source& source : layers.for_roles) georeference(source, reading);
  std::vector<Source> sources = std::move(layers.for_fields);
  if (sources.size() > 1) sources = with_fields(std::move(sources), file, reading.notes);
  std::move(layers.for_roles.begin(), layers.for_roles.end(), std::back_inserter(sources));
  return sources;
}

void refuse_without_polygons(const RawFile& file) {
  bool lines = false;
  bool points = false;
  for (const RawLayer& layer : file.layers) {
    for (const RawFeature& feature : layer.features) {
      refuse_line_around_area(file, feature);
      lines = lines || !feature.lines.empty();
      points = points || !feature.points.empty();
    }
  }
  throw InputError{file.label + " has no polygon in it" + instead_of_polygons(lines, points) +
                   "; give a file with the field's boundary as a polygon"};
}

}  // namespace selion
