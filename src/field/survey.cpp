// SPDX-License-Identifier: GPL-3.0-or-later
#include "survey.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "names.hpp"
#include "sources.hpp"

namespace selion {
namespace {

double across(const RawBox& box) { return std::max(box.high.x - box.low.x, box.high.y - box.low.y); }

bool has_closed_line(const RawFeature& feature) {
  return std::ranges::any_of(feature.lines, [](const std::vector<RawPoint>& line) {
    return line.size() > 3 && line.front() == line.back();
  });
}

/// Takes one layer's features and keeps what is needed of them.
class LayerSurvey {
 public:
  explicit LayerSurvey(SurveyedLayer& layer) : layer_{layer} {}

  void add_field(const RawFeature& feature, std::size_t layer) {
    const RawBox box = box_of(feature);
    layer_.fields.push_back({box, feature.id, feature.number, layer, false});
    if (!first_) first_ = feature;
    if (smallest_ && !(across(box) < smallest_across_)) return;
    smallest_across_ = across(box);
    smallest_ = feature;
  }
  void add_other(const RawFeature& feature) {
    layer_.skipped += (layer_.skipped.empty() ? "" : ", ") + std::to_string(feature.number);
    if (!feature.is_empty() && !first_) first_ = feature;
    if (has_closed_line(feature) && !closed_) closed_ = feature;
  }
  void add_extra(RawFeature feature) { extras_.push_back(std::move(feature)); }

  /// The first, which messages show; the smallest, which says whether all are larger than fields are; a
  /// closed line, which may have been meant as one; all obstacles and gates.
  [[nodiscard]] std::vector<RawFeature> kept() && {
    std::vector<RawFeature> kept;
    for (std::optional<RawFeature>* one : {&first_, &smallest_, &closed_})
      if (*one) kept.push_back(*std::move(*one));
    std::move(extras_.begin(), extras_.end(), std::back_inserter(kept));
    return kept;
  }

 private:
  SurveyedLayer& layer_;
  double smallest_across_ = 0;
  std::optional<RawFeature> first_;
  std::optional<RawFeature> smallest_;
  std::optional<RawFeature> closed_;
  std::vector<RawFeature> extras_;
};

}  // namespace

Survey surveyed(RawStream& stream, const ReadOptions& options) {
  Survey survey{stream.about, std::vector<SurveyedLayer>(stream.about.layers.size())};
  for (std::size_t i = 0; i < survey.file.layers.size(); ++i) {
    RawLayer& layer = survey.file.layers[i];
    const bool plain = options.layer == layer.name || survey.file.layers.size() == 1;
    const Source source{&survey.file, &layer, plain ? std::nullopt : role_of_layer(layer.name), std::nullopt};
    LayerSurvey keep{survey.layers[i]};
    stream.rewind(i);
    while (auto feature = stream.next()) {
      const Role role = source.role_of(*feature);
      if (role != Role::field)
        keep.add_extra(std::move(*feature));
      else if (feature->has_polygons())
        keep.add_field(*feature, i);
      else
        keep.add_other(*feature);
    }
    layer.features = std::move(keep).kept();
  }
  return survey;
}

}  // namespace selion
