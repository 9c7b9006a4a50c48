// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "selion/core/point.hpp"

namespace selion {

/// Corners in order, not repeated at the end; any winding.
using LonLatRing = std::vector<LonLat>;

struct LonLatPolygon {
  LonLatRing shell;
  std::vector<LonLatRing> holes;

  friend bool operator==(const LonLatPolygon&, const LonLatPolygon&) = default;
};

/// A way into the field; snapped to the border when blocks are made.
struct Gate {
  std::string name;
  LonLat at;
  std::optional<double> width_m;

  friend bool operator==(const Gate&, const Gate&) = default;
};

enum class ObstacleKind { obstacle, no_go, water };

struct Obstacle {
  std::string name;
  ObstacleKind kind = ObstacleKind::obstacle;
  LonLatPolygon area;

  friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

/// One field as read, in WGS84, ring by ring as the file has it (cleaning comes with the blocks).
struct Field {
  int number = 1;    ///< of the feature in its file, from 1
  std::string name;  ///< from an attribute (name, Name, NAME, field, id ...), else the file's name
  std::vector<LonLatPolygon> parts;
  std::vector<Obstacle> obstacles;
  std::vector<Gate> gates;
  std::string source;      ///< file, layer and feature, for messages
  std::string source_crs;  ///< "EPSG:28992 (Amersfoort / RD New)"
  std::string datum;       ///< the source's datum, "World Geodetic System 1984"
  std::optional<double>
      datum_accuracy_m;  ///< PROJ's stated accuracy of the step to WGS84; absent where PROJ does not know
  std::map<std::string, std::string> attributes;
  std::vector<std::string> notes;  ///< what was skipped, assumed or warned of while reading

  friend bool operator==(const Field&, const Field&) = default;
};

}  // namespace selion
