// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/offset.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "displacement.hpp"

namespace selion {
namespace {

double curvature_at(const Curve& curve, double s) {
  return curve.curvature_per_m + curve.sharpness_per_m2 * s;
}

double stretching_at(const OffsetCurve& offset, double s) {
  return 1 - curvature_at(offset.guide, s) * offset.offset_m;
}

CurveLimits bend_at(const OffsetCurve& offset, double s) {
  const double stretching = stretching_at(offset, s);
  return {std::abs(curvature_at(offset.guide, s) / stretching),
          std::abs(offset.guide.sharpness_per_m2 / (stretching * stretching * stretching))};
}

CurveLimits larger(const CurveLimits& a, const CurveLimits& b) {
  return {std::max(a.curvature_per_m, b.curvature_per_m), std::max(a.sharpness_per_m2, b.sharpness_per_m2)};
}

bool is_within(const std::optional<CurveLimits>& bend, const CurveLimits& limits) {
  constexpr double kRounding = 1 + 1e-9;
  return bend && bend->curvature_per_m <= kRounding * limits.curvature_per_m &&
         bend->sharpness_per_m2 <= kRounding * limits.sharpness_per_m2;
}

}  // namespace

double least_stretching(const OffsetCurve& offset) {
  return std::min(stretching_at(offset, 0), stretching_at(offset, offset.guide.length_m));
}

bool has_cusp(const OffsetCurve& offset) { return least_stretching(offset) <= 0; }

bool has_cusp(const OffsetPath& offset) {
  return std::any_of(offset.guide.begin(), offset.guide.end(), [&](const Stretch& stretch) {
    return has_cusp(OffsetCurve{stretch.curve, offset.offset_m});
  });
}

std::optional<OffsetState> state_at(const OffsetCurve& offset, double s_m) {
  const double stretching = stretching_at(offset, s_m);
  if (stretching <= 0) return std::nullopt;
  const CurveState guide = state_at(offset.guide, s_m);
  const Point at = guide.at + offset.offset_m * left_of(unit(guide.heading_rad));
  return OffsetState{at, guide.heading_rad, guide.curvature_per_m / stretching,
                     offset.guide.sharpness_per_m2 / (stretching * stretching * stretching), stretching};
}

double length_to_m(const OffsetCurve& offset, double s_m) {
  return s_m - offset.offset_m * turned_rad(offset.guide, s_m);
}

double length_m(const OffsetCurve& offset) { return length_to_m(offset, offset.guide.length_m); }

double length_m(const OffsetPath& offset) {
  double sum = 0;
  for (const Stretch& stretch : offset.guide) sum += length_m(OffsetCurve{stretch.curve, offset.offset_m});
  return sum;
}

std::optional<double> station_m(const OffsetCurve& offset, double length_m) {
  const double start = stretching_at(offset, 0);
  const double square = start * start - 2 * offset.offset_m * offset.guide.sharpness_per_m2 * length_m;
  // The stretching there is the root of `square`.
  if (start <= 0 || square <= 0) return std::nullopt;
  return 2 * length_m / (start + std::sqrt(square));
}

// The curvature k / (1 - k d) grows with k, and k is linear; the sharpness grows as 1 - k d shrinks.
std::optional<CurveLimits> largest_bend(const OffsetCurve& offset) {
  if (has_cusp(offset)) return std::nullopt;
  return larger(bend_at(offset, 0), bend_at(offset, offset.guide.length_m));
}

std::optional<CurveLimits> largest_bend(const OffsetPath& offset) {
  CurveLimits largest;
  for (const Stretch& stretch : offset.guide) {
    const auto bend = largest_bend(OffsetCurve{stretch.curve, offset.offset_m});
    if (!bend) return std::nullopt;
    largest = larger(largest, *bend);
  }
  return largest;
}

bool keeps(const OffsetCurve& offset, const CurveLimits& limits) {
  return is_within(largest_bend(offset), limits);
}

bool keeps(const OffsetPath& offset, const CurveLimits& limits) {
  return is_within(largest_bend(offset), limits);
}

}  // namespace selion
