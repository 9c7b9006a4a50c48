// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields.hpp"

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "selion/core/point.hpp"
#include "selion/core/units.hpp"
#include "selion/field/read.hpp"

namespace selion {
namespace {

constexpr LonLat kOrigin{3.43, 46.34};  // where F1-F6 are

/// Within a kilometre or two of the origin; a few in ten thousand off, which does not matter here.
LonLat lon_lat(Point at) {
  constexpr double kEarth_m = 6'371'000;
  const double north_rad = at.y_m / kEarth_m;
  const double east_rad = at.x_m / (kEarth_m * std::cos(radians_of_degrees(kOrigin.lat_deg)));
  return {kOrigin.lon_deg + degrees_of_radians(east_rad), kOrigin.lat_deg + degrees_of_radians(north_rad)};
}

LonLatRing rectangle(Point low, Point high) {
  return {lon_lat(low), lon_lat({high.x_m, low.y_m}), lon_lat(high), lon_lat({low.x_m, high.y_m})};
}

Field field_of(LonLatPolygon area, const std::string& name) {
  Field field;
  field.name = field.source = name;
  field.parts = {std::move(area)};
  return field;
}

Job job_of(std::string_view preset) {
  Job job;
  for (const MachinePreset& known : machine_presets()) {
    if (known.name != preset) continue;
    job.machine = known.machine;
    job.field.edge_margin_m = known.edge_margin_m;
    job.field.obstacle_clearance_m = known.obstacle_clearance_m;
  }
  return job;
}

}  // namespace

Field field_named(const std::string& name) {
  return read_fields(SELION_DATA_DIR "/fields/" + name + ".geojson", {}, std::cin).front();
}

Field wavy_field(int corners) {
  constexpr double kRadius_m = 252.3;  // of 20 ha
  constexpr int kWaves = 12;
  std::mt19937 random{1};
  std::array<double, kWaves> phase_rad{};
  for (double& phase : phase_rad) phase = 2 * std::numbers::pi * static_cast<double>(random()) / 0x1p32;
  LonLatPolygon area;
  for (int i = 0; i < corners; ++i) {
    const double angle_rad = 2 * std::numbers::pi * i / corners;
    double share = 1;
    for (int k = 0; k < kWaves; ++k)
      share += 0.08 / (k + 2) * std::cos((k + 2) * angle_rad + phase_rad.at(static_cast<std::size_t>(k)));
    area.shell.push_back(lon_lat(share * kRadius_m * unit(angle_rad)));
  }
  return field_of(std::move(area), "wavy");
}

Field square_kilometre() {
  LonLatPolygon area{rectangle({0, 0}, {1000, 1000}), {}};
  area.holes = {rectangle({150, 180}, {190, 210}), rectangle({480, 120}, {504, 144}),
                rectangle({800, 260}, {860, 300}), rectangle({220, 610}, {250, 660}),
                rectangle({560, 540}, {600, 580}), rectangle({770, 820}, {810, 850})};
  return field_of(std::move(area), "square kilometre");
}

Job four_metres() {
  Job job = job_of("p3");
  Machine& m = job.machine;
  m.working_width_m = m.body_width_m = 4;
  m.max_steer_deg = 18;
  m.front_m = 2.4;
  m.rear_m = 0.6;
  m.max_lateral_mps2 = 1.5;
  m.work_speed_mps = 3.5;
  m.may_reverse = false;
  return job;
}

Job one_metre() { return job_of("p3"); }

}  // namespace selion
