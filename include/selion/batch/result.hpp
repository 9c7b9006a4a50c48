// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "selion/field/field.hpp"

namespace selion {

/// How a field of a batch came out: planned to at least 90 % or less, not plannable, not usable.
enum class BatchStatus { done, partial, infeasible, error };

constexpr auto kBatchStatusNames =
    std::to_array<std::string_view>({"done", "partial", "infeasible", "error"});

/// What a plan is worth.
struct BatchFigures {
  double covered_m2 = 0;
  double worked_twice_m2 = 0;
  int swaths = 0;
  int passes = 0;
  double length_m = 0;
  double duration_s = 0;

  friend bool operator==(const BatchFigures&, const BatchFigures&) = default;
};

/// One row of a batch's table: a field, or a file that could not be read.
struct BatchResult {
  std::size_t number = 1;      ///< in the batch, from 1, in the order of files and features
  std::string file;            ///< as its folder calls it
  std::string layer;           ///< empty where the file has one
  std::optional<int> feature;  ///< in its layer, from 1; absent of a file that could not be read
  std::string name;
  BatchStatus status = BatchStatus::done;
  std::string reason;  ///< why it is infeasible or an error
  std::optional<double> area_m2;
  std::optional<BatchFigures> figures;  ///< absent where there is no plan
  std::string verified;                 ///< what an independent check says; empty where there was none
  std::string plan;  ///< the plan file, as the batch's folder calls it; empty where there is none
  std::uint64_t plan_bytes = 0;
  std::vector<LonLatPolygon> boundary;

  friend bool operator==(const BatchResult&, const BatchResult&) = default;
};

}  // namespace selion
