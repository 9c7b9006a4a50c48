// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_map_samples.hpp"

#include <cmath>
#include <numbers>

#include "output/map_view.hpp"
#include "selion/core/angle.hpp"
#include "selion/core/units.hpp"
#include "selion/geometry/boolean.hpp"

namespace selion {
namespace {

constexpr const char* kProj =
    "+proj=tmerc +lat_0=46.336788 +lon_0=3.430409 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs "
    "+type=crs";

struct Maker {
  const SampleField& field;
  PlanPlane plane{kProj};
  PlanFile plan;

  LonLatLine lonlat(const Ring& ring) const {
    LonLatLine line;
    for (const Point p : ring) line.push_back(plane.to_lonlat(p));
    return line;
  }
  LonLatArea lonlat(const Polygon& area) const {
    LonLatArea out{lonlat(area.shell), {}};
    for (const Ring& hole : area.holes) out.holes.push_back(lonlat(hole));
    return out;
  }
  std::vector<LonLatArea> lonlat(const Polygons& areas) const {
    std::vector<LonLatArea> out;
    for (const Polygon& area : areas) out.push_back(lonlat(area));
    return out;
  }

  static PieceRecord straight(const std::string& kind, const std::string& ref, Point a, Point b, int tool) {
    PieceRecord piece;
    piece.kind = kind;
    piece.ref = ref;
    piece.x_m = a.x_m;
    piece.y_m = a.y_m;
    piece.heading_rad = heading_rad(b - a);
    piece.length_m = distance_m(a, b);
    piece.tool = tool;
    return piece;
  }

  void drive(TrajectoryRecord& out, const PieceRecord& piece) const { out.pieces.push_back(piece); }

  void headland(int block, const Polygon& part, TrajectoryRecord& drive_on) {
    const Polygons inner = inset({part}, field.headland_m);
    plan.headlands.push_back({block, lonlat(subtract({part}, inner)), field.headland_m, 0});
    int ring = 0;
    for (double depth = field.width_m / 2; depth < field.headland_m; depth += field.width_m) {
      ++ring;
      for (const Polygon& lane : inset({part}, depth)) {
        Ring closed = lane.shell;
        closed.push_back(closed.front());
        const std::string id = "H" + std::to_string(ring);
        plan.headland_passes.push_back({block, id, ring, lonlat(closed), field.width_m});
        if (!drive_on.pieces.empty()) {
          const PieceRecord& last = drive_on.pieces.back();
          const Point from = Point{last.x_m, last.y_m} + last.length_m * unit(last.heading_rad);
          drive(drive_on, straight("transfer", "", from, closed.front(), 0));
        }
        for (std::size_t i = 1; i < closed.size(); ++i)
          drive(drive_on, straight("headland_pass", id, closed[i - 1], closed[i], 1));
      }
    }
    plan.headlands.back().passes = ring;
  }

  void turn(TrajectoryRecord& out, Point from, double heading, Point to) const {
    const double side = cross(unit(heading), to - from) > 0 ? 1 : -1;
    const double radius = distance_m(from, to) / 2;
    PieceRecord piece = straight("turn", "", from, from + unit(heading), 0);
    piece.curvature_per_m = side / radius;
    piece.length_m = std::numbers::pi * radius;
    drive(out, piece);
  }

  void swaths(int block, const Polygon& part, TrajectoryRecord& out) {
    const Polygons inner = inset({part}, field.headland_m);
    const double along_rad = Heading::bearing_deg(field.bearing_deg).radians();
    const Point along = unit(along_rad);
    const Point right = -1.0 * left_of(along);
    const Point middle = centroid(part);
    double reach = 0;
    for (const Point p : part.shell) reach = std::max(reach, distance_m(p, middle));
    int number = 0;
    int order = 0;
    for (double across = -std::floor(reach / field.width_m) * field.width_m; across < reach;
         across += field.width_m) {
      const Point from = middle + across * right - reach * along;
      const auto spans = inside_spans(from, from + 2 * reach * along, inner);
      if (spans.empty()) continue;
      ++number;
      const bool up = number % 2 == 1;
      for (std::size_t i = 0; i < spans.size(); ++i) {
        const std::string id =
            std::to_string(number) + (spans.size() > 1 ? std::string(1, static_cast<char>('a' + i)) : "");
        const Point a = from + spans[i].from_m * along;
        const Point b = from + spans[i].to_m * along;
        plan.swaths.push_back({block, id, "1", lonlat({a, b}), field.width_m, distance_m(a, b), ++order});
        const Point start = up ? a : b;
        if (!out.pieces.empty() && out.pieces.back().kind == "swath") {
          const PieceRecord& last = out.pieces.back();
          const Point at = Point{last.x_m, last.y_m} + last.length_m * unit(last.heading_rad);
          if (distance_m(at, start) < 2.5 * field.width_m)
            turn(out, at, last.heading_rad, start);
          else
            drive(out, straight("transfer", "", at, start, 0));
        }
        drive(out, straight("swath", id, start, up ? b : a, 1));
        if (number == 1) plan.ab_lines.push_back({block, lonlat({a})[0], lonlat({b})[0], field.bearing_deg});
      }
    }
  }

  void make() {
    plan.version = "0.1.0";
    plan.proj = kProj;
    plan.origin = {3.430409, 46.336788};
    plan.id = "3f9c2a7be01d";
    FieldRecord record;
    record.name = "Sample";
    record.parts = lonlat(field.parts);
    plan.fields.push_back(record);
    int block = 0;
    for (const Polygon& part : field.parts) {
      TrajectoryRecord out;
      out.block = ++block;
      swaths(block, part, out);
      headland(block, part, out);
      if (out.pieces.empty()) continue;
      for (const PieceRecord& piece : out.pieces) out.line.push_back(plane.to_lonlat({piece.x_m, piece.y_m}));
      plan.trajectories.push_back(out);
    }
  }
};

}  // namespace

PlanFile sample_plan(const SampleField& field) {
  Maker maker{field, PlanPlane{kProj}, {}};
  maker.make();
  return maker.plan;
}

MapText sample_text() {
  MapText text;
  text.title = "Grand champ - seeding";
  text.data = {{"Field area", "5.09 ha"},
               {"Covered", "5.06 ha (99.4 %)"},
               {"Worked twice", "0.21 ha (4.1 %)"},
               {"Swaths", "62"},
               {"Working width", "3.00 m"},
               {"Headland", "9.0 m, 3 passes"},
               {"Driving distance", "18.4 km"},
               {"Working distance", "16.9 km"},
               {"Turns", "61"},
               {"Time", "3 h 42 min"}};
  text.assumptions = {"Machine: preset robot-3m, because none was given", "The ground is flat",
                      "The accuracy of the boundary is unknown: drive it once with RTK",
                      "Datum WGS 84: the corrections of the robot's receiver must use the same"};
  return text;
}

Polygon rectangle(Point corner, double width_m, double height_m) {
  return {
      {corner, corner + Point{width_m, 0}, corner + Point{width_m, height_m}, corner + Point{0, height_m}},
      {}};
}

}  // namespace selion
