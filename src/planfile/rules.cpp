// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "selion/core/format.hpp"

namespace selion {
namespace {

std::string listed(std::span<const std::string_view> words) {
  std::string out;
  for (const auto word : words) {
    if (!out.empty()) out += ", ";
    out += word;
  }
  return out;
}

Problem not_one_of(const std::string& key, const std::string& value,
                   std::span<const std::string_view> words) {
  if (std::ranges::find(words, value) != words.end()) return std::nullopt;
  return key + " \"" + value + "\" is not one of " + listed(words);
}

Problem problem_of_ring(const LonLatLine& ring) {
  if (ring.size() < 3) return "a ring has " + std::to_string(ring.size()) + " corners, it needs 3";
  for (const LonLat corner : ring) {
    if (auto problem = problem_of(corner)) return problem;
  }
  return std::nullopt;
}

Problem missing(const PieceRecord& piece, const std::string& key) {
  return "a " + piece.kind + " needs " + key;
}

}  // namespace

Problem problem_of(LonLat position) {
  const bool longitude_fits = std::abs(position.lon_deg) <= 180;  // a NaN does not
  const bool latitude_fits = std::abs(position.lat_deg) <= 90;
  if (longitude_fits && latitude_fits) return std::nullopt;
  if (!std::isfinite(position.lon_deg) || !std::isfinite(position.lat_deg)) return "a position is not finite";
  return "position [" + fixed(position.lon_deg, 9) + ", " + fixed(position.lat_deg, 9) +
         "] is not on Earth: it must be [longitude, latitude] in degrees, at most 180 and 90";
}

Problem problem_of_line(const LonLatLine& line) {
  if (line.size() < 2) return "a line has " + std::to_string(line.size()) + " positions, it needs 2";
  for (const LonLat position : line) {
    if (auto problem = problem_of(position)) return problem;
  }
  return std::nullopt;
}

Problem problem_of(const LonLatArea& area) {
  if (auto problem = problem_of_ring(area.shell)) return problem;
  for (const LonLatLine& hole : area.holes) {
    if (auto problem = problem_of_ring(hole)) return problem;
  }
  return std::nullopt;
}

Problem problem_of(const std::vector<LonLatArea>& parts) {
  if (parts.empty()) return "there is no polygon";
  for (const LonLatArea& part : parts) {
    if (auto problem = problem_of(part)) return problem;
  }
  return std::nullopt;
}

Problem problem_of_frame(const std::string& proj) {
  constexpr std::size_t kLongest = 1000;
  constexpr auto kOfFiles =
      std::to_array<std::string_view>({"grids=", "file=", "model=", "init=", "pipeline"});
  if (proj.size() > kLongest) return "proj is longer than " + std::to_string(kLongest) + " characters";
  if (std::ranges::any_of(proj, [](unsigned char c) { return c < ' ' || c > '~' || c == '/' || c == '\\'; }))
    return "proj has characters that no projection has";
  for (const std::string_view word : kOfFiles)
    if (const auto at = proj.find(word);
        at != std::string::npos &&
        proj.compare(at, std::string_view{"grids=@null"}.size(), "grids=@null") != 0)
      return "proj names a file or a chain of steps; a frame is one projection";
  return std::nullopt;
}

Problem problem_of(const std::vector<SummaryFigure>& summary) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  std::set<std::string_view> seen;
  for (const SummaryFigure& figure : summary) {
    const bool plain = !figure.key.empty() && figure.key.find_first_not_of(kLetters) == std::string::npos;
    if (!plain) return "key \"" + figure.key + "\" must be of letters, digits and underscores";
    if (!seen.insert(figure.key).second) return "key \"" + figure.key + "\" stands twice";
  }
  return std::nullopt;
}

Problem problem_of(const ObstacleRecord& obstacle) {
  return not_one_of("what", obstacle.what, kObstacleKinds);
}

Problem problem_of(const PieceRecord& piece) {
  if (auto problem = not_one_of("kind", piece.kind, kPieceKinds)) return problem;
  if (piece.gear != 1 && piece.gear != -1)
    return "gear is " + std::to_string(piece.gear) + ", it must be 1 or -1";
  if (piece.tool != 0 && piece.tool != 1)
    return "tool is " + std::to_string(piece.tool) + ", it must be 0 or 1";
  if (piece.length_m < 0)
    return "the curve's length is " + fixed(piece.length_m, 9) + ", it must not be negative";
  if (piece.kind == "pivot" && !piece.angle_rad) return missing(piece, "angle_rad");
  if ((piece.kind == "pivot" || piece.kind == "wait") && !piece.duration_s)
    return missing(piece, "duration_s");
  if (piece.for_robot.has_value() != piece.until_station_m.has_value()) {
    return "for_robot and until_station_m stand together or not at all";
  }
  return std::nullopt;
}

Problem problem_of(const TrajectoryRecord& trajectory) {
  if (auto problem = problem_of_line(trajectory.line)) return problem;
  const std::size_t samples = trajectory.line.size();
  const auto wrong = [&](const char* key, std::size_t size) -> Problem {
    if (size == samples) return std::nullopt;
    return std::string{key} + " has " + std::to_string(size) + " entries, there are " +
           std::to_string(samples) + " coordinates";
  };
  if (auto problem = wrong("t_s", trajectory.t_s.size())) return problem;
  if (auto problem = wrong("heading_rad", trajectory.heading_rad.size())) return problem;
  if (auto problem = wrong("curvature_per_m", trajectory.curvature_per_m.size())) return problem;
  if (auto problem = wrong("speed_mps", trajectory.speed_mps.size())) return problem;
  if (auto problem = wrong("tool", trajectory.tool.size())) return problem;
  const auto odd = std::ranges::find_if(trajectory.tool, [](int tool) { return tool != 0 && tool != 1; });
  if (odd != trajectory.tool.end()) return "tool holds " + std::to_string(*odd) + ", it must be 0 or 1";
  if (trajectory.pieces.empty()) return "pieces is empty";
  return std::nullopt;
}

}  // namespace selion
