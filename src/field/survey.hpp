// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "locate.hpp"
#include "raw_stream.hpp"

namespace selion {

/// A feature that may be a field: what is kept of it.
struct SurveyedField {
  RawBox box;
  std::int64_t id = 0;
  int number = 1;
  std::size_t layer = 0;
  bool too_large = false;
};

struct SurveyedLayer {
  std::vector<SurveyedField> fields;
  std::string skipped;  ///< numbers of the features without polygons and role
};

/// A file as read_raw gives it, but of the features that may be fields only a few that stand for the rest:
/// enough to choose layers and their reference systems, and to find obstacles and gates.
struct Survey {
  RawFile file;
  std::vector<SurveyedLayer> layers;  ///< one for each of `file`
};

/// Reads all features once. @throws InputError for a property `selion` that is no role.
Survey surveyed(RawStream& stream, const ReadOptions& options);

}  // namespace selion
