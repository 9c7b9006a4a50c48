// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace selion {

/// One part of a batch that is shared out over several processes: every `count`th field, so that no part gets
/// all the large ones of a region.
struct Shard {
  int index = 1;  ///< from 1
  int count = 1;

  /// `number`: of a field, from 1.
  [[nodiscard]] bool has(std::size_t number) const {
    return (number - 1) % static_cast<std::size_t>(count) == static_cast<std::size_t>(index - 1);
  }
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// A variable of the environment, absent where it is not set.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;

/// From "I/N"; from "auto", which is the task that a scheduler runs (Slurm, Grid Engine, PBS, LSF, MPI), and
/// "auto/N" where it does not say of how many.
/// @throws InputError
Shard shard_of(const std::string& text, const Environment& environment);

/// "2-of-8"
std::string name_of(const Shard& shard);

}  // namespace selion
