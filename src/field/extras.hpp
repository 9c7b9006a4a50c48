// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "selion/field/field.hpp"
#include "sources.hpp"

namespace selion {

/// What lies in or beside fields, not yet given to any.
struct Extras {
  std::vector<Obstacle> obstacles;
  std::vector<Gate> gates;
};

/// Adds a feature that is no field. @throws InputError for one without geometry, for a gate that is no
/// point, and as outlines() does.
void add_extra(const RawFeature& feature, Role role, Source& source, Extras& into, Reading& reading);

/// Adds all of a file of nothing but obstacles, or gates: `role` says which where the file does not.
void read_extras(const std::filesystem::path& path, Role role, Extras& into, Reading& reading);

/// Gives the field what lies within 50 m of its bounds.
void attach(const Extras& extras, Field& field);

}  // namespace selion
