// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "selion/planfile/planfile.hpp"

namespace selion {

// What every plan file holds to. The writer and the reader both ask, so that whatever is written can be read.

inline constexpr int kPlanFormat = 1;

inline constexpr auto kPieceKinds = std::to_array<std::string_view>(
    {"swath", "headland_pass", "turn", "pivot", "transfer", "lane", "tramline", "wait"});
inline constexpr auto kObstacleKinds = std::to_array<std::string_view>({"obstacle", "no_go", "water"});

/// What is wrong with a record, in words that name key and value; absent where it is sound.
using Problem = std::optional<std::string>;

Problem problem_of(LonLat position);
Problem problem_of_line(const LonLatLine& line);
Problem problem_of(const LonLatArea& area);
Problem problem_of(const std::vector<LonLatArea>& parts);
/// Of a frame: PROJ would read whatever file its string names.
Problem problem_of_frame(const std::string& proj);
/// Keys are of letters, digits and underscores, each once.
Problem problem_of(const std::vector<SummaryFigure>& summary);
Problem problem_of(const ObstacleRecord& obstacle);
Problem problem_of(const PieceRecord& piece);
/// Its line, its arrays and its own numbers; the pieces are asked one by one.
Problem problem_of(const TrajectoryRecord& trajectory);

}  // namespace selion
