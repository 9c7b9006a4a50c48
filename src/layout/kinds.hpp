// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/layout/layout.hpp"

namespace selion {

Result<Layout> lay_linear(const Block& block, const Machine& machine, const LayoutOptions& options);

}  // namespace selion
