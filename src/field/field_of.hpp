// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "selion/field/field.hpp"
#include "sources.hpp"

namespace selion {

/// The field that a feature is, without what lies beside it (attach(), note_neighbours()).
/// @throws InputError as located() does.
Field field_of(const RawFeature& raw, Source& source, const std::string& name, const ReadOptions& options);

/// `where`: the feature.
std::string too_large_note(const std::string& where);
/// `numbers`: of the features, with commas between.
std::string skipped_note(const Source& source, const std::string& numbers);

}  // namespace selion
