// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "owner_crs.hpp"
#include "owner_file.hpp"

namespace selion::verifying {

/// Of a word of docs/input.md, however it is written; absent of any other.
std::optional<OwnerRole> role_named(const std::string& word);

/// A layer of OGR, opened.
struct OwnerLayer {
  void* handle = nullptr;
  std::string name;
  OwnerCrs crs;
  OwnerRole role = OwnerRole::field;    ///< of features that do not say
  OwnerRole fields = OwnerRole::field;  ///< what fields are taken for
};

/// Adds the fields and obstacles of the layer.
/// @throws InputError naming the feature whose properties say nothing that is known.
void add_features(std::vector<OwnerFeature>& features, const OwnerLayer& from);

}  // namespace selion::verifying
