// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "kinds.hpp"

namespace selion {
namespace {

constexpr auto kLayouts = std::to_array<LayoutKind>({
    {"linear", "straight parallel swaths with headland passes around", lay_linear},
});

}  // namespace

std::span<const LayoutKind> layouts() { return kLayouts; }

}  // namespace selion
