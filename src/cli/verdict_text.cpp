// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict_text.hpp"

#include <algorithm>
#include <string_view>

#include "selion/core/format.hpp"
#include "selion/core/json_writer.hpp"
#include "terminal.hpp"

namespace selion::cli {
namespace {

std::string place_text(LonLat at) { return fixed(at.lon_deg, 7) + ", " + fixed(at.lat_deg, 7); }

std::string right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string finding_text(const Finding& finding) {
  return "  " + finding.code + ": " +
         (finding.block > 0 ? "block " + std::to_string(finding.block) + ": " : "") +
         printable(finding.what) + (finding.at ? "\n      at " + place_text(*finding.at) : "") + "\n";
}

std::string places_text(std::string_view title, const std::vector<VerifiedPlace>& places) {
  constexpr std::size_t kShown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, places.size()); ++i)
    text += right(fixed(places[i].area_m2, 1), 12) + " m2  at " + place_text(places[i].at) + "\n";
  if (places.size() > kShown) text += "    and " + std::to_string(places.size() - kShown) + " smaller ones\n";
  return text.empty() ? text : std::string{title} + text;
}

std::string watch_text(std::string_view title, const std::vector<WatchPlace>& places) {
  std::string text;
  for (const WatchPlace& place : places)
    text += right(fixed(place.measure_m, 2), 10) + " m  " + right(fixed(place.t_s, 1), 9) + " s  " +
            place_text(place.at) + "  " + place.what +
            (place.robot > 1 ? ", robot " + std::to_string(place.robot) : "") + "\n";
  return text.empty() ? text : std::string{title} + text;
}

void add_place(JsonWriter& json, LonLat at) {
  json.key("at").begin_array(JsonSpread::line).number(at.lon_deg, 9).number(at.lat_deg, 9).end();
}

void add_findings(JsonWriter& json, const Verdict& verdict) {
  json.key("findings").begin_array(JsonSpread::lines);
  for (const Finding& finding : verdict.findings) {
    json.begin_object(JsonSpread::line).key("code").text(finding.code).key("block").whole(finding.block);
    if (finding.at) add_place(json, *finding.at);
    json.key("measure").number(finding.measure, 6).key("limit").number(finding.limit, 6);
    json.key("what").text(finding.what).end();
  }
  json.end();
}

void add_ring(JsonWriter& json, const LonLatLine& ring) {
  json.begin_array(JsonSpread::line);
  const auto corner = [&json](LonLat p) {
    json.begin_array(JsonSpread::line).number(p.lon_deg, 9).number(p.lat_deg, 9).end();
  };
  for (const LonLat p : ring) corner(p);
  corner(ring.front());
  json.end();
}

void add_places(JsonWriter& json, const char* key, const std::vector<VerifiedPlace>& places) {
  json.key(key).begin_array(JsonSpread::lines);
  for (const VerifiedPlace& place : places) {
    json.begin_object(JsonSpread::line).key("block").whole(place.block);
    json.key("area_m2").number(place.area_m2, 2);
    add_place(json, place.at);
    json.key("polygon").begin_array(JsonSpread::line);
    add_ring(json, place.area.shell);
    for (const LonLatLine& hole : place.area.holes) add_ring(json, hole);
    json.end().end();
  }
  json.end();
}

void add_watch(JsonWriter& json, const char* key, const std::vector<WatchPlace>& places) {
  json.key(key).begin_array(JsonSpread::lines);
  for (const WatchPlace& place : places) {
    json.begin_object(JsonSpread::line).key("what").text(place.what).key("block").whole(place.block);
    json.key("robot").whole(place.robot).key("t_s").number(place.t_s, 2);
    json.key("measure_m").number(place.measure_m, 3);
    add_place(json, place.at);
    json.end();
  }
  json.end();
}

}  // namespace

std::string text_of(const Verdict& verdict, const WatchList& watch, const std::string& plan) {
  const std::size_t faults = verdict.findings.size();
  std::string text = printable(plan) + ": " +
                     (faults == 0   ? "verified, no fault found"
                      : faults == 1 ? "1 fault found"
                                    : std::to_string(faults) + " faults found") +
                     "\n";
  for (const Finding& finding : verdict.findings) text += finding_text(finding);
  if (verdict.area_m2 > 0)
    text += "  covered " + fixed(100 * verdict.covered_m2 / verdict.area_m2, 2) + " % of " +
            fixed(verdict.area_m2 / 1e4, 2) + " ha, worked twice " +
            fixed(100 * verdict.twice_m2 / verdict.area_m2, 2) + " %\n";
  text += places_text("  not covered (lon, lat):\n", verdict.missed);
  text += watch_text(
      "Before the first drive, look at these places. Nearest to border or obstacle (body or tool):\n",
      watch.closest);
  text += watch_text("Tightest curves (radius of the axle's path):\n", watch.tightest);
  return text;
}

std::string json_of(const Verdict& verdict, const std::vector<VerifiedPlace>& twice, const WatchList& watch) {
  JsonWriter json;
  json.begin_object(JsonSpread::lines).key("verdict").text(verdict.findings.empty() ? "passed" : "failed");
  add_findings(json, verdict);
  json.key("area_m2").number(verdict.area_m2, 2).key("covered_m2").number(verdict.covered_m2, 2);
  json.key("worked_twice_m2").number(verdict.twice_m2, 2);
  add_places(json, "missed", verdict.missed);
  add_places(json, "twice", twice);
  add_watch(json, "closest", watch.closest);
  add_watch(json, "tightest", watch.tightest);
  return json.end().str() + "\n";
}

}  // namespace selion::cli
