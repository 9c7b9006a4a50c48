// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "selion/field/field.hpp"
#include "selion/output/map.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion::cli {

/// What is in one field, and what cleaning says of it.
struct FieldView {
  Field field;
  LonLat centre;
  int vertices = 0;
  int holes = 0;
  int blocks = 0;
  std::optional<double> area_m2;  ///< to be covered: as cleaned, holes and obstacles taken off
  std::vector<std::string> notes;
  std::string problem;  ///< why the field cannot be planned; empty where it can
};
FieldView view_of(const Field& field);

std::string text_of(const FieldView& view, Units units);
std::string json_of(std::span<const FieldView> views, const std::string& file);

std::string text_of(const PlanFile& plan, Units units);
std::string json_of(const PlanFile& plan, const std::string& file);

}  // namespace selion::cli
