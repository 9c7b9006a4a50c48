// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "raw.hpp"

namespace selion {

/// What a feature or a whole layer holds.
enum class Role { field, obstacle, no_go, water, gate };

/// Of a layer called so: obstacle(s), gate(s), no_go, no-go, water.
std::optional<Role> role_of_layer(const std::string& name);
/// Of that key (in small letters), else of one that differs in case only; null where there is none.
const std::string* attribute(const RawFeature& feature, const std::string& key);
/// From the property `selion`. @throws InputError for a value that is none.
std::optional<Role> role_of_feature(const RawFeature& feature, const std::string& where);

/// From an attribute name, field, field_name, title, label, id ..., in this order and in any case.
std::optional<std::string> name_of(const RawFeature& feature);
/// Names for the features of a file, given one after another: the feature's own, else `stem` (with its number
/// where there are several); namesakes get a number. Keeps 64 bits of each name, not the name.
class UniqueNames {
 public:
  UniqueNames(std::string stem, std::size_t features) : stem_{std::move(stem)}, features_{features} {}

  std::string next(const RawFeature& feature);

 private:
  std::string stem_;
  std::size_t features_;
  std::unordered_map<std::size_t, int> next_;  // by a name's hash: the number that its next namesake tries
};

/// A name for each feature, as UniqueNames gives them.
std::vector<std::string> unique_names(const std::vector<const RawFeature*>& features,
                                      const std::string& stem);

/// The one that `wanted` names, by its name or else by its number in the file.
/// @throws InputError listing the nearest names.
std::size_t selected(const std::vector<const RawFeature*>& features, const std::vector<std::string>& names,
                     const std::string& wanted, const std::string& label);

}  // namespace selion
