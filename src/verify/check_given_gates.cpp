// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "check_given.hpp"

namespace selion::verifying {
namespace {

constexpr double kReach_m = 20;  // of the border; gates farther off are none of this field
constexpr double kPlace_m = 0.02;
constexpr double kWidth_m = 1e-3;

struct OwnerGate {
  std::string name;
  Point at;
  std::optional<double> width_m;
};

std::vector<OwnerGate> gates_of(const Case& plan, const std::vector<OwnerFeature>& features) {
  std::vector<OwnerGate> gates;
  for (const OwnerFeature& feature : features) {
    if (feature.role != OwnerRole::gate) continue;
    for (const LonLat p : feature.points)
      gates.push_back({feature.name, plan.plane.to_local(p), feature.width_m});
  }
  return gates;
}

std::string text_of(const std::string& name, const std::optional<double>& width_m) {
  return (name.empty() ? "without a name" : "'" + name + "'") +
         (width_m ? ", " + shown(*width_m, 2) + " m wide" : ", of no known width");
}

bool is_width(const std::optional<double>& owned, const std::optional<double>& planned) {
  return owned.has_value() == planned.has_value() &&
         std::abs(owned.value_or(0) - planned.value_or(0)) <= kWidth_m;
}

/// The owner's gates against the plan's, each moved to the nearest outer border.
class GivenGates {
 public:
  GivenGates(Case& plan, const GivenField& given) : plan_{plan}, given_{given} {
    for (const Ground& ground : plan.grounds) borders_.emplace_back(border_of(filled(ground.area)));
    taken_.resize(plan.plan.gates.size());
  }

  void run(const std::vector<OwnerGate>& owned) {
    for (const OwnerGate& gate : owned) check(gate);
    for (std::size_t i = 0; i < taken_.size(); ++i)
      if (!taken_[i]) unknown(plan_.plan.gates[i]);
  }

 private:
  /// Is it one that is left out, or of a block that is not planned?
  [[nodiscard]] bool may_lack(const OwnerGate& gate, double nearest_m) const {
    if (!(nearest_m <= kReach_m - kPlace_m)) return true;
    for (std::size_t i = 0; i < borders_.size(); ++i)
      if (distance(i, gate.at) <= nearest_m + kPlace_m && !is_planned(plan_.grounds[i].block)) return true;
    return false;
  }
  [[nodiscard]] bool is_planned(int block) const {
    return std::ranges::any_of(plan_.drives, [&](const Driven& d) { return d.record->block == block; });
  }
  [[nodiscard]] double distance(std::size_t ground, Point p) const {
    return borders_[ground].distance_m(std::array{p});
  }

  /// The plan's gate that is this one; of a block's gates, in the owner's order.
  void check(const OwnerGate& gate) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < borders_.size(); ++i) nearest = std::min(nearest, distance(i, gate.at));
    std::optional<std::size_t> found = match(gate, nearest);
    if (found)
      taken_[*found] = true;
    else if (!may_lack(gate, nearest))
      plan_.findings.add("given_gate", 0, gate.at, {},
                         "the owner's gate " + text_of(gate.name, gate.width_m) +
                             " is not among the plan's: place, name or width differ, or their order");
  }

  [[nodiscard]] std::optional<std::size_t> match(const OwnerGate& gate, double nearest) const {
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      const GateRecord& own = plan_.plan.gates[i];
      const double moved = distance_m(plan_.plane.to_local(own.at), gate.at);
      if (!taken_[i] && moved <= nearest + kPlace_m && is_name(gate.name, own.name) &&
          is_width(gate.width_m, own.width_m) && is_next(i))
        return i;
    }
    return std::nullopt;
  }

  /// Gates are called by their numbers: no later one of the block is taken.
  [[nodiscard]] bool is_next(std::size_t i) const {
    for (std::size_t k = i + 1; k < taken_.size(); ++k)
      if (taken_[k] && plan_.plan.gates[k].block == plan_.plan.gates[i].block) return false;
    return true;
  }

  void unknown(const GateRecord& gate) {
    plan_.findings.add("given_gate", gate.block, plan_.plane.to_local(gate.at), {},
                       "the plan's gate " + text_of(gate.name, gate.width_m) + " is not one of " +
                           (given_.gates ? given_.gates->string() : given_.file.string()) +
                           (given_.gates ? "" : "; a file of gates is given by --gates"));
  }

  Case& plan_;
  const GivenField& given_;
  std::vector<Prepared> borders_;
  std::vector<bool> taken_;
};

}  // namespace

void check_given_gates(Case& plan, const std::vector<OwnerFeature>& features, const GivenField& given) {
  GivenGates{plan, given}.run(gates_of(plan, features));
}

}  // namespace selion::verifying
