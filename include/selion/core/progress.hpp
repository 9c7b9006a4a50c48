// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

namespace selion {

/// Told how far a long piece of work is: the stage's name and its done share in [0, 1]. Never null where it
/// is passed.
using Progress = std::function<void(std::string_view stage, double share)>;

inline void no_progress(std::string_view /*stage*/, double /*share*/) {}

}  // namespace selion
