// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "selion/planfile/planfile.hpp"

namespace selion {

/// Numbers that a seed settles on any machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_{seed * 0x9E3779B97F4A7C15U + 1} {}
  /// From 0 to below `count` > 0.
  std::size_t pick(std::size_t count);
  double between(double low, double high);

 private:
  std::uint64_t next();
  std::uint64_t state_;
};

/// A way to break a plan.
struct Mutation {
  const char* name;
  std::vector<const char*> codes;                         ///< one of them must be found
  std::function<bool(PlanFile& plan, Dice& dice)> apply;  ///< false where the plan has nothing of the kind
};

/// Changes one of the records.
template <class Record, class Change>
std::function<bool(PlanFile&, Dice&)> to_one(std::vector<Record> PlanFile::*records, Change change) {
  return [=](PlanFile& plan, Dice& dice) {
    auto& all = plan.*records;
    if (all.empty()) return false;
    change(all[dice.pick(all.size())], dice);
    return true;
  };
}

std::span<const Mutation> mutations_of_pieces();
std::span<const Mutation> mutations_of_samples();
std::span<const Mutation> mutations_of_records();
std::span<const Mutation> mutations_of_layout();
/// Within what checks of single samples and pieces allow for roundings.
std::span<const Mutation> hidden_mutations();

}  // namespace selion
