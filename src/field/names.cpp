// SPDX-License-Identifier: GPL-3.0-or-later
#include "names.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>

#include "selion/core/error.hpp"
#include "text.hpp"

namespace selion {
namespace {

std::optional<Role> role_named(const std::string& word) {
  std::string name = lower(word);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == ' '; }, '_');
  if (name == "obstacle" || name == "obstacles") return Role::obstacle;
  if (name == "gate" || name == "gates") return Role::gate;
  if (name == "no_go" || name == "nogo") return Role::no_go;
  if (name == "water") return Role::water;
  return std::nullopt;
}

}  // namespace

std::optional<Role> role_of_layer(const std::string& name) { return role_named(name); }

const std::string* attribute(const RawFeature& feature, const std::string& key) {
  if (const auto exact = feature.attributes.find(key); exact != feature.attributes.end())
    return &exact->second;
  for (const std::string& name : feature.attribute_order)
    if (lower(name) == key) return &feature.attributes.at(name);
  return nullptr;
}

std::optional<Role> role_of_feature(const RawFeature& feature, const std::string& where) {
  const std::string* word = attribute(feature, "selion");
  if (word == nullptr) return std::nullopt;
  if (lower(*word) == "field") return Role::field;
  const auto role = role_named(*word);
  if (!role)
    throw InputError{where + ": its property selion is '" + word->substr(0, 40) +
                     "', but must be field, obstacle, gate, no_go or water"};
  return role;
}

std::optional<std::string> name_of(const RawFeature& feature) {
  constexpr std::array<const char*, 9> kKeys{"name",  "field", "field_name", "fieldname", "title",
                                             "label", "id",    "uid",        "fid"};
  for (const char* key : kKeys)
    for (const std::string& attribute : feature.attribute_order)
      if (lower(attribute) == key && !feature.attributes.at(attribute).empty())
        return feature.attributes.at(attribute);
  return std::nullopt;
}

std::string UniqueNames::next(const RawFeature& feature) {
  const std::hash<std::string> hash;
  const auto own = name_of(feature);
  const std::string base = own ? *own : features_ == 1 ? stem_ : stem_ + " " + std::to_string(feature.number);
  std::string name = base;
  while (!next_.try_emplace(hash(name), 2).second) {
    int& number = next_.at(hash(base));
    name = base + " (" + std::to_string(number++) + ")";
  }
  return name;
}

std::vector<std::string> unique_names(const std::vector<const RawFeature*>& features,
                                      const std::string& stem) {
  UniqueNames give{stem, features.size()};
  std::vector<std::string> names;
  names.reserve(features.size());
  for (const RawFeature* feature : features) names.push_back(give.next(*feature));
  return names;
}

std::size_t selected(const std::vector<const RawFeature*>& features, const std::vector<std::string>& names,
                     const std::string& wanted, const std::string& label) {
  if (const auto named = std::find(names.begin(), names.end(), wanted); named != names.end())
    return static_cast<std::size_t>(named - names.begin());
  int number = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  if (error == std::errc{} && end == wanted.data() + wanted.size())
    for (std::size_t i = 0; i < features.size(); ++i)
      if (features[i]->number == number) return i;
  throw InputError{label + " has no field '" + wanted + "' among " + std::to_string(features.size()) +
                   "; give a number or a name such as " + nearest_names(names, wanted)};
}

}  // namespace selion
