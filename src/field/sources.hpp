// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "georeference.hpp"
#include "names.hpp"
#include "raw.hpp"

namespace selion {

/// One call of read_fields: what was asked for, and what there is to say of the files as a whole.
struct Reading {
  const ReadOptions& options;
  std::istream& standard_input;
  std::vector<std::string> notes;
};

/// One layer of a file, with its way to WGS84.
struct Source {
  const RawFile* file = nullptr;
  const RawLayer* layer = nullptr;
  std::optional<Role> role;                  ///< of the whole layer
  std::optional<Georeference> georeference;  ///< absent until the layer is known to be read

  [[nodiscard]] std::string where() const;
  [[nodiscard]] std::string where(const RawFeature& feature) const;
  [[nodiscard]] Role role_of(const RawFeature& feature) const;
};

/// Gives `source` what its file says, else the option.
/// @throws InputError where neither says, or both and differently.
void georeference(Source& source, Reading& reading);

/// The layers to read, georeferenced: the one (of folders: all) that holds fields, then those named for a
/// role. @throws InputError where none holds fields, or the choice is the user's.
std::vector<Source> sources_of(const RawFile& file, Reading& reading);

/// @throws InputError that says what the file has instead.
[[noreturn]] void refuse_without_polygons(const RawFile& file);

}  // namespace selion
