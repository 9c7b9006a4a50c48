// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "raw.hpp"
#include "selion/core/error.hpp"
#include "text.hpp"

namespace selion {
namespace {

/// The root element's name without its prefix; empty where none is found.
std::string root_name(std::string_view text) {
  while (true) {
    const auto open = text.find('<');
    if (open == std::string_view::npos) return {};
    text.remove_prefix(open + 1);
    std::string_view close;
    if (text.starts_with("!--"))
      close = "-->";
    else if (text.starts_with("?"))
      close = "?>";
    else if (text.starts_with("!"))
      close = ">";
    else
      break;
    const auto end = text.find(close);
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + close.size());
  }
  std::string_view name = text.substr(0, text.find_first_of(" \t\r\n/>"));
  if (const auto colon = name.find(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
  return std::string{name};
}

bool is_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

/// "lon,lat[,height]"
bool is_tuple(std::string_view tuple) {
  int numbers = 0;
  while (true) {
    const auto comma = tuple.find(',');
    if (!is_number(tuple.substr(0, comma))) return false;
    ++numbers;
    if (comma == std::string_view::npos) return numbers == 2 || numbers == 3;
    tuple.remove_prefix(comma + 1);
  }
}

struct Joined {
  std::string text;         ///< every run of blanks one blank, those beside commas gone
  bool had_blanks = false;  ///< beside commas
};

/// "1, 2, 0 3, 4, 0" is meant as "1,2,0 3,4,0".
Joined joined_at_commas(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  Joined joined;
  while (!text.empty()) {
    const auto blank = text.find_first_of(kBlanks);
    joined.text += text.substr(0, blank);
    if (blank == std::string_view::npos) break;
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks, blank), text.size()));
    const bool at_comma = (!joined.text.empty() && joined.text.back() == ',') || text.starts_with(',');
    if (at_comma)
      joined.had_blanks = true;
    else
      joined.text += ' ';
  }
  return joined;
}

struct KmlCheck {
  std::string label;
  bool had_blanks = false;

  void coordinates(std::string_view text, int element) {
    const Joined joined = joined_at_commas(text);
    had_blanks = had_blanks || joined.had_blanks;
    std::string_view rest = joined.text;
    for (int number = 1;; ++number) {
      const auto from = rest.find_first_not_of(' ');
      if (from == std::string_view::npos) return;
      rest.remove_prefix(from);
      const std::string_view tuple = rest.substr(0, rest.find(' '));
      if (!is_tuple(tuple))
        throw InputError{label + ", coordinates element " + std::to_string(element) + ", coordinate " +
                         std::to_string(number) + ": '" + std::string{tuple.substr(0, 60)} +
                         "' is no longitude,latitude; correct it"};
      rest.remove_prefix(tuple.size());
    }
  }
};

std::vector<std::string> check_kml(std::string_view text, const std::string& label) {
  constexpr std::string_view kOpen = "<coordinates>";
  constexpr std::string_view kClose = "</coordinates>";
  KmlCheck check{label};
  for (int element = 1;; ++element) {
    const auto from = text.find(kOpen);
    if (from == std::string_view::npos) break;
    text.remove_prefix(from + kOpen.size());
    const auto to = text.find(kClose);
    if (to == std::string_view::npos)
      throw InputError{label + " ends inside a coordinates element: it is truncated; export it anew"};
    check.coordinates(text.substr(0, to), element);
    text.remove_prefix(to);
  }
  if (!check.had_blanks) return {};
  return {label + ": blanks beside commas in its coordinates are taken out"};
}

}  // namespace

std::vector<std::string> check_xml(const std::string& text, const std::string& label) {
  std::string ascii = text;
  std::erase(ascii, '\0');  // UTF-16 would hide the words looked for
  if (ascii.find("<!ENTITY") != std::string::npos)
    throw InputError{label +
                     " declares XML entities, which field files do not need and which can fill the memory; "
                     "save it without them"};
  const std::string root = root_name(ascii);
  if (root.empty()) throw InputError{label + " is no complete XML file; export it anew"};
  if (root == "ISO11783_TaskData" || root == "XFC")
    throw InputError{label +
                     " is ISOXML, which is not supported yet; export the field as GeoJSON, KML or shapefile"};
  if (lower(root) != "kml") return {};
  std::vector<std::string> notes = check_kml(ascii, label);
  check_kml_rings(ascii, label);
  return notes;
}

}  // namespace selion
