// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "selion/planfile/planfile.hpp"

namespace selion {

enum class Units { metric, imperial };
enum class Paper { a4, a3, letter };

/// What the map says beside what the plan file holds.
struct MapText {
  std::string title;                                      ///< "Home field - seeding"
  std::vector<std::pair<std::string, std::string>> data;  ///< the data box: label and value, units included
  std::vector<std::string> notes;        ///< of planning and reading; as many as there is room for
  std::vector<std::string> assumptions;  ///< machine assumed, flat ground, boundary accuracy, datum
  std::vector<std::string> warnings;     ///< drawn so that nobody overlooks them
  std::optional<std::string> date;
};

struct MapOptions {
  Units units = Units::metric;
  Paper paper = Paper::a4;
};

/// One page in both formats, vector with real text.
struct MapFiles {
  std::string svg;
  std::string pdf;
};

/// Looks up which fonts the system has, once for all maps: the first map would wait for it.
void find_fonts();

/// The printed map. Same plan, same bytes.
MapFiles map_files(const PlanFile& plan, const MapText& text, const MapOptions& options);

}  // namespace selion
