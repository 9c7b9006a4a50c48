// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/plan/plan.hpp"

/// A plan of three blocks with made-up figures: 1 planned, 2 partial, 3 refused, on the records of
/// sample_plan().
selion::Plan reported_plan();
