// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/motion/turns.hpp"

namespace selion {

// The families of turns() (TurnFamily), declared where the table and the families see them.
std::vector<Path> straight_turn(const Pose& from, const Pose& to, const CurveLimits& limits);
std::vector<Path> loop_turn(const Pose& from, const Pose& to, const CurveLimits& limits);
std::vector<Path> dip_turn(const Pose& from, const Pose& to, const CurveLimits& limits);
std::vector<Path> flat_turn(const Pose& from, const Pose& to, const CurveLimits& limits);
std::vector<Path> lsl_turn(const Pose& from, const Pose& to, const CurveLimits& limits);
std::vector<Path> rsr_turn(const Pose& from, const Pose& to, const CurveLimits& limits);
std::vector<Path> lsr_turn(const Pose& from, const Pose& to, const CurveLimits& limits);
std::vector<Path> rsl_turn(const Pose& from, const Pose& to, const CurveLimits& limits);
std::vector<Path> lrl_turn(const Pose& from, const Pose& to, const CurveLimits& limits);
std::vector<Path> rlr_turn(const Pose& from, const Pose& to, const CurveLimits& limits);

}  // namespace selion
