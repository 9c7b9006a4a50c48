// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "selion/core/machine.hpp"
#include "selion/plan/plan.hpp"

namespace selion {

/// What is wrong with a plan, each with its place; empty where nothing is. Derived from the plan's records
/// alone, by its own integration of the pieces: containment, curvature, continuity, samples, times, every
/// swath once; speed, acceleration, lateral acceleration and steering rate on the whole way between samples.
std::vector<std::string> faults_of(const Plan& plan, const Machine& machine);

}  // namespace selion
