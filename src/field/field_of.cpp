// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_of.hpp"

#include "locate.hpp"

namespace selion {

Field field_of(const RawFeature& raw, Source& source, const std::string& name, const ReadOptions& options) {
  const std::string where = source.where(raw);
  Located at = located(raw, *source.georeference, where, options.accept_datum_error_m);
  Field field;
  field.number = raw.number;
  field.name = name;
  field.parts = std::move(at.polygons);
  field.source = where;
  field.source_crs = source.georeference->name();
  field.datum = source.georeference->datum();
  field.datum_accuracy_m = at.datum_accuracy_m;
  field.attributes = raw.attributes;
  field.notes = std::move(at.notes);
  if (!at.points.empty() || !at.lines.empty())
    field.notes.push_back(where + ": its points and lines are skipped");
  return field;
}

std::string too_large_note(const std::string& where) {
  return where + " is more than 100 km across, and no field; skipped";
}

std::string skipped_note(const Source& source, const std::string& numbers) {
  return source.where() + ": skipped, having no polygon: feature " + numbers;
}

}  // namespace selion
