// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>

#include "selion/core/error.hpp"
#include "selion/plan/job_keys.hpp"
#include "selion/plan/text.hpp"

namespace selion {
namespace {

struct Range {
  std::string_view key;
  double value;
  double low;
  double high;
};

[[noreturn]] void refuse(std::string_view key, double value, const std::string& why) {
  throw InputError{std::string{key} + " = " + number_text(value) + " " + why};
}

void check(const Range& range) {
  if (range.value >= range.low && range.value <= range.high) return;  // a NaN fails both
  const std::string_view unit = job_key(range.key).unit;
  refuse(range.key, range.value,
         "is out of range: from " + number_text(range.low) + " to " + number_text(range.high) +
             (unit.empty() ? "" : " " + std::string{unit}));
}

void check_ranges(const Job& job) {
  const auto ranges = std::to_array<Range>({
      {"field.edge_margin_m", job.field.edge_margin_m, 0, 100},
      {"field.obstacle_clearance_m", job.field.obstacle_clearance_m, 0, 100},
      {"field.water_margin_m", job.field.water_margin_m, 0, 1000},
      {"field.overhang_m", job.field.overhang_m, 0, 100},
      {"field.boundary_accuracy_m", job.field.boundary_accuracy_m.value_or(0), 0, 1000},
      {"layout.direction", number_of_text(job.layout.direction).value_or(0), 0, 360},
      {"layout.ab_shift_m", job.layout.ab_shift_m, -1000, 1000},
      {"layout.overlap_m", job.layout.overlap_m, 0, job.machine.working_width_m / 2},
      {"layout.row_spacing_m", job.layout.row_spacing_m, 0.01, 100},
      {"layout.tramlines", static_cast<double>(job.layout.tramlines), 0, 100},
      {"headland.passes", static_cast<double>(job.headland.passes.value_or(0)), 0, 100},
  });
  for (const Range& range : ranges) check(range);
}

void check_line(const std::array<double, 4>& ab) {
  const auto [lon_a, lat_a, lon_b, lat_b] = ab;
  for (double lon : {lon_a, lon_b})
    if (!(lon >= -180 && lon <= 180))
      refuse("layout.ab", lon, "is no longitude: from -180 to 180 deg, longitude before latitude");
  for (double lat : {lat_a, lat_b})
    if (!(lat >= -90 && lat <= 90))
      refuse("layout.ab", lat, "is no latitude: from -90 to 90 deg, longitude before latitude");
  if (lon_a == lon_b && lat_a == lat_b)
    throw InputError{"layout.ab has A and B at the same place; give two places on the line"};
}

bool is_number_after(const std::string& text, std::string_view start) {
  return text.starts_with(start) && text.size() > start.size() && text.size() < start.size() + 10 &&
         text.find_first_not_of("0123456789", start.size()) == std::string::npos;
}

void check_texts(const Job& job) {
  for (const JobKey& key : job_keys())
    if (key.type == JobType::text || key.type == JobType::heading)
      static_cast<void>(fitted(key, key.get(job)));
  if (job.frame.crs != "auto" && !is_number_after(job.frame.crs, "EPSG:"))
    throw InputError{"frame.crs = '" + job.frame.crs + "' is neither 'auto' nor a code such as 'EPSG:2154'"};
  if (!job.route.start.empty() && (!is_number_after(job.route.start, "gate:") || job.route.start == "gate:0"))
    throw InputError{"route.start = '" + job.route.start +
                     "' is no gate: gates go by number, write 'gate:1' for the first one, or leave it empty"};
}

}  // namespace

void validate(const Job& job) {
  validate(job.machine);
  check_texts(job);
  check_ranges(job);
  if (job.layout.ab) check_line(*job.layout.ab);
  if (job.layout.tramlines > 0)
    refuse("layout.tramlines", job.layout.tramlines, "is not supported yet; there is only 0");
  if (job.field.overhang_m > 0)
    refuse("field.overhang_m", job.field.overhang_m,
           "is not supported yet; there is only 0: nothing passes over the border");
}

}  // namespace selion
