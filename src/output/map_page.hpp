// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "map_panel.hpp"
#include "map_view.hpp"
#include "selion/output/map.hpp"

namespace selion {

/// Where everything stands on the page, measured before anything is drawn.
struct PageLayout {
  double width_mm = 210;
  double height_mm = 297;
  PageBox content;              ///< the page without its margins
  std::vector<PanelItem> head;  ///< title, plan, warnings; from the content's top
  std::vector<PanelItem> foot;  ///< from foot_top_mm
  double foot_top_mm = 0;
  PageBox frame;  ///< of the map
  PageBox scale;  ///< scale bars and north arrow
  PageBox panel;  ///< legend, figures, notes, assumptions
  int panel_columns = 1;
  double column_mm = 60;
  std::size_t data_shown = 0;
  std::size_t note_lines_shown = 0;
  std::size_t assumptions_shown = 0;
  double scale_denominator = 1000;
};

constexpr double kColumnGap_mm = 5;

/// Ground that the map must show, in the plan's plane.
struct Extent {
  Point low;
  Point high;
};

/// What has to find room.
struct PageContent {
  const PlanFile& plan;
  const MapText& text;
  const std::map<Mark, std::string>& legend;  ///< whatever may be drawn, in its longest words
  Extent extent;
};

/// The page, upright or lying, panel below or beside, on which the map comes out largest.
PageLayout page_layout(const PageContent& content, const Font& font, Paper paper);

/// Text of the panel, as far as the page has room for it.
std::vector<PanelItem> panel_items(const Font& font, const MapText& text,
                                   const std::map<Mark, std::string>& legend, const PageLayout& layout);

}  // namespace selion
