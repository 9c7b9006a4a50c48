// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/field/read.hpp"

#include <numeric>

#include "extras.hpp"
#include "field_of.hpp"
#include "locate.hpp"
#include "names.hpp"
#include "neighbours.hpp"
#include "selion/core/error.hpp"
#include "sources.hpp"

namespace selion {
namespace {

/// A field feature and where it came from.
struct Candidate {
  const RawFeature* raw = nullptr;
  Source* source = nullptr;
};

struct Sorted {
  std::vector<Candidate> candidates;
  Extras extras;
};

/// Features by role; those that no field can be made of are skipped with a note.
Sorted sorted_by_role(std::vector<Source>& sources, Reading& reading) {
  Sorted sorted;
  for (Source& source : sources) {
    std::string skipped;
    for (const RawFeature& feature : source.layer->features) {
      const Role role = source.role_of(feature);
      if (role != Role::field)
        add_extra(feature, role, source, sorted.extras, reading);
      else if (feature.has_polygons())
        sorted.candidates.push_back({&feature, &source});
      else
        skipped += (skipped.empty() ? "" : ", ") + std::to_string(feature.number);
    }
    if (!skipped.empty()) reading.notes.push_back(skipped_note(source, skipped));
  }
  return sorted;
}

std::optional<Field> field_or_note(const Candidate& candidate, const std::string& name, Reading& reading) {
  Field field = field_of(*candidate.raw, *candidate.source, name, reading.options);
  if (!implausibly_large(box_of(*candidate.raw), *candidate.source->georeference)) return field;
  reading.notes.push_back(too_large_note(field.source));
  return std::nullopt;
}

/// All candidates, or the one that the options name.
std::vector<Field> fields_of(const std::vector<Candidate>& candidates, const RawFile& file,
                             Reading& reading) {
  std::vector<const RawFeature*> features;
  features.reserve(candidates.size());
  for (const Candidate& candidate : candidates) features.push_back(candidate.raw);
  const std::vector<std::string> names = unique_names(features, file.stem);
  std::vector<std::size_t> wanted(features.size());
  std::iota(wanted.begin(), wanted.end(), std::size_t{0});
  if (reading.options.field) wanted = {selected(features, names, *reading.options.field, file.label)};

  std::vector<Field> fields;
  for (const std::size_t i : wanted)
    if (auto field = field_or_note(candidates[i], names[i], reading)) fields.push_back(std::move(*field));
  return fields;
}

}  // namespace

std::vector<Field> read_fields(const std::filesystem::path& path, const ReadOptions& options,
                               std::istream& standard_input) {
  Reading reading{options, standard_input, {}};
  const RawFile file = read_raw(path, options, standard_input);
  reading.notes = file.notes;
  std::vector<Source> sources = sources_of(file, reading);
  auto [candidates, extras] = sorted_by_role(sources, reading);
  if (candidates.empty()) refuse_without_polygons(file);
  if (options.obstacles) read_extras(*options.obstacles, Role::obstacle, extras, reading);
  if (options.gates) read_extras(*options.gates, Role::gate, extras, reading);

  std::vector<Field> fields = fields_of(candidates, file, reading);
  const std::vector<std::string>& notes = reading.notes;
  if (fields.empty())
    throw InputError{notes.empty() ? file.label + " holds no field"
                                   : notes.back() + "; give a file with field boundaries"};
  for (Field& field : fields) attach(extras, field);
  note_neighbours(fields);
  fields.front().notes.insert(fields.front().notes.begin(), notes.begin(), notes.end());
  return fields;
}

}  // namespace selion
