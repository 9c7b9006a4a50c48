// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/route/route.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <numbers>

#include "chains.hpp"
#include "connect.hpp"
#include "roads.hpp"
#include "selion/core/format.hpp"

namespace selion {
namespace {

constexpr double kGateRoom_m = 0.05;     // between the body and the border at the gate
constexpr double kSwathEnd_m = 4;        // of a swath: where it is joined as a road
constexpr std::size_t kRingStarts = 24;  // places tried to begin a headland pass
constexpr std::size_t kRoadWays = 4;     // ways into a piece of work that the roads are asked for
constexpr std::size_t kSearchedWays = 2;
constexpr int kGiveUpChain = 3;    // pieces of a chain not reached in a row
constexpr int kGiveUpTasks = 24;   // pieces of any kind not reached in a row
constexpr double kLeastSplit = 8;  // working widths of length from which an open headland pass may be split
constexpr double kFarthestRetreat_m = 150;
constexpr double kRetreatStep_m = 6;
constexpr std::size_t kMostRetreats = 14;
constexpr double kStraight_per_m = 1e-9;
constexpr double kFarRound = 3;  // a way this many turns long is worth a search for a shorter one

/// A piece of work and the ways it may be driven, the preferred one first.
struct Task {
  PieceKind kind = PieceKind::swath;
  std::string id;
  std::vector<Path> ways;
  bool closed = false;  ///< a headland pass all around
};

class Driver {
 public:
  Driver(const Block& block, const Layout& layout, const Machine& machine)
      : layout_{layout},
        machine_{machine},
        space_{free_space(block.free, footprint_of(machine))},
        terrain_{space_, footprint_of(machine), limits_at(machine, machine.turn_speed_mps),
                 machine.may_reverse, layout.mainland},
        roads_{terrain_, tracks()} {}

  Result<Route> drive(const Block& block, const RouteOptions& options, const Progress& progress);

 private:
  [[nodiscard]] std::vector<Track> tracks() const;
  [[nodiscard]] Track swath_track(Path way) const;
  [[nodiscard]] std::optional<Pose> at_gate(const Block& block, std::size_t gate, bool inwards) const;
  [[nodiscard]] Path swath_way(const Swath& swath, bool forth) const;
  [[nodiscard]] Task swath_task(const Swath& swath) const;
  [[nodiscard]] std::vector<Path> ring_ways(const HeadlandPass& pass) const;
  bool drive_to(const Task& task);
  bool drive_one(const Task& task, const std::optional<Path>& way, const Path& work);
  void work_chains(std::vector<Chain> chains, const Progress& progress);
  void work_chain(const Chain& chain, bool from_last, bool forth);
  void work_nearest(std::vector<Task> tasks);
  bool split(const Task& task, std::vector<Task>& into);
  [[nodiscard]] Task open_task(const std::string& id, const Path& path) const;
  [[nodiscard]] Path tool_turned_round(const Path& path) const;
  void work_headland(bool inside_out);
  [[nodiscard]] double far_m(const Pose& pose) const;
  [[nodiscard]] PieceKind way_kind(const Path& way) const;
  [[nodiscard]] Pose before(const Path& work) const;
  /// Beyond this a way is a transfer.
  [[nodiscard]] double longest_turn_m() const {
    return 14 / terrain_.limits.curvature_per_m + 6 * terrain_.footprint.half_tool_m;
  }
  struct Approach {
    const Path* work;
    Path way;
    double cost_m;
  };
  [[nodiscard]] std::vector<Path> retreats() const;
  void consider(std::optional<Approach>& best, const Path& work, std::optional<Path> way) const;

  const Layout& layout_;
  const Machine& machine_;
  FreeSpace space_;
  Terrain terrain_;
  Roads roads_;
  std::optional<Pose> here_;
  std::vector<Task> put_off_;
  std::map<std::string, int> parts_of_;  // how many parts an open pass was split into
  Route route_;
};

/// Swaths serve as roads to and from obstacles inside: they are joined at their ends and beside those only.
Track Driver::swath_track(Path way) const {
  const double near_m = layout_.headland_depth_m + 6 / terrain_.limits.curvature_per_m;
  Track track = track_of(std::move(way), false);
  const auto beside_hole = [&](const Track::Station& station) {
    const auto& holes = space_.area().holes;
    return std::any_of(holes.begin(), holes.end(), [&](const Ring& hole) {
      const Box box = bounds(hole);
      const Point p = station.pose.at;
      return p.x_m > box.low.x_m - near_m && p.x_m < box.high.x_m + near_m && p.y_m > box.low.y_m - near_m &&
             p.y_m < box.high.y_m + near_m;
    });
  };
  const double length = track.length_m;
  std::erase_if(track.stations, [&](const Track::Station& station) {
    return station.s_m > kSwathEnd_m && station.s_m < length - kSwathEnd_m && !beside_hole(station);
  });
  return track;
}

/// Every line of the layout, in each direction in which the machine fits on it.
std::vector<Track> Driver::tracks() const {
  std::vector<Track> tracks;
  const auto add = [&](const Path& path, bool closed) {
    for (const Path& way : {path, turned_round(path)})
      if (fits(space_, terrain_.footprint, way)) tracks.push_back(track_of(way, closed));
  };
  for (const HeadlandPass& pass : layout_.headland_passes) add(pass.path, pass.closed);
  for (const Swath& pocket : layout_.pockets) {
    Path way = turned_round(swath_way(pocket, true));
    append(way, run_on(terrain_, end_pose(way)));
    way = turned_round(way);
    append(way, run_on(terrain_, end_pose(way)));
    add(way, false);
  }
  for (const Swath& swath : layout_.swaths)
    for (const bool forth : {true, false})
      if (Path way = swath_way(swath, forth); fits(space_, terrain_.footprint, way))
        tracks.push_back(swath_track(std::move(way)));
  return tracks;
}

Path Driver::swath_way(const Swath& swath, bool forth) const {
  return forth ? swath_path(machine_, swath.from, swath.to) : swath_path(machine_, swath.to, swath.from);
}

Task Driver::swath_task(const Swath& swath) const {
  Task task{PieceKind::swath, swath.id, {}};
  for (const bool forth : {true, false})
    if (Path way = swath_way(swath, forth); fits(space_, terrain_.footprint, way))
      task.ways.push_back(std::move(way));
  return task;
}

double Driver::far_m(const Pose& pose) const { return here_ ? distance_m(here_->at, pose.at) : 0; }

PieceKind Driver::way_kind(const Path& way) const {
  return length_m(way) <= longest_turn_m() ? PieceKind::turn : PieceKind::transfer;
}

bool Driver::drive_one(const Task& task, const std::optional<Path>& way, const Path& work) {
  if (here_ && !way) return false;
  if (way && !way->empty()) route_.pieces.push_back({way_kind(*way), "", *way});
  route_.pieces.push_back({task.kind, task.id, work});
  here_ = end_pose(work);
  return true;
}

/// The pose `run_in_m` before the work begins: from there the tool is brought down on a straight line.
Pose Driver::before(const Path& work) const {
  const Pose start = start_pose(work);
  return {start.at - machine_.run_in_m * unit(start.heading_rad), start.heading_rad};
}

/// The cheapest of the task's ways: by one turn each; where that is a long one, by the roads; where these
/// lead far round or nowhere, by searching.
bool Driver::drive_to(const Task& task) {
  if (task.ways.empty()) return false;
  if (!here_) return drive_one(task, std::nullopt, task.ways.front());
  std::optional<Approach> best;
  const auto each = [&](std::size_t most, const auto& way_to) {
    for (std::size_t i = 0; i < task.ways.size() && i < most; ++i)
      consider(best, task.ways[i], way_to(before(task.ways[i])));
  };
  each(task.ways.size(), [this](const Pose& goal) { return direct_turn(terrain_, *here_, goal); });
  if (!best || best->cost_m > longest_turn_m()) {
    const std::vector<Path> back = retreats();
    each(kRoadWays, [&](const Pose& goal) { return roads_.way(*here_, goal, back); });
  }
  const bool close = far_m(before(task.ways.front())) < longest_turn_m();
  if (!best || (close && best->cost_m > kFarRound * longest_turn_m()))
    each(kSearchedWays, [this](const Pose& goal) { return searched(terrain_, *here_, goal); });
  if (!best) return false;
  if (machine_.run_in_m > 0)
    best->way.push_back({line(before(*best->work).at, start_pose(*best->work).at), Gear::forward});
  return drive_one(task, best->way, *best->work);
}

/// Ways backwards over what was just driven, longer and longer: out of a dead end the way it came is always
/// free.
std::vector<Path> Driver::retreats() const {
  std::vector<Path> found;
  if (!machine_.may_reverse) return found;
  Path run;
  double length = 0;
  for (auto piece = route_.pieces.rbegin(); piece != route_.pieces.rend(); ++piece)
    for (auto stretch = piece->path.rbegin(); stretch != piece->path.rend(); ++stretch) {
      if (length > kFarthestRetreat_m || found.size() >= kMostRetreats) return found;
      const double whole = stretch->curve.length_m;
      const bool straight = stretch->curve.curvature_per_m == 0 && stretch->curve.sharpness_per_m2 == 0;
      const int steps = straight ? std::max(1, static_cast<int>(std::ceil(whole / kRetreatStep_m))) : 1;
      const Curve back = reversed(stretch->curve);
      const Gear gear = stretch->gear == Gear::forward ? Gear::reverse : Gear::forward;
      for (int k = 1; k <= steps && found.size() < kMostRetreats; ++k) {
        Path part = run;
        part.push_back({back, gear});
        part.back().curve.length_m = whole * k / steps;
        if (straight || std::abs(stretch->curve.curvature_per_m) < kStraight_per_m)
          found.push_back(std::move(part));
      }
      run.push_back({back, gear});
      length += whole;
    }
  return found;
}

void Driver::consider(std::optional<Approach>& best, const Path& work, std::optional<Path> way) const {
  if (!way) return;
  const double cost = cost_m(terrain_, *way);
  if (!best || cost < best->cost_m - 1e-6) best = Approach{&work, std::move(*way), cost};
}

void Driver::work_chain(const Chain& chain, bool from_last, bool forth) {
  Chain order = chain;
  if (from_last) std::reverse(order.begin(), order.end());
  int failed = 0;
  for (const Swath* swath : order) {
    Task task{PieceKind::swath, swath->id, {swath_way(*swath, forth), swath_way(*swath, !forth)}};
    std::erase_if(task.ways, [this](const Path& way) { return !fits(space_, terrain_.footprint, way); });
    if (failed >= kGiveUpChain || !drive_to(task)) {  // the rest is no nearer: later, from elsewhere
      ++failed;
      put_off_.push_back(std::move(task));
      continue;
    }
    failed = 0;
    const Point end = here_->at;
    forth = distance_m(end, swath->from) < distance_m(end, swath->to);  // the neighbour is driven back
  }
}

void Driver::work_chains(std::vector<Chain> chains, const Progress& progress) {
  const std::size_t all = chains.size();
  while (!chains.empty()) {
    progress("driving", 1 - static_cast<double>(chains.size()) / static_cast<double>(all));
    std::size_t best = 0;
    bool from_last = false;
    bool forth = true;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < chains.size(); ++i)
      for (const bool last : {false, true})
        for (const bool way : {true, false}) {
          const double far = far_m(start_pose(swath_way(last ? *chains[i].back() : *chains[i].front(), way)));
          if (far < least - 1e-6) least = far, best = i, from_last = last, forth = way;
        }
    work_chain(chains[best], from_last, forth);
    chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(best));
  }
}

/// Nearest first; what cannot be reached from here is tried again from elsewhere, at last given up.
void Driver::work_nearest(std::vector<Task> tasks) {
  const auto nearness = [this](const Task& task) {
    double least = std::numeric_limits<double>::infinity();
    for (const Path& way : task.ways) least = std::min(least, far_m(start_pose(way)));
    return least;
  };
  std::vector<Task> failed;
  int in_a_row = 0;
  while (!tasks.empty()) {
    const auto next = std::min_element(
        tasks.begin(), tasks.end(), [&](const Task& a, const Task& b) { return nearness(a) < nearness(b); });
    Task task = std::move(*next);
    tasks.erase(next);
    std::stable_sort(task.ways.begin(), task.ways.end(), [this](const Path& a, const Path& b) {
      return far_m(start_pose(a)) < far_m(start_pose(b));
    });
    if (drive_to(task)) {
      tasks.insert(tasks.end(), std::make_move_iterator(failed.begin()),
                   std::make_move_iterator(failed.end()));
      failed.clear();
      in_a_row = 0;
    } else if (!split(task, tasks)) {
      failed.push_back(std::move(task));
      if (++in_a_row >= kGiveUpTasks) break;  // cut off from here
    }
  }
  put_off_.insert(put_off_.end(), std::make_move_iterator(failed.begin()),
                  std::make_move_iterator(failed.end()));
  put_off_.insert(put_off_.end(), std::make_move_iterator(tasks.begin()),
                  std::make_move_iterator(tasks.end()));
}

/// A long open pass that cannot be reached at its ends may be begun in its middle: two passes instead of one.
bool Driver::split(const Task& task, std::vector<Task>& into) {
  if (task.kind != PieceKind::headland_pass || task.closed || task.ways.empty()) return false;
  const Path& whole = task.ways.front();
  const double length = length_m(whole);
  if (length < kLeastSplit * machine_.working_width_m) return false;
  const Track track = track_of(whole, false);
  const Track::Station* middle = nullptr;
  for (const Track::Station& station : track.stations)
    if (middle == nullptr || std::abs(station.s_m - length / 2) < std::abs(middle->s_m - length / 2))
      middle = &station;
  if (middle == nullptr || middle->s_m < length / 4 || middle->s_m > 3 * length / 4) return false;
  const std::string pass = task.id.substr(0, task.id.find('.'));
  into.push_back(open_task(pass + "." + std::to_string(++parts_of_[pass]), part_of(whole, 0, middle->s_m)));
  into.push_back(
      open_task(pass + "." + std::to_string(++parts_of_[pass]), part_of(whole, middle->s_m, length)));
  return true;
}

/// A part of the way round: either way along it.
Task Driver::open_task(const std::string& id, const Path& path) const {
  Task task{PieceKind::headland_pass, id, {}};
  for (const Path& way : {path, tool_turned_round(path)})
    if (fits(space_, terrain_.footprint, way)) task.ways.push_back(way);
  return task;
}

/// The same ground worked the other way: the axle's path is moved on by the tool's place at either end.
Path Driver::tool_turned_round(const Path& path) const {
  Path back = turned_round(path);
  const double shift = -2 * machine_.tool_x_m;  // from leading the tool at one end to leading it at the other
  const Pose end = end_pose(back);
  if (shift > 0) append(back, {{line(end.at, end.at + shift * unit(end.heading_rad)), Gear::forward}});
  if (shift <= 0 || length_m(back) < 2 * shift) return back;
  double from = 0;  // a swath may only be begun where the wheels stand straight
  for (const Stretch& stretch : back) {
    const bool line_here = stretch.curve.curvature_per_m == 0 && stretch.curve.sharpness_per_m2 == 0;
    const double end = from + stretch.curve.length_m;
    if (line_here && end > shift) return part_of(back, std::max(from, shift), length_m(back));
    from = end;
  }
  return back;
}

/// A closed pass begun at stations all around, both ways round where the machine fits.
std::vector<Path> Driver::ring_ways(const HeadlandPass& pass) const {
  std::vector<Path> ways;
  std::vector<Path> rounds{pass.path};
  if (Path back = turned_round(pass.path); fits(space_, terrain_.footprint, back))
    rounds.push_back(std::move(back));
  for (const Path& round : rounds) {
    Track track = track_of(round, true);
    if (here_)
      std::stable_sort(
          track.stations.begin(), track.stations.end(),
          [this](const Track::Station& a, const Track::Station& b) { return far_m(a.pose) < far_m(b.pose); });
    for (std::size_t k = 0; k < track.stations.size() && k < kRingStarts; ++k) {
      const double s = track.stations[k].s_m;
      ways.push_back(part_of(round, s, s + track.length_m));
    }
  }
  std::stable_sort(ways.begin(), ways.end(), [this](const Path& a, const Path& b) {
    return far_m(start_pose(a)) < far_m(start_pose(b));
  });
  return ways;
}

void Driver::work_headland(bool inside_out) {
  std::vector<const HeadlandPass*> order;
  for (const HeadlandPass& pass : layout_.headland_passes) order.push_back(&pass);
  const auto ring = [inside_out](const HeadlandPass* p) { return inside_out ? -p->ring : p->ring; };
  std::stable_sort(order.begin(), order.end(),
                   [&](const HeadlandPass* a, const HeadlandPass* b) { return ring(a) < ring(b); });
  for (std::size_t i = 0; i < order.size();) {  // rings of one depth: nearest first
    std::size_t last = i;
    while (last < order.size() && order[last]->ring == order[i]->ring) ++last;
    std::vector<const HeadlandPass*> same(order.begin() + static_cast<std::ptrdiff_t>(i),
                                          order.begin() + static_cast<std::ptrdiff_t>(last));
    std::vector<Task> failed;
    while (!same.empty()) {
      const auto nearest =
          std::min_element(same.begin(), same.end(), [this](const HeadlandPass* a, const HeadlandPass* b) {
            return far_m(start_pose(a->path)) < far_m(start_pose(b->path));
          });
      const HeadlandPass& pass = **nearest;
      Task task = pass.closed ? Task{PieceKind::headland_pass, pass.id, ring_ways(pass), true}
                              : open_task(pass.id, pass.path);
      if (!drive_to(task)) failed.push_back(std::move(task));
      same.erase(nearest);
    }
    work_nearest(std::move(failed));
    i = last;
  }
}

std::optional<Pose> Driver::at_gate(const Block& block, std::size_t gate, bool inwards) const {
  const BlockGate& g = block.gates[gate];
  const double room = (inwards ? std::max(machine_.rear_m, -machine_.tool_x_m)
                               : std::max(machine_.front_m, machine_.tool_x_m)) +
                      kGateRoom_m;
  const Pose pose{g.at + room * unit(g.inward_rad), inwards ? g.inward_rad : g.inward_rad + std::numbers::pi};
  if (!fits(space_, terrain_.footprint, pose)) return std::nullopt;
  return pose;
}

Result<Route> Driver::drive(const Block& block, const RouteOptions& options, const Progress& progress) {
  std::optional<Pose> out;
  if (options.gate) {
    const BlockGate& gate = block.gates[*options.gate];
    if (gate.width_m && *gate.width_m < machine_.body_width_m)
      return Infeasible{"gate " + gate.name + " is " + fixed(*gate.width_m, 2) +
                        " m wide, the machine's body " + fixed(machine_.body_width_m, 2) + " m"};
    here_ = at_gate(block, *options.gate, true);
    out = at_gate(block, *options.gate, false);
    if (!here_)
      route_.notes.push_back("the machine does not fit inside gate " + gate.name +
                             " square to the border; the drive starts elsewhere");
  }
  if (options.headland == HeadlandOrder::first) work_headland(false);
  work_chains(chains_of(layout_.swaths, layout_.along), progress);
  std::vector<Task> rest;
  for (const Swath& pocket : layout_.pockets) rest.push_back(swath_task(pocket));
  rest.insert(rest.end(), std::make_move_iterator(put_off_.begin()), std::make_move_iterator(put_off_.end()));
  put_off_.clear();
  work_nearest(std::move(rest));
  if (options.headland == HeadlandOrder::last) work_headland(true);
  std::vector<Task> again;
  again.swap(put_off_);
  work_nearest(std::move(again));
  for (const Task& task : put_off_) route_.left_out.push_back(task.id);
  const bool any = std::any_of(route_.pieces.begin(), route_.pieces.end(),
                               [](const RoutePiece& p) { return p.kind == PieceKind::swath; });
  if (!any)
    return Infeasible{"the machine reaches no swath of this block: there is no room to turn into one"};
  if (out) {
    auto way = connect(terrain_, roads_, *here_, *out);
    if (!way) way = roads_.way(*here_, *out, retreats());
    if (way)
      route_.pieces.push_back({PieceKind::transfer, "", *way});
    else
      route_.notes.push_back("no way back to gate " + block.gates[*options.gate].name +
                             " was found; the drive ends elsewhere");
  }
  return std::move(route_);
}

}  // namespace

Result<Route> route(const Block& block, const Layout& layout, const Machine& machine,
                    const RouteOptions& options, const Progress& progress) {
  return Driver{block, layout, machine}.drive(block, options, progress);
}

}  // namespace selion
