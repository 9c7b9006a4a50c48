// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/batch/journal.hpp"

#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "selion/core/error.hpp"
#include "selion/core/json_writer.hpp"

namespace selion {
namespace {

using Json = nlohmann::json;

constexpr int kFormat = 1;
constexpr int kDecimals = 4;        // metres, square metres, seconds
constexpr int kDegreeDecimals = 9;  // as in a plan file

std::string line_of(JsonWriter& json) { return json.end().str() + "\n"; }

void write_ring(JsonWriter& json, const LonLatRing& ring) {
  json.begin_array(JsonSpread::line);
  for (const LonLat p : ring) json.number(p.lon_deg, kDegreeDecimals).number(p.lat_deg, kDegreeDecimals);
  json.end();
}

void write_boundary(JsonWriter& json, const std::vector<LonLatPolygon>& boundary) {
  json.key("boundary").begin_array(JsonSpread::line);
  for (const LonLatPolygon& part : boundary) {
    json.begin_array(JsonSpread::line);
    write_ring(json, part.shell);
    for (const LonLatRing& hole : part.holes) write_ring(json, hole);
    json.end();
  }
  json.end();
}

void write_figures(JsonWriter& json, const BatchFigures& figures) {
  json.key("figures").begin_object(JsonSpread::line);
  json.key("covered_m2").number(figures.covered_m2, kDecimals);
  json.key("worked_twice_m2").number(figures.worked_twice_m2, kDecimals);
  json.key("swaths").whole(figures.swaths).key("passes").whole(figures.passes);
  json.key("length_m").number(figures.length_m, kDecimals);
  json.key("duration_s").number(figures.duration_s, kDecimals).end();
}

BatchStatus status_of(const std::string& name) {
  const auto found = std::ranges::find(kBatchStatusNames, name);
  if (found == kBatchStatusNames.end()) throw InputError{"'" + name + "' is no status"};
  return static_cast<BatchStatus>(found - kBatchStatusNames.begin());
}

LonLatRing ring_of(const Json& numbers) {
  LonLatRing ring;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
    ring.push_back({numbers.at(i).get<double>(), numbers.at(i + 1).get<double>()});
  return ring;
}

std::vector<LonLatPolygon> boundary_of(const Json& parts) {
  std::vector<LonLatPolygon> boundary;
  for (const Json& rings : parts) {
    LonLatPolygon part;
    part.shell = ring_of(rings.at(0));
    for (std::size_t i = 1; i < rings.size(); ++i) part.holes.push_back(ring_of(rings.at(i)));
    boundary.push_back(std::move(part));
  }
  return boundary;
}

BatchFigures figures_of(const Json& json) {
  BatchFigures figures;
  json.at("covered_m2").get_to(figures.covered_m2);
  json.at("worked_twice_m2").get_to(figures.worked_twice_m2);
  json.at("swaths").get_to(figures.swaths);
  json.at("passes").get_to(figures.passes);
  json.at("length_m").get_to(figures.length_m);
  json.at("duration_s").get_to(figures.duration_s);
  return figures;
}

BatchResult result_of(const Json& json) {
  BatchResult result;
  json.at("number").get_to(result.number);
  json.at("file").get_to(result.file);
  json.at("layer").get_to(result.layer);
  if (json.contains("feature")) result.feature = json.at("feature").get<int>();
  json.at("name").get_to(result.name);
  result.status = status_of(json.at("status").get<std::string>());
  json.at("reason").get_to(result.reason);
  if (json.contains("area_m2")) result.area_m2 = json.at("area_m2").get<double>();
  if (json.contains("figures")) result.figures = figures_of(json.at("figures"));
  json.at("verified").get_to(result.verified);
  json.at("plan").get_to(result.plan);
  json.at("plan_bytes").get_to(result.plan_bytes);
  result.boundary = boundary_of(json.at("boundary"));
  return result;
}

/// @throws Json::exception, InputError where the line is none of a journal.
void take_line(const std::string& line, std::uint64_t offset, JournalIndex& into,
               const std::function<void(const BatchResult&)>& each) {
  const Json json = Json::parse(line);
  if (!into.identity) {
    if (json.at("selion_batch").get<int>() != kFormat) throw InputError{"the journal's format is not known"};
    into.shard = {json.at("shard").at(0).get<int>(), json.at("shard").at(1).get<int>()};
    into.identity = BatchIdentity{json.at("version").get<std::string>(), json.at("input").get<std::string>(),
                                  json.at("job").get<std::string>(), json.at("options").get<std::string>()};
  } else if (json.contains("numbers")) {
    into.numbers = json.at("numbers").get<std::size_t>();
  } else {
    const BatchResult result = result_of(json);
    into.lines.push_back({result.number, offset, static_cast<std::uint32_t>(line.size())});
    each(result);
  }
}

}  // namespace

std::string journal_header(const BatchIdentity& identity, const Shard& shard) {
  JsonWriter json;
  json.begin_object(JsonSpread::line).key("selion_batch").whole(kFormat);
  json.key("version").text(identity.version).key("input").text(identity.input);
  json.key("job").text(identity.job).key("options").text(identity.options);
  json.key("shard").begin_array(JsonSpread::line).whole(shard.index).whole(shard.count).end();
  return line_of(json);
}

std::string journal_line(const BatchResult& result) {
  JsonWriter json;
  json.begin_object(JsonSpread::line).key("number").whole(static_cast<long long>(result.number));
  json.key("file").text(result.file).key("layer").text(result.layer);
  if (result.feature) json.key("feature").whole(*result.feature);
  json.key("name").text(result.name);
  json.key("status").text(kBatchStatusNames.at(static_cast<std::size_t>(result.status)));
  json.key("reason").text(result.reason);
  if (result.area_m2) json.key("area_m2").number(*result.area_m2, kDecimals);
  if (result.figures) write_figures(json, *result.figures);
  json.key("verified").text(result.verified).key("plan").text(result.plan);
  json.key("plan_bytes").whole(static_cast<long long>(result.plan_bytes));
  write_boundary(json, result.boundary);
  return line_of(json);
}

std::string journal_end(std::size_t numbers) {
  JsonWriter json;
  json.begin_object(JsonSpread::line).key("numbers").whole(static_cast<long long>(numbers));
  return line_of(json);
}

JournalIndex read_journal(const std::filesystem::path& file,
                          const std::function<void(const BatchResult&)>& each) {
  JournalIndex index;
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return index;
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw InputError{file.string() + " cannot be read; check the permissions"};
  std::string line;
  while (!index.numbers && std::getline(stream, line) && !stream.eof()) {
    try {
      take_line(line, index.good_bytes, index, each);
    } catch (const Json::exception&) {
      break;
    } catch (const InputError&) {
      break;
    }
    index.good_bytes += line.size() + 1;
  }
  return index;
}

BatchResult result_of_line(std::string_view line) {
  try {
    return result_of(Json::parse(line));
  } catch (const Json::exception& broken) {
    throw InputError{std::string{"a line of the journal is broken: "} + broken.what()};
  }
}

std::string difference(const BatchIdentity& begun, const BatchIdentity& now) {
  if (begun.version != now.version)
    return "was begun by selion " + begun.version + ", and this is " + now.version;
  if (begun.input != now.input) return "was begun with other fields, or their file was changed since";
  if (begun.job != now.job) return "was begun with another job";
  if (begun.options != now.options)
    return "was begun with other options (how the fields are read, what is written)";
  return "";
}

}  // namespace selion
