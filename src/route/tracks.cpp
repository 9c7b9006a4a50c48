// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "connect.hpp"

namespace selion {
namespace {

constexpr double kStationStep_m = 1.5;
constexpr std::size_t kMostJoins = 40;     // stations tried on a track, nearest first
constexpr std::size_t kMostWays = 6;       // joins of a track whose combinations are looked at

Curve part_of(const Curve& curve, double from_m, double to_m) {
  const CurveState at = state_at(curve, from_m);
  return {at.at, at.heading_rad, at.curvature_per_m, curve.sharpness_per_m2, to_m - from_m};
}

/// A turn from a pose onto a track, or from a track to a pose.
struct Join {
  double s_m = 0;
  Path path;
  double length_m = 0;
};

enum class Which { onto, off };

std::vector<Join> joins(const Terrain& terrain, const Track& track, const Pose& pose, Which which) {
  const double reach_m = 6 / terrain.limits.curvature_per_m + 4 * terrain.footprint.half_tool_m;
  std::vector<const Track::Station*> near;
  for (const Track::Station& station : track.stations)
    if (distance_m(station.pose.at, pose.at) < reach_m) near.push_back(&station);
  const auto closer = [&pose](const Track::Station* a, const Track::Station* b) {
    return distance_m(a->pose.at, pose.at) < distance_m(b->pose.at, pose.at);
  };
  std::stable_sort(near.begin(), near.end(), closer);
  if (near.size() > kMostJoins) near.resize(kMostJoins);
  std::vector<Join> found;
  for (const Track::Station* station : near) {
    auto turn = which == Which::onto ? direct_turn(terrain, pose, station->pose) : direct_turn(terrain, station->pose, pose);
    if (!turn) continue;
    const double length = length_m(*turn);
    if (length > 4 * reach_m) continue;
    found.push_back({station->s_m, std::move(*turn), length});
  }
  std::stable_sort(found.begin(), found.end(), [](const Join& a, const Join& b) { return a.length_m < b.length_m; });
  if (found.size() > kMostWays) found.resize(kMostWays);
  return found;
}

double ahead_m(const Track& track, double from_m, double to_m) {
  return to_m >= from_m ? to_m - from_m : to_m - from_m + track.length_m;
}

}  // namespace

Path part_of(const Path& closed, double from_m, double to_m) {
  constexpr double kNothing_m = 1e-9;
  Path part;
  const double whole = length_m(closed);
  double left = to_m >= from_m ? to_m - from_m : to_m - from_m + whole;
  double skip = from_m;
  for (std::size_t i = 0; left > kNothing_m && i < 2 * closed.size() + 1; ++i) {
    const Stretch& stretch = closed[i % closed.size()];
    const double length = stretch.curve.length_m;
    if (skip >= length) {
      skip -= length;
      continue;
    }
    const double to = std::min(length, skip + left);
    if (to - skip > kNothing_m) part.push_back({part_of(stretch.curve, skip, to), stretch.gear});
    left -= to - skip;
    skip = 0;
  }
  return part;
}

Path turned_round(const Path& closed) {
  Path out;
  for (auto it = closed.rbegin(); it != closed.rend(); ++it) out.push_back({reversed(it->curve), it->gear});
  return out;
}

Track track_of(const Path& closed) {
  Track track{closed, length_m(closed), {}};
  double before = 0;
  for (const Stretch& stretch : closed) {
    const double length = stretch.curve.length_m;
    if (stretch.curve.curvature_per_m == 0 && stretch.curve.sharpness_per_m2 == 0) {
      const int steps = std::max(1, static_cast<int>(std::ceil(length / kStationStep_m)));
      for (int i = 0; i < steps; ++i) {
        const double s = length * (i + 0.5) / steps;
        track.stations.push_back({before + s, vehicle_pose(stretch, s)});
      }
    }
    before += length;
  }
  return track;
}

std::optional<Path> along_tracks(const Terrain& terrain, const Pose& from, const Pose& to) {
  std::optional<Path> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Track& track : terrain.tracks) {
    const std::vector<Join> ons = joins(terrain, track, from, Which::onto);
    if (ons.empty()) continue;
    const std::vector<Join> offs = joins(terrain, track, to, Which::off);
    for (const Join& on : ons)
      for (const Join& off : offs) {
        const double length = on.length_m + ahead_m(track, on.s_m, off.s_m) + off.length_m;
        if (length >= least) continue;
        least = length;
        best = on.path;
        append(*best, part_of(track.path, on.s_m, off.s_m));
        append(*best, off.path);
      }
  }
  return best;
}

}  // namespace selion
