// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "font.hpp"
#include "map_style.hpp"
#include "selion/output/map.hpp"

namespace selion {

/// A piece of the panel that is never broken: a heading, a legend entry, a figure, a paragraph.
struct PanelItem {
  double height_mm = 0;
  bool heads = false;                             ///< stays with the item after it
  std::function<void(Drawing&, PagePoint)> draw;  ///< from its upper left corner
};

std::vector<PanelItem> legend_items(const Font& font, const std::map<Mark, std::string>& drawn,
                                    double width_mm);
std::vector<PanelItem> data_items(const Font& font, const MapText& text, double width_mm);
/// In at most `most_lines`, of one note four; the others are counted.
std::vector<PanelItem> note_items(const Font& font, const std::vector<std::string>& notes,
                                  std::size_t most_lines, double width_mm);
/// The first `most` of them; the others are counted.
std::vector<PanelItem> assumption_items(const Font& font, const MapText& text, std::size_t most,
                                        double width_mm);

/// Least height in which the items, in order, fill `columns` columns.
double flowed_height_mm(const std::vector<PanelItem>& items, int columns);
void draw_flow(Drawing& page, const std::vector<PanelItem>& items, PageBox box, int columns, double gap_mm);

/// A framed box of warnings with its height; drawn from its upper left corner. @pre there are warnings.
PanelItem warning_box(const Font& font, const std::vector<std::string>& warnings, double width_mm);
/// Lines of text, one below the other.
PanelItem paragraph(const Font& font, const std::string& text, TextStyle style, double width_mm);

}  // namespace selion
