// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates as text, by the rules of docs/input.md.
#include "owner_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>
#include <utility>

#include "letters.hpp"
#include "selion/core/error.hpp"

namespace selion::verifying {
namespace {

using Cells = std::vector<std::string>;

std::string trimmed(std::string_view text) {
  constexpr std::string_view kAround = " \t\r\"'";
  const auto from = text.find_first_not_of(kAround);
  if (from == std::string_view::npos) return {};
  return std::string{text.substr(from, text.find_last_not_of(kAround) + 1 - from)};
}

/// At the strongest separator that there is; runs of blanks are one.
Cells cells_of(std::string_view line) {
  constexpr std::string_view kSeparators = ";\t,";
  const auto found =
      std::ranges::find_if(kSeparators, [line](char c) { return line.find(c) != std::string_view::npos; });
  const char separator = found == kSeparators.end() ? ' ' : *found;
  Cells cells{""};
  for (const char c : line) {
    if (c == separator)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  for (std::string& cell : cells) cell = trimmed(cell);
  if (separator == ' ') std::erase(cells, "");
  return cells;
}

struct Ordinate {
  double value = 0;
  char letter = ' ';  ///< N, S, E or W, where one stands there
};

/// "9.887", "9,887", "E 9.887", "9.887 W", "9.887°".
std::optional<Ordinate> ordinate_of(std::string cell) {
  std::ranges::replace(cell, ',', '.');
  if (const auto degree = cell.find("\xC2\xB0"); degree != std::string::npos) cell.erase(degree, 2);
  Ordinate ordinate;
  for (const std::size_t end : {std::size_t{0}, cell.size() - 1}) {
    if (end >= cell.size() || std::string_view{"NSEWnsew"}.find(cell[end]) == std::string_view::npos)
      continue;
    ordinate.letter = static_cast<char>(std::toupper(static_cast<unsigned char>(cell[end])));
    cell.erase(end, 1);
    break;
  }
  cell = trimmed(cell);
  const bool has_sign = cell.starts_with('-') || cell.starts_with('+');
  if (has_sign && ordinate.letter != ' ') return std::nullopt;  // which of them is meant?
  if (cell.starts_with('+')) cell.erase(0, 1);
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), ordinate.value);
  if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(ordinate.value))
    return std::nullopt;
  if (ordinate.letter == 'S' || ordinate.letter == 'W') ordinate.value = -ordinate.value;
  return ordinate;
}

/// The column whose header begins with one of the words; as many as there are where none does.
template <std::size_t N>
std::size_t column_of(const Cells& header, const std::array<std::string_view, N>& words) {
  const auto column = std::ranges::find_if(header, [&](std::string cell) {
    cell.resize(std::min(cell.size(), cell.find_first_of(" _([/")));
    return std::ranges::find(words, lower(cell)) != words.end();
  });
  return static_cast<std::size_t>(column - header.begin());
}

struct Columns {
  std::size_t x = 0;
  std::size_t y = 1;
};

std::optional<Columns> columns_of(const Cells& header) {
  constexpr std::array<std::string_view, 7> kX{"lon", "long", "longitude", "lng", "x", "easting", "east"};
  constexpr std::array<std::string_view, 5> kY{"lat", "latitude", "y", "northing", "north"};
  const Columns columns{column_of(header, kX), column_of(header, kY)};
  return columns.x < header.size() && columns.y < header.size() ? std::optional{columns} : std::nullopt;
}

/// x and y.
std::optional<std::pair<double, double>> position_of(const Cells& cells, Columns columns) {
  if (std::max(columns.x, columns.y) >= cells.size()) return std::nullopt;
  const auto x = ordinate_of(cells[columns.x]);
  const auto y = ordinate_of(cells[columns.y]);
  if (!x || !y) return std::nullopt;
  const auto along = [](const Ordinate& o, std::string_view letters) {
    return letters.find(o.letter) != std::string_view::npos;
  };
  const bool swapped = along(*x, "NS") || along(*y, "EW");
  return swapped ? std::pair{y->value, x->value} : std::pair{x->value, y->value};
}

class Reader {
 public:
  Reader(TextOrder order, const ToWgs84& to_wgs84) : to_wgs84_{to_wgs84} {
    if (order == TextOrder::latlon) columns_ = {1, 0};
  }

  /// False where the line says something, but no position.
  bool take(std::string_view line) {
    const auto comment = line.find('#');
    line = line.substr(0, comment);
    if (trimmed(line).empty()) {
      if (comment == std::string_view::npos) end_ring();
      return true;
    }
    const Cells cells = cells_of(line);
    if (const auto header = begun_ ? std::nullopt : columns_of(cells)) {
      columns_ = *header;
      return true;
    }
    begun_ = true;
    const auto position = position_of(cells, columns_);
    if (position) rings_.back().push_back(to_wgs84_(position->first, position->second));
    return position.has_value();
  }

  LonLatArea area(const std::string& file) && {
    end_ring();
    rings_.pop_back();
    for (LonLatLine& ring : rings_) {
      if (ring.front() == ring.back()) ring.pop_back();
      if (ring.size() < 3) throw InputError{file + ": a ring has fewer than 3 positions"};
    }
    if (rings_.empty()) throw InputError{file + " holds no coordinates"};
    return {rings_.front(), {rings_.begin() + 1, rings_.end()}};
  }

 private:
  void end_ring() {
    if (!rings_.back().empty()) rings_.emplace_back();
  }

  const ToWgs84& to_wgs84_;
  Columns columns_;
  bool begun_ = false;
  std::vector<LonLatLine> rings_{1};  ///< the one under way stands last
};

}  // namespace

bool is_coordinate_text(const std::filesystem::path& file) {
  const std::string ending = lower(file.extension().string());
  constexpr std::array<std::string_view, 6> kEndings{".csv", ".txt", ".tsv", ".xyz", ".dat", ".pts"};
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

LonLatArea read_coordinate_text(const std::filesystem::path& file, TextOrder order, const ToWgs84& to_wgs84) {
  Reader reader{order, to_wgs84};
  std::ifstream text{file};
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
    if (!reader.take(line))
      throw InputError{file.string() + ", line " + std::to_string(number) + ": there is no position in '" +
                       trimmed(line).substr(0, 40) + "'"};
  }
  return std::move(reader).area(file.string());
}

}  // namespace selion::verifying
