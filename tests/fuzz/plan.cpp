// SPDX-License-Identifier: GPL-3.0-or-later
// A polygon of up to 24 corners with up to 2 holes within 100 m, planned with the 3 m robot; the plan's
// checks follow.
#include "selion/plan/plan.hpp"

#include <numbers>
#include <stdexcept>

#include <fuzzer/FuzzedDataProvider.h>

#include "reading.hpp"
#include "selion/core/error.hpp"
#include "selion/core/units.hpp"
#include "selion/field/frame.hpp"
#include "selion/verify/verify.hpp"

using namespace selion;

namespace {

constexpr double kWidest_m = 100;

double metres(FuzzedDataProvider& bytes, double most_m) {
  return bytes.ConsumeIntegral<std::uint16_t>() * most_m / 65535;
}

/// Corners anywhere: most rings cross themselves.
Ring any_ring(FuzzedDataProvider& bytes, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double x_m = metres(bytes, kWidest_m);
    ring.push_back({x_m, metres(bytes, kWidest_m)});
  }
  return ring;
}

/// Corners around a middle: most rings are simple.
Ring star(FuzzedDataProvider& bytes, int corners, Point middle, double most_m) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + metres(bytes, 0.9)) / corners;
    ring.push_back(middle + metres(bytes, most_m) * unit(angle));
  }
  return ring;
}

LonLatRing on_earth(const Ring& ring) {
  static const LocalFrame frame = LocalFrame::centred({10, 50});
  LonLatRing result;
  for (const Point p : ring) result.push_back(frame.to_lonlat(p));
  return result;
}

Field field_of(FuzzedDataProvider& bytes) {
  const bool round = bytes.ConsumeBool();
  const int holes = bytes.ConsumeIntegralInRange(0, 2);
  const auto ring = [&](int corners, double most_m) {
    if (!round) return any_ring(bytes, corners);
    const double x_m = metres(bytes, kWidest_m / 4);
    return star(bytes, corners, {x_m, metres(bytes, kWidest_m / 4)}, most_m);
  };
  LonLatPolygon polygon;
  polygon.shell = on_earth(ring(bytes.ConsumeIntegralInRange(3, 24), kWidest_m / 2));
  for (int i = 0; i < holes; ++i)
    polygon.holes.push_back(on_earth(ring(bytes.ConsumeIntegralInRange(3, 8), kWidest_m / 8)));
  Field field;
  field.name = "fuzz";
  field.source = "fuzz";
  field.parts.push_back(polygon);
  return field;
}

void check_reads_back(const PlanFile& plan) {
  const std::string written = to_geojson(plan);
  if (to_geojson(plan_from_geojson(written, "written")) != written)
    throw std::logic_error{"the plan file reads back as another"};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes{data, size};
  const Repair repair = bytes.ConsumeBool() ? Repair::accept : Repair::notes_only;
  Job job;
  job.headland.corners = bytes.ConsumeBool() ? HeadlandCorners::fill : HeadlandCorners::round;
  job.machine.may_reverse = bytes.ConsumeBool();
  const Field field = field_of(bytes);
  try {
    const auto planned = plan(field, job, repair, no_progress);
    if (!planned) return 0;
    check_reads_back(planned->file);
    const Verdict verdict = verify(plan_from_geojson(to_geojson(planned->file), "fuzzed"), std::nullopt);
    if (!verdict.findings.empty()) throw std::logic_error{verdict.findings.front().what};
  } catch (const InputError&) {  // said so
  }
  return 0;
}
