// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/field/stream.hpp"

#include <algorithm>
#include <deque>
#include <iostream>
#include <map>

#include "extras.hpp"
#include "field_of.hpp"
#include "neighbours.hpp"
#include "selion/core/error.hpp"
#include "survey.hpp"

namespace selion {
namespace {

/// Fields that others overlap, as long as there is room: those that touch mostly lie near in the file too.
class NearbyFields {
 public:
  [[nodiscard]] const Field* find(std::uint32_t index) const {
    const auto found = held_.find(index);
    return found == held_.end() ? nullptr : &found->second;
  }
  const Field& add(std::uint32_t index, const Field& field) {
    corners_ += corners_of(field);
    order_.push_back(index);
    const Field& kept = held_[index] = {.number = field.number,
                                        .name = {},
                                        .parts = field.parts,
                                        .obstacles = {},
                                        .gates = {},
                                        .source = {},
                                        .source_crs = {},
                                        .datum = {},
                                        .datum_accuracy_m = {},
                                        .attributes = {},
                                        .notes = {}};
    while (corners_ > kMostCorners && order_.size() > 1) {
      corners_ -= corners_of(held_.at(order_.front()));
      held_.erase(order_.front());
      order_.pop_front();
    }
    return kept;
  }

 private:
  static constexpr std::size_t kMostCorners = 1'000'000;  // 16 MB

  static std::size_t corners_of(const Field& field) {
    std::size_t count = 0;
    for (const LonLatPolygon& part : field.parts) {
      count += part.shell.size();
      for (const LonLatRing& hole : part.holes) count += hole.size();
    }
    return count;
  }

  std::map<std::uint32_t, Field> held_;
  std::deque<std::uint32_t> order_;  // the one held longest first
  std::size_t corners_ = 0;
};

std::vector<Overlap> overlaps_of(const std::vector<SurveyedField>& fields) {
  std::vector<FieldExtent> extents;
  extents.reserve(fields.size());
  for (const SurveyedField& field : fields)
    extents.push_back({field.box.low.x, field.box.low.y, field.box.high.x, field.box.high.y});
  return overlaps_of(extents);
}

}  // namespace

struct FieldStream::State {
  State(const std::filesystem::path& path, const ReadOptions& options)
      : read_options{options},
        reading{read_options, std::cin, {}},
        raw{raw_stream(path, options, std::cin)},
        survey{surveyed(raw, options)} {
    reading.notes = survey.file.notes;
    sources = sources_of(survey.file, reading);
    add_extras();
    take_fields();
    names.emplace(survey.file.stem, fields.size());
  }

  void add_extras() {
    for (Source& source : sources) {
      for (const RawFeature& feature : source.layer->features)
        if (const Role role = source.role_of(feature); role != Role::field)
          add_extra(feature, role, source, extras, reading);
      const std::string& skipped = survey.layers[layer_of(source)].skipped;
      if (!skipped.empty()) reading.notes.push_back(skipped_note(source, skipped));
    }
  }

  void take_fields() {
    for (Source& source : sources) {
      for (SurveyedField field : survey.layers[layer_of(source)].fields) {
        field.too_large = implausibly_large(field.box, *source.georeference);
        fields.push_back(field);
      }
    }
    if (fields.empty()) refuse_without_polygons(survey.file);
    survey.layers.clear();
    if (read_options.obstacles) read_extras(*read_options.obstacles, Role::obstacle, extras, reading);
    if (read_options.gates) read_extras(*read_options.gates, Role::gate, extras, reading);
    for (const SurveyedField& field : fields)
      if (field.too_large) reading.notes.push_back(too_large_note(where(field)));
    if (std::ranges::all_of(fields, &SurveyedField::too_large))
      throw InputError{reading.notes.back() + "; give a file with field boundaries"};
    first = static_cast<std::size_t>(std::ranges::find(fields, false, &SurveyedField::too_large) -
                                     fields.begin());
    size = static_cast<std::size_t>(std::ranges::count(fields, false, &SurveyedField::too_large));
    overlaps = overlaps_of(fields);
  }

  [[nodiscard]] std::size_t layer_of(const Source& source) const {
    return static_cast<std::size_t>(source.layer - survey.file.layers.data());
  }

  [[nodiscard]] Source& source_of(const SurveyedField& field) {
    return *std::ranges::find_if(sources, [&](const Source& s) { return layer_of(s) == field.layer; });
  }

  [[nodiscard]] std::string where(const SurveyedField& field) {
    return source_of(field).where() + ", feature " + std::to_string(field.number);
  }

  /// The next feature that was surveyed.
  bool advance() {
    if (++at >= fields.size()) return false;
    const SurveyedField& field = fields[at];
    if (at == 0 || field.layer != fields[at - 1].layer) raw.rewind(field.layer);
    do current = raw.next();
    while (current && current->number < field.number);
    if (!current || current->number != field.number)
      throw InputError{survey.file.label + " was changed while it was being read; begin again"};
    name = names->next(*current);
    return true;
  }

  /// An earlier field; null where it cannot be read.
  const Field* earlier(std::uint32_t index) {
    if (const Field* known = nearby.find(index)) return known;
    const SurveyedField& field = fields[index];
    if (field.too_large) return nullptr;
    try {
      const auto feature = raw.at(field.layer, field.id, field.number);
      if (!feature) return nullptr;
      return &nearby.add(index, field_of(*feature, source_of(field), "", read_options));
    } catch (const InputError&) {
      return nullptr;  // said when its own turn came
    }
  }

  Field field() {
    Field field = field_of(*current, source_of(fields[at]), name, read_options);
    attach(extras, field);
    const auto index = static_cast<std::uint32_t>(at);
    NeighbourNotes notes{field};
    for (auto overlap = std::lower_bound(overlaps.begin(), overlaps.end(), Overlap{index, 0});
         overlap != overlaps.end() && overlap->later == index; ++overlap)
      if (const Field* other = earlier(overlap->earlier); other != nullptr && !notes.compare_with(*other))
        break;
    if (at == first) field.notes.insert(field.notes.begin(), reading.notes.begin(), reading.notes.end());
    nearby.add(index, field);
    return field;
  }

  ReadOptions read_options;
  Reading reading;
  RawStream raw;
  Survey survey;
  std::vector<Source> sources;
  Extras extras;
  std::vector<SurveyedField> fields;
  std::vector<Overlap> overlaps;
  std::optional<UniqueNames> names;
  NearbyFields nearby;

  std::size_t at = static_cast<std::size_t>(-1);
  std::size_t first = 0;  // that is no extent
  std::size_t size = 0;   // without extents
  std::optional<RawFeature> current;
  std::string name;
};

FieldStream::FieldStream(const std::filesystem::path& path, const ReadOptions& options)
    : state_{std::make_unique<State>(path, options)} {}
FieldStream::FieldStream(FieldStream&&) noexcept = default;
FieldStream& FieldStream::operator=(FieldStream&&) noexcept = default;
FieldStream::~FieldStream() = default;

std::size_t FieldStream::size() const { return state_->size; }

const std::vector<std::string>& FieldStream::notes() const { return state_->reading.notes; }

std::optional<FieldStream::Feature> FieldStream::next() {
  do
    if (!state_->advance()) return std::nullopt;
  while (state_->fields[state_->at].too_large);
  const std::vector<RawLayer>& layers = state_->survey.file.layers;
  return Feature{layers.size() > 1 ? layers[state_->fields[state_->at].layer].name : "",
                 state_->current->number, state_->name};
}

Field FieldStream::field() { return state_->field(); }

}  // namespace selion
