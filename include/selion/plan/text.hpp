// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace selion {

/// The fewest digits that read back as `value`, without exponent: "0.3", "1500". In no locale anything else.
std::string number_text(double value);

/// All of `text` as a finite number with a decimal point; a leading + is let pass.
std::optional<double> number_of_text(std::string_view text);

/// In double quotes, escaped as JSON and TOML both read it.
std::string in_quotes(std::string_view text);

}  // namespace selion
