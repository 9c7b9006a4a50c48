// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "selion/field/field.hpp"

namespace selion {

/// What holds a field, in any plane.
struct FieldExtent {
  double low_x = 0;
  double low_y = 0;
  double high_x = 0;
  double high_y = 0;
};

/// Two fields whose extents overlap, by their places in the file.
struct Overlap {
  std::uint32_t later = 0;
  std::uint32_t earlier = 0;

  friend bool operator<(const Overlap& a, const Overlap& b) {
    return a.later != b.later ? a.later < b.later : a.earlier < b.earlier;
  }
};

/// In order of the later one, then of the earlier one; of each later one a thousand at most.
std::vector<Overlap> overlaps_of(const std::vector<FieldExtent>& extents);

/// Notes on one field where it is the same as earlier ones, or overlaps them by more than 1 % and a metre's
/// width: ten, then that there are others.
class NeighbourNotes {
 public:
  explicit NeighbourNotes(Field& field) : field_{field} {}
  /// False once enough is told.
  bool compare_with(const Field& earlier);

 private:
  Field& field_;
  int told_ = 0;
};

/// Those of all fields of a file.
void note_neighbours(std::vector<Field>& fields);

}  // namespace selion
