// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "font.hpp"
#include "label_placer.hpp"
#include "map_style.hpp"
#include "map_view.hpp"
#include "selion/output/map.hpp"

namespace selion {

/// A stretch that is driven, as it lies on the page.
struct DrawnTrack {
  Mark mark = Mark::turn;  ///< headland_pass, swath, turn, transfer, reverse
  std::string ref;
  PageLine line;  ///< in the direction of travel
};

/// The map while it is drawn.
struct MapSheet {
  const PlanFile& plan;
  MapView view;
  const Font& font;
  Units units;
  std::vector<DrawnTrack> tracks;
  LabelPlacer placer;
  Drawing page;
  std::map<Mark, std::string> drawn;  ///< what is on the map, with its words in the legend
};

/// Whatever `draw` adds stands in a layer of its own; the legend has it if that is anything at all.
template <class Draw>
void in_layer(MapSheet& sheet, Mark mark, Draw draw) {
  const std::size_t before = sheet.page.items.size();
  sheet.page.add(LayerStart{std::string{style_of(mark).layer}, {}});
  draw();
  if (sheet.page.items.size() == before + 1) return sheet.page.items.pop_back();
  sheet.page.add(LayerEnd{});
  sheet.drawn.try_emplace(mark, style_of(mark).legend);
}

/// The driven stretches of the plan's trajectories, from their pieces; neighbours of one kind are one line.
std::vector<DrawnTrack> tracks_of(const PlanFile& plan, const MapView& view);

/// Every how many-th swath is drawn so that lines stay apart on paper. Odd, so that directions still
/// alternate.
int drawn_step(const PlanFile& plan, const MapView& view);
/// Whether passes lie so close on paper that their lines, turns and the headland's would run together.
bool is_crowded(const PlanFile& plan, const MapView& view);
/// The number that an id begins with, "12" of "12a"; 0 of "P3".
int strip_number(const std::string& id);
/// Lowest and highest strip number of a block; both 0 where it has none.
struct StripRange {
  int first = 0;
  int last = 0;
};
std::map<int, StripRange> strips_by_block(const PlanFile& plan);
/// Whether a swath is among those drawn when only every `step`-th is.
bool is_in_step(const SwathRecord& swath, StripRange strips, int step);

void draw_areas(MapSheet& sheet);           // map_areas.cpp: headland, cells
void draw_obstacles(MapSheet& sheet);       // map_areas.cpp: holes, obstacles
void draw_boundary(MapSheet& sheet);        // map_areas.cpp
void draw_obstacle_names(MapSheet& sheet);  // map_areas.cpp
void draw_lanes(MapSheet& sheet);           // map_tracks.cpp: passes, swaths, turns, transfers
void draw_places(MapSheet& sheet);          // map_places.cpp: gates, start, end, A and B
void draw_place_names(MapSheet& sheet);     // map_places.cpp
void draw_numbers(MapSheet& sheet);         // map_numbers.cpp: swath numbers
void draw_order(MapSheet& sheet);           // map_numbers.cpp: places in the driving order
void draw_directions(MapSheet& sheet);      // map_numbers.cpp: arrowheads

/// Frame, ticks with their numbers outside of it, crosses inside.
void draw_graticule(Drawing& page, const MapView& view, const Font& font);
/// Scale bars in metres and feet, numeric scale and north arrow in `box`.
void draw_scale_and_north(Drawing& page, const MapView& view, const Font& font, PageBox box, Units units);

}  // namespace selion
