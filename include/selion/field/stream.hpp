// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "selion/field/field.hpp"
#include "selion/field/read.hpp"

namespace selion {

/// The fields of a file one after another, for files that memory would not hold: the same fields, names and
/// notes as read_fields gives, but a feature that cannot be read is a matter of its own.
///
/// The file is read twice, first for what concerns it as a whole: obstacles and gates, which fields touch.
/// Kept of each field are less than 200 bytes, and of its boundary nothing (but of text, JSON, XML and
/// archives: all). One thread at a time.
class FieldStream {
 public:
  /// @throws InputError where the file as a whole cannot be read; `options.field` is not looked at.
  FieldStream(const std::filesystem::path& path, const ReadOptions& options);
  FieldStream(const FieldStream&) = delete;
  FieldStream& operator=(const FieldStream&) = delete;
  FieldStream(FieldStream&&) noexcept;
  FieldStream& operator=(FieldStream&&) noexcept;
  ~FieldStream();

  /// How many features with polygons there are to come, those that turn out to be no fields included.
  [[nodiscard]] std::size_t size() const;
  /// What there is to say of the file as a whole; the first field's notes begin with it.
  [[nodiscard]] const std::vector<std::string>& notes() const;

  struct Feature {
    std::string layer;  ///< empty where the file has one
    int number = 1;
    std::string name;
  };
  /// The next feature; absent at the end.
  std::optional<Feature> next();
  /// The field that it is. @throws InputError naming feature, ring and coordinate, and what to do.
  [[nodiscard]] Field field();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace selion
