// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

namespace selion {

/// Runs the benchmarks of every figure that docs/performance.md states, several times each, and prints its
/// table.
void print_figures(std::ostream& out);

}  // namespace selion
