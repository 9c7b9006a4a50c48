// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace selion {

/// What the user gave cannot be used: file, option, job or geometry. The message says where, what and what to
/// do.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The input is fine, but no answer exists. `reason` names what does not fit, what is needed and what there
/// is.
struct Infeasible {
  std::string reason;

  friend bool operator==(const Infeasible&, const Infeasible&) = default;
};

/// A value or the reason why there is none; spelled like C++23's std::expected.
template <class T>
class Result {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): either is returned as it is, as with std::expected
  Result(T value) : held_{std::in_place_index<0>, std::move(value)} {}
  // NOLINTNEXTLINE(google-explicit-constructor): either is returned as it is, as with std::expected
  Result(Infeasible reason) : held_{std::in_place_index<1>, std::move(reason)} {}

  [[nodiscard]] bool has_value() const { return held_.index() == 0; }
  explicit operator bool() const { return has_value(); }
  const T& operator*() const& { return std::get<0>(held_); }
  T& operator*() & { return std::get<0>(held_); }
  T&& operator*() && { return std::get<0>(std::move(held_)); }
  const T* operator->() const { return &std::get<0>(held_); }
  T* operator->() { return &std::get<0>(held_); }
  [[nodiscard]] const Infeasible& error() const { return std::get<1>(held_); }

 private:
  std::variant<T, Infeasible> held_;
};

}  // namespace selion
