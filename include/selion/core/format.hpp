// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace selion {

/// `value` rounded to `decimals` (0 to 17) digits after a point, "12.50", the same in every locale; zero has
/// no sign.
/// @throws std::logic_error where `value` is not finite: no file of ours may hold that.
std::string fixed(double value, int decimals);

/// The same, written at the end of `out`: for files of many numbers.
void append_fixed(std::string& out, double value, int decimals);

/// 0, 1, ... as a, b, ..., z, aa, ab, ...: the pieces of one strip or pass.
std::string letters_of(std::size_t index);

}  // namespace selion
