// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string_view>

#include "raw.hpp"
#include "selion/core/error.hpp"

namespace selion {
namespace {

/// Of `<kml:name ...>` and its like what counts: the name, and whether it opens, closes or does both.
struct Tag {
  std::string_view name;
  bool closes = false;
  bool is_empty = false;
};

/// Behind the next of `end`, or at the end of the text.
void skip_past(std::string_view& text, std::string_view end) {
  const auto at = text.find(end);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + end.size());
}

/// Takes the text up to the end of the next tag off; comments and CDATA hold none.
bool next_tag(std::string_view& text, Tag& tag) {
  while (true) {
    const auto open = text.find('<');
    if (open == std::string_view::npos) return false;
    text.remove_prefix(open + 1);
    if (text.starts_with("!--"))
      skip_past(text, "-->");
    else if (text.starts_with("![CDATA["))
      skip_past(text, "]]>");
    else
      break;
  }
  const std::string_view whole = text.substr(0, text.find('>'));
  skip_past(text, ">");
  tag = {whole, whole.starts_with('/'), whole.ends_with('/')};
  if (tag.closes) tag.name.remove_prefix(1);
  tag.name = tag.name.substr(0, tag.name.find_first_of(" \t\r\n/"));
  if (const auto colon = tag.name.find(':'); colon != std::string_view::npos)
    tag.name.remove_prefix(colon + 1);
  return true;
}

/// Counts the rings of each polygon: GDAL keeps the last outer one, and takes an inner one for it where there
/// is none.
class RingCount {
 public:
  void take(const Tag& tag) {
    if (tag.name == "Polygon") {
      outer_ = inner_ = 0;
      side_ = nullptr;
      if (!tag.closes) ++polygons_;
    } else if (tag.name == "outerBoundaryIs" || tag.name == "innerBoundaryIs") {
      const bool opens = !tag.closes && !tag.is_empty;
      side_ = !opens ? nullptr : tag.name.front() == 'o' ? &outer_ : &inner_;
    } else if (tag.name == "LinearRing" && !tag.closes && side_ != nullptr) {
      ++*side_;
    }
  }
  /// Of the polygon whose end was just reached; null where it has one outer ring, or none at all.
  [[nodiscard]] const char* fault() const {
    if (outer_ > 1)
      return " has more than one outer ring (outerBoundaryIs): give each part a Polygon of its own in a "
             "MultiGeometry";
    return outer_ == 0 && inner_ > 0 ? " has an inner ring (innerBoundaryIs), but no outer one: give it its "
                                       "border as outerBoundaryIs"
                                     : nullptr;
  }
  [[nodiscard]] int polygons() const { return polygons_; }

 private:
  int polygons_ = 0;
  int outer_ = 0;
  int inner_ = 0;
  int* side_ = nullptr;  // to be counted in
};

}  // namespace

void check_kml_rings(std::string_view text, const std::string& label) {
  RingCount count;
  Tag tag;
  for (std::string_view rest = text; next_tag(rest, tag);) {
    const bool polygon_ends = tag.closes && tag.name == "Polygon";
    if (const char* fault = polygon_ends ? count.fault() : nullptr) {
      const std::string_view before = text.substr(0, text.size() - rest.size());
      throw InputError{label + ", line " + std::to_string(1 + std::ranges::count(before, '\n')) +
                       ": Polygon " + std::to_string(count.polygons()) + fault};
    }
    count.take(tag);
  }
}

}  // namespace selion
