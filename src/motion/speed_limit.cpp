// SPDX-License-Identifier: GPL-3.0-or-later
#include "speed_limit.hpp"

#include <algorithm>
#include <cmath>

#include "selion/core/units.hpp"

// Along a clothoid |curvature| is k = k0 +- |c| s, and the square of the speed is at most the least of
//   cap^2,   lateral / k,   (rate / |c|)^2 (1 + (L k)^2)^2.
// The second falls with k, the third rises, so that k has at most three ranges: steering, cap, lateral. Both
// are convex in k, hence in s: (1/k)'' = 2/k^3 > 0, ((1 + x^2)^2)'' = 4 + 12 x^2 > 0. A convex function lies
// above its tangents, so in each range the tangents at a few places, ends included, joined where neighbours
// meet, stay below the limit everywhere and touch it at these places.

namespace selion {
namespace {

constexpr double kFlat = 1e-4;          // a limit this little below the cap is one lower cap
constexpr double kShort_m = 1e-3;       // a range this short gets the lower of its ends
constexpr double kSame = 1e-5;          // so does one along which the limit hardly changes
constexpr double kLateralStep = 0.3;    // ln of the ratio of neighbouring k
constexpr double kSteeringStep = 0.12;  // ln of the ratio of neighbouring 1 + L k

struct Touch {
  double k = 0;
  double value = 0;
  double slope = 0;
};

/// The limits of one clothoid by |curvature|, squares of speeds.
struct Bounds {
  double cap2 = 0;
  double lateral = 0;
  double straight2 = 0;  ///< steering, where k = 0
  double base2 = 0;

  [[nodiscard]] double steering(double k) const {
    const double grown = 1 + base2 * k * k;
    return straight2 * grown * grown;
  }
  [[nodiscard]] double least(double low_k, double high_k) const {
    const double most = high_k > 0 ? std::min(cap2, lateral / high_k) : cap2;
    return std::min(most, steering(low_k));
  }
  [[nodiscard]] Touch steering_at(double k) const {
    return {k, steering(k), 4 * straight2 * base2 * k * (1 + base2 * k * k)};
  }
  [[nodiscard]] Touch lateral_at(double k) const { return {k, lateral / k, -lateral / (k * k)}; }
};

/// Where steering ends and lateral acceleration begins to be the limit; in between it is the cap.
struct Ranges {
  double steering_to_k = 0;
  double lateral_from_k = 0;
};

/// Newton on k (1 + L^2 k^2)^2 = lateral / straight2 from its right: the left side rises and is convex.
double meeting_k(const Bounds& b, double k) {
  for (int i = 0; i < 60; ++i) {
    const Touch t = b.steering_at(k);
    const double step = (k * t.value - b.lateral) / (t.value + k * t.slope);
    k -= step;
    if (step <= 1e-14 * k) break;
  }
  return k;
}

Ranges ranges_of(const Bounds& b) {
  const double from = b.lateral / b.cap2;
  if (b.straight2 >= b.cap2) return {0, from};
  const double to = std::sqrt((std::sqrt(b.cap2 / b.straight2) - 1) / b.base2);
  if (to <= from) return {to, from};
  const double meeting = meeting_k(b, to);
  return {meeting, meeting};
}

/// Appends the parts of one side of a clothoid: k rises or falls all along.
class Side {
 public:
  Side(std::vector<SpeedPart>& parts, std::size_t leg, const Bounds& bounds, double from_m, double from_k,
       double sharpness)
      : parts_{parts}, bounds_{bounds}, leg_{leg}, s_m_{from_m}, k_{from_k}, metres_by_k_{1 / sharpness} {}

  void to(double k, double s_m) {
    const Ranges ranges = ranges_of(bounds_);
    const double low = std::min(k_, k);
    const double high = std::max(k_, k);
    const double steered = std::clamp(ranges.steering_to_k, low, high);
    const double lateral = std::clamp(ranges.lateral_from_k, low, high);
    if (k > k_) {
      steering(steered);
      flat(lateral);
      sideways(k);
    } else {
      sideways(lateral);
      flat(steered);
      steering(k);
    }
    parts_.back().to_m = s_m;
  }

 private:
  void add(double k, double from2, double to2) {
    const double s = s_m_ + std::abs(k - k_) * metres_by_k_;
    parts_.push_back({leg_, s_m_, s, from2, to2, 0, 0});
    s_m_ = s;
    k_ = k;
  }

  void flat(double k) {
    if (k != k_) add(k, bounds_.cap2, bounds_.cap2);
  }

  void steering(double k) {
    const double shift = bounds_.base2 > 0 ? 1 / std::sqrt(bounds_.base2) : 0;
    if (k != k_) tangents(k, shift, kSteeringStep, [this](double at) { return bounds_.steering_at(at); });
  }

  void sideways(double k) {
    if (k != k_) tangents(k, 0, kLateralStep, [this](double at) { return bounds_.lateral_at(at); });
  }

  /// Touches where shift + k is in equal ratios.
  template <class TouchAt>
  void tangents(double to_k, double shift, double step, const TouchAt& touch_at) {
    Touch last = touch_at(k_);
    const Touch end = touch_at(to_k);
    const double log = std::log((to_k + shift) / (k_ + shift));
    if (std::abs(to_k - k_) * metres_by_k_ < kShort_m || std::abs(log) < kSame) {
      const double least = std::min(last.value, end.value);
      return add(to_k, least, least);
    }
    const double count = std::ceil(std::abs(log) / step);
    const double ratio = std::exp(log / count);
    double from2 = last.value;
    for (int i = 1; i <= static_cast<int>(count); ++i) {
      const Touch next = i == static_cast<int>(count) ? end : touch_at((last.k + shift) * ratio - shift);
      const double on =
          (next.value - last.value - next.slope * (next.k - last.k)) / (last.slope - next.slope);
      const double corner2 = last.value + last.slope * on;
      add(last.k + on, from2, corner2);
      from2 = corner2;
      last = next;
    }
    add(to_k, from2, end.value);
  }

  std::vector<SpeedPart>& parts_;
  const Bounds& bounds_;
  std::size_t leg_ = 0;
  double s_m_ = 0;
  double k_ = 0;
  double metres_by_k_ = 0;
};

Bounds bounds_of(double cap2, double sharpness, const SpeedLimits& limits) {
  const double straight = limits.rate_m_per_s / sharpness;
  Bounds b{cap2, limits.lateral_mps2, straight * straight, limits.base2_m2};
  if (b.base2 == 0) b.cap2 = std::min(cap2, b.straight2);  // the same all along
  return b;
}

void add_clothoid(std::vector<SpeedPart>& parts, std::size_t index, const Curve& curve,
                  const Bounds& bounds) {
  const double length = curve.length_m;
  const double start = curve.curvature_per_m;
  const double end = start + curve.sharpness_per_m2 * length;
  const bool crosses = (start < 0 && end > 0) || (start > 0 && end < 0);
  const double low = crosses ? 0 : std::min(std::abs(start), std::abs(end));
  const double least = bounds.least(low, std::max(std::abs(start), std::abs(end)));
  if (least >= bounds.cap2 * (1 - kFlat) || start == end) {
    parts.push_back({index, 0, length, least, least, 0, 0});
    return;
  }
  const double sharpness = std::abs(curve.sharpness_per_m2);
  const double zero_m = crosses ? std::abs(start) / sharpness : 0;
  if (crosses) Side{parts, index, bounds, 0, std::abs(start), sharpness}.to(0, zero_m);
  Side{parts, index, bounds, zero_m, crosses ? 0 : std::abs(start), sharpness}.to(std::abs(end), length);
}

}  // namespace

SpeedLimits speed_limits(const Machine& machine) {
  const double base = steering_base_m(machine);
  return {machine.max_speed_mps, machine.max_lateral_mps2,
          radians_of_degrees(machine.max_steer_rate_deg_s) / base,
          machine.kind == MachineKind::car ? base * base : 0};
}

void add_parts(std::vector<SpeedPart>& parts, std::size_t index, const Leg& leg, const SpeedLimits& limits) {
  const Curve& curve = leg.stretch.curve;
  const double cap = std::min(leg.speed_cap_mps, limits.speed_mps);
  if (curve.sharpness_per_m2 != 0)
    return add_clothoid(parts, index, curve, bounds_of(cap * cap, std::abs(curve.sharpness_per_m2), limits));
  const double curvature = std::abs(curve.curvature_per_m);
  const double most2 = curvature > 0 ? std::min(cap * cap, limits.lateral_mps2 / curvature) : cap * cap;
  parts.push_back({index, 0, curve.length_m, most2, most2, 0, 0});
}

}  // namespace selion
