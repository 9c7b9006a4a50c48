// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "selion/field/field.hpp"
#include "selion/plan/job.hpp"

namespace selion {

/// One of data/fields.
Field field_named(const std::string& name);

/// A field of about 20 ha with a winding border of `corners` corners; the same on every machine.
Field wavy_field(int corners);

/// 1000 m by 1000 m with six holes of 24 m by 24 m to 60 m by 40 m.
Field square_kilometre();

/// The paper's robots as one machine 4 m wide, forwards only (docs/performance.md).
Job four_metres();

/// The paper's robot alone: 1 m wide.
Job one_metre();

}  // namespace selion
