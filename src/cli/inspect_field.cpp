// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "inspect.hpp"
#include "selion/core/error.hpp"
#include "selion/core/format.hpp"
#include "selion/core/json_writer.hpp"
#include "selion/core/units.hpp"
#include "selion/field/block.hpp"
#include "selion/field/frame.hpp"
#include "selion/plan/text.hpp"
#include "terminal.hpp"

namespace selion::cli {
namespace {

std::string_view name_of(ObstacleKind kind) {
  switch (kind) {
    case ObstacleKind::no_go:
      return "no_go";
    case ObstacleKind::water:
      return "water";
    case ObstacleKind::obstacle:
      break;
  }
  return "obstacle";
}

std::string place_text(LonLat p) { return fixed(p.lon_deg, 6) + ", " + fixed(p.lat_deg, 6); }

std::string area_text(const FieldView& view, Units units) {
  if (!view.area_m2) return "area not known";
  return units == Units::imperial ? fixed(acres_of_m2(*view.area_m2), 2) + " ac"
                                  : fixed(hectares_of_m2(*view.area_m2), 2) + " ha";
}

std::string accuracy_text(const Field& field) {
  if (!field.datum_accuracy_m) return ", step to WGS84 of unknown accuracy";
  return *field.datum_accuracy_m == 0
             ? ""
             : ", step to WGS84 good to " + number_text(*field.datum_accuracy_m) + " m";
}

void clean(FieldView& view) {
  try {
    view.centre = centre(view.field);
    const Blocks blocks = blocks_of(view.field, LocalFrame::centred(view.centre), BlockOptions{});
    double area = 0;
    for (const Block& block : blocks.blocks) area += area_m2(block.area);
    view.area_m2 = area;
    view.blocks = static_cast<int>(blocks.blocks.size());
    view.notes = blocks.notes;
  } catch (const InputError& error) {
    view.problem = error.what();
  }
}

void write_place(JsonWriter& json, LonLat p) {
  json.begin_array(JsonSpread::line).number(p.lon_deg, 9).number(p.lat_deg, 9).end();
}

void write_optional(JsonWriter& json, std::optional<double> value, int decimals) {
  if (value)
    json.number(*value, decimals);
  else
    json.raw("null");
}

void write_texts(JsonWriter& json, std::string_view key, const std::vector<std::string>& texts) {
  json.key(key).begin_array(JsonSpread::line);
  for (const std::string& text : texts) json.text(text);
  json.end();
}

void write_gates(JsonWriter& json, const std::vector<Gate>& gates) {
  json.key("gates").begin_array(JsonSpread::line);
  for (const Gate& gate : gates) {
    json.begin_object(JsonSpread::line).key("name").text(gate.name).key("at");
    write_place(json, gate.at);
    json.key("width_m");
    write_optional(json, gate.width_m, 2);
    json.end();
  }
  json.end();
}

void write_obstacles(JsonWriter& json, const std::vector<Obstacle>& obstacles) {
  json.key("obstacles").begin_array(JsonSpread::line);
  for (const Obstacle& obstacle : obstacles)
    json.begin_object(JsonSpread::line)
        .key("name")
        .text(obstacle.name)
        .key("what")
        .text(name_of(obstacle.kind))
        .end();
  json.end();
}

void write_counts(JsonWriter& json, const FieldView& view) {
  json.key("parts").whole(static_cast<long long>(view.field.parts.size()));
  json.key("holes").whole(view.holes).key("vertices").whole(view.vertices).key("blocks").whole(view.blocks);
  json.key("area_m2");
  write_optional(json, view.area_m2, 1);
  json.key("centre");
  write_place(json, view.centre);
}

void write_view(JsonWriter& json, const FieldView& view) {
  const Field& field = view.field;
  json.begin_object(JsonSpread::lines).key("number").whole(field.number);
  json.key("name").text(field.name).key("source").text(field.source);
  write_counts(json, view);
  json.key("crs").text(field.source_crs).key("datum").text(field.datum).key("datum_accuracy_m");
  write_optional(json, field.datum_accuracy_m, 3);
  write_obstacles(json, field.obstacles);
  write_gates(json, field.gates);
  json.key("attributes").begin_object(JsonSpread::line);
  for (const auto& [key, value] : field.attributes) json.key(key).text(value);
  json.end();
  std::vector<std::string> notes = field.notes;
  notes.insert(notes.end(), view.notes.begin(), view.notes.end());
  write_texts(json, "notes", notes);
  write_texts(json, "problems",
              view.problem.empty() ? std::vector<std::string>{} : std::vector{view.problem});
  json.end();
}

std::string counted(std::size_t number, const std::string& one, const std::string& many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

}  // namespace

FieldView view_of(const Field& field) {
  FieldView view;
  view.field = field;
  for (const LonLatPolygon& part : field.parts) {
    view.vertices += static_cast<int>(part.shell.size());
    view.holes += static_cast<int>(part.holes.size());
    for (const LonLatRing& hole : part.holes) view.vertices += static_cast<int>(hole.size());
  }
  clean(view);
  return view;
}

std::string text_of(const FieldView& view, Units units) {
  const Field& field = view.field;
  std::string out = "\n" + std::to_string(field.number) + "  " + printable(field.name) + ": " +
                    area_text(view, units) + "\n";
  out += "   " + counted(field.parts.size(), "part", "parts") + ", " +
         counted(static_cast<std::size_t>(view.holes), "hole", "holes") + ", " +
         counted(static_cast<std::size_t>(view.vertices), "vertex", "vertices") + ", centre " +
         place_text(view.centre) + " (longitude, latitude)\n";
  out +=
      "   " + printable(field.source_crs) + ", datum " + printable(field.datum) + accuracy_text(field) + "\n";
  for (const Gate& gate : field.gates)
    out += "   gate " + printable(gate.name) + " at " + place_text(gate.at) +
           (gate.width_m ? ", " + number_text(*gate.width_m) + " m wide" : "") + "\n";
  for (const Obstacle& obstacle : field.obstacles)
    out += "   " + std::string{name_of(obstacle.kind)} + " " + printable(obstacle.name) + "\n";
  for (const std::string& note : field.notes) out += "   note: " + printable(note) + "\n";
  for (const std::string& note : view.notes) out += "   note: " + printable(note) + "\n";
  if (!view.problem.empty()) out += "   problem: " + printable(view.problem) + "\n";
  return out;
}

std::string json_of(std::span<const FieldView> views, const std::string& file) {
  JsonWriter json;
  json.begin_object(JsonSpread::lines).key("file").text(file).key("kind").text("fields");
  json.key("fields").begin_array(JsonSpread::lines);
  for (const FieldView& view : views) write_view(json, view);
  return json.end().end().str() + "\n";
}

}  // namespace selion::cli
