// SPDX-License-Identifier: GPL-3.0-or-later
#include "work.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "cut_ring.hpp"

namespace selion {
namespace {

constexpr int kGiveUpChain = 3;  // pieces of a chain not reached in a row

void move_to_end(std::vector<Task>& tasks, std::vector<Task>& from) {
  tasks.insert(tasks.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  from.clear();
}

bool either_way_round(const Layout& layout) {
  return std::all_of(
      layout.headland_passes.begin(), layout.headland_passes.end(),
      [](const HeadlandPass& pass) { return (!pass.closed || pass.either_way) && pass.parts.empty(); });
}

double worked_m(const std::vector<RoutePiece>& pieces) {
  double sum = 0;
  for (const RoutePiece& piece : pieces)
    if (!piece.ref.empty()) sum += length_m(piece.path);
  return sum;
}

}  // namespace

/// Where one ring can only be driven as laid, so are the others: from ring to ring the machine then changes
/// lanes instead of turning about.
Work::Work(Driver& driver, const Layout& layout)
    : driver_{driver}, layout_{layout}, either_way_round_{either_way_round(layout)} {}

Work::Entry Work::nearest_entry(const std::vector<Chain>& chains) const {
  Entry best;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < chains.size(); ++i)
    for (const Entry entry : {Entry{i, false, Sense::forth}, Entry{i, false, Sense::back},
                              Entry{i, true, Sense::forth}, Entry{i, true, Sense::back}}) {
      const Swath& swath = entry.at_last ? *chains[i].back() : *chains[i].front();
      const double far = far_m(driver_.here(), start_pose(swath_way(driver_.machine(), swath, entry.sense)));
      if (far >= least_m - 1e-6) continue;
      least_m = far;
      best = entry;
    }
  return best;
}

void Work::swaths(const Progress& progress) {
  std::vector<Chain> chains = chains_of(layout_.swaths, layout_.along);
  const std::size_t all = chains.size();
  while (!chains.empty()) {
    progress("driving", 1 - static_cast<double>(chains.size()) / static_cast<double>(all));
    const Entry entry = nearest_entry(chains);
    Chain chain = std::move(chains[entry.chain]);
    chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(entry.chain));
    if (entry.at_last) std::reverse(chain.begin(), chain.end());
    if (!work_chain(chain.begin(), chain.end(), entry.sense) && !work_one_of(chains)) break;
  }
  for (const Chain& chain : chains)
    for (const Swath* swath : chain) put_off_.push_back(task_of(*swath));
}

/// False where none of it is reached.
bool Work::work_chain(Chain::const_iterator next, Chain::const_iterator end, Sense sense) {
  int failed = 0;
  bool any = false;
  for (; next != end; ++next) {
    const Swath& swath = **next;
    const Terrain& terrain = driver_.terrain();
    const Machine& machine = driver_.machine();
    if (failed >= kGiveUpChain ||  // the rest is no nearer: later, from elsewhere
        (!driver_.turn_to(swath_task(terrain, machine, swath, {sense})) &&
         !driver_.drive_to(swath_task(terrain, machine, swath, {sense, opposite(sense)})))) {
      ++failed;
      put_off_.push_back(swath_task(terrain, machine, swath, {sense, opposite(sense)}));
      continue;
    }
    failed = 0;
    any = true;
    sense = sense_beside(swath);
  }
  return any;
}

/// The neighbour is driven back.
Sense Work::sense_beside(const Swath& swath) const {
  const Point end = driver_.here()->at;
  return distance_m(end, swath.from) < distance_m(end, swath.to) ? Sense::forth : Sense::back;
}

Task Work::task_of(const Swath& swath) const {
  return swath_task(driver_.terrain(), driver_.machine(), swath, {Sense::forth, Sense::back});
}

/// Works the chain of which an end is reached most cheaply: one search for all, since most are as far out of
/// reach as the nearest was. False where it reaches none.
bool Work::work_one_of(std::vector<Chain>& chains) {
  std::vector<std::pair<std::size_t, bool>> ends;  // which chain, and is it its last swath?
  for (std::size_t i = 0; i < chains.size(); ++i) {
    ends.emplace_back(i, false);
    if (chains[i].size() > 1) ends.emplace_back(i, true);
  }
  const auto swath_at = [&](const auto& end) {
    return end.second ? chains[end.first].back() : chains[end.first].front();
  };
  const auto far = [&](const auto& end) {
    const Point here = driver_.here()->at;
    return std::min(distance_m(here, swath_at(end)->from), distance_m(here, swath_at(end)->to));
  };
  if (driver_.here())
    std::stable_sort(ends.begin(), ends.end(), [&](const auto& a, const auto& b) { return far(a) < far(b); });
  std::vector<Task> tasks(ends.size());
  std::transform(ends.begin(), ends.end(), tasks.begin(),
                 [&](const auto& end) { return task_of(*swath_at(end)); });
  const auto reached = driver_.drive_to_one_of(tasks);
  if (!reached) return false;
  const auto [which, at_last] = ends[*reached];
  Chain chain = std::move(chains[which]);
  chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(which));
  if (at_last) std::reverse(chain.begin(), chain.end());
  work_chain(chain.begin() + 1, chain.end(), sense_beside(*chain.front()));
  return true;
}

double Work::nearness_m(const Task& task) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Way& way : task.ways) least = std::min(least, far_m(driver_.here(), way.start));
  return least;
}

/// Nearest first. Where the nearest cannot be reached from here, whatever can; where nothing can, long ones
/// are split.
void Work::work_nearest(std::vector<Task> tasks) {
  while (!tasks.empty()) {
    const auto next = std::min_element(tasks.begin(), tasks.end(), [this](const Task& a, const Task& b) {
      return nearness_m(a) < nearness_m(b);
    });
    sort_nearest_first(next->ways, driver_.here());
    if (driver_.drive_to(*next))
      tasks.erase(next);
    else if (!work_one_of(tasks) && !split_all(tasks))
      break;
  }
  move_to_end(put_off_, tasks);  // cut off from here
}

/// The task that is reached most cheaply; false where none is.
bool Work::work_one_of(std::vector<Task>& tasks) {
  for (Task& task : tasks) sort_nearest_first(task.ways, driver_.here());
  std::stable_sort(tasks.begin(), tasks.end(),
                   [this](const Task& a, const Task& b) { return nearness_m(a) < nearness_m(b); });
  const auto reached = driver_.drive_to_one_of(tasks);
  if (reached) tasks.erase(tasks.begin() + static_cast<std::ptrdiff_t>(*reached));
  return reached.has_value();
}

/// False where none may be.
bool Work::split_all(std::vector<Task>& tasks) const {
  std::vector<Task> parts;
  std::erase_if(tasks, [&](const Task& task) { return split(task, parts); });
  const bool any = !parts.empty();
  move_to_end(tasks, parts);
  return any;
}

/// A long open pass that cannot be reached at its ends may be begun in its middle: two tasks of its id
/// instead of one.
bool Work::split(const Task& task, std::vector<Task>& into) const {
  const auto middle_m = split_place_m(task, driver_.machine().working_width_m);
  if (!middle_m) return false;
  const Path& whole = task.lines.front();
  for (const auto& [from_m, to_m] : {std::pair{0.0, *middle_m}, std::pair{*middle_m, length_m(whole)}})
    into.push_back(
        open_pass_task(driver_.terrain(), driver_.machine(), task.id, part_of(whole, from_m, to_m)));
  return true;
}

void Work::pockets() {
  std::vector<Task> tasks;
  for (const Swath& pocket : layout_.pockets) tasks.push_back(task_of(pocket));
  move_to_end(tasks, put_off_);
  work_nearest(std::move(tasks));
}

void Work::put_off() { work_nearest(std::exchange(put_off_, {})); }

/// Ends where the swaths begin: at the nearest end of a chain.
void Work::headland_inwards() {
  std::vector<Point> entries;
  for (const Chain& chain : chains_of(layout_.swaths, layout_.along))
    for (const Swath* swath : {chain.front(), chain.back()}) {
      entries.push_back(swath->from);
      entries.push_back(swath->to);
    }
  work_rings({layout_, driver_.machine().working_width_m, RingSense::inwards}, entries, std::nullopt);
}

void Work::headland_outwards(const std::optional<Point>& gate) {
  work_rings({layout_, driver_.machine().working_width_m, RingSense::outwards},
             gate ? std::vector{*gate} : std::vector<Point>{}, gate);
}

/// Each ends where the next one is near: beside it, in the next group, or what comes after all.
void Work::work_rings(RingOrder order, const std::vector<Point>& at_last,
                      const std::optional<Point>& last_near) {
  std::vector<Task> failed;
  while (!order.empty()) {
    const auto here = driver_.here() ? std::optional{driver_.here()->at} : std::nullopt;
    ends_near_ = order.is_last_group() ? last_near : std::nullopt;
    const std::size_t next = order.nearest(here, last_near);
    order.done(next);
    if (order.empty())
      then_to_ = at_last;
    else
      then_to_ = order.ends_group(next) ? order.next_places() : std::vector<Point>{};
    const HeadlandPass& pass = order.pass(next);
    if (!work_pass(pass)) failed.push_back(pass_task(pass));
  }
  work_nearest(std::move(failed));
}

/// The machine has to come to the gate anyway: it does before the passes there are worked, not over them.
bool Work::work_pass(const HeadlandPass& pass) {
  if (work_round(pass)) return true;
  if (std::exchange(ends_near_, std::nullopt) && work_round(pass)) return true;
  return drive_on_to(pass_task(pass));
}

/// Where a ring with filled corners cannot be driven so, it is rounded.
bool Work::work_round(const HeadlandPass& pass) {
  return work_parts(pass) || driver_.drive_to(pass_task(pass)) || work_turned(pass);
}

/// Of a way round, which ends where it begins, those that begin near the gate.
void Work::keep_near_gate(Task& task) const {
  constexpr double kRadii = 6;  // for a change of lanes
  constexpr double kWidths = 2;
  if (!ends_near_) return;
  const auto off_m = [this](const Way& way) { return distance_m(way.start.at, *ends_near_); };
  double least_m = std::numeric_limits<double>::infinity();
  for (const Way& way : task.ways) least_m = std::min(least_m, off_m(way));
  const double most_m = least_m + kRadii / driver_.terrain().limits.curvature_per_m +
                        kWidths * driver_.machine().working_width_m;
  std::erase_if(task.ways, [&](const Way& way) { return off_m(way) > most_m; });
}

/// Begun on a side, part by part round to where it was begun.
bool Work::work_parts(const HeadlandPass& pass) {
  if (pass.parts.empty()) return false;
  Task task = cut_ring_task(driver_.terrain(), pass, driver_.here(), then_to_);
  keep_near_gate(task);
  if (!driver_.drive_to(task)) return false;
  const auto begun = place_on(pass, start_pose(driver_.driven().back().path));
  if (!begun) return true;
  const std::size_t count = pass.parts.size();
  for (std::size_t k = 1; k <= count; ++k) {
    const HeadlandPart& last = pass.parts[(begun->part + k - 1) % count];
    const HeadlandPart& next = pass.parts[(begun->part + k) % count];
    const Path& path = k < count ? next.path : part_of(next.path, 0, begun->s_m);
    driver_.drive_along(last.way_on, part_task(pass, path));
  }
  return true;
}

/// A machine that only drives forwards may be stuck where it is: then what it worked last was a dead end, and
/// is given up for something longer.
bool Work::drive_on_to(const Task& task) {
  constexpr int kMostTakenBack = 3;
  if (driver_.terrain().may_reverse || !driver_.here()) return false;
  double longest_m = 0;
  for (const Path& line : task.lines) longest_m = std::max(longest_m, length_m(line));
  std::vector<RoutePiece> taken;
  for (int i = 0; i < kMostTakenBack; ++i) {
    std::vector<RoutePiece> last = driver_.take_back();
    if (last.empty()) break;
    taken.insert(taken.begin(), std::make_move_iterator(last.begin()), std::make_move_iterator(last.end()));
    if (worked_m(taken) > longest_m || !driver_.drive_to(task)) continue;
    for (const RoutePiece& piece : taken)
      if (!piece.ref.empty()) dead_ends_.push_back(piece.ref);
    return true;
  }
  if (!taken.empty()) driver_.drive_again(std::move(taken));
  return false;
}

Task Work::pass_task(const HeadlandPass& pass) const {
  const Terrain& terrain = driver_.terrain();
  if (!pass.closed) return open_pass_task(terrain, driver_.machine(), pass.id, pass.path);
  Task task = closed_pass_task(terrain, pass, driver_.here(), Round::as_laid, then_to_);
  if (either_way_round_)
    add_ways(task, closed_pass_task(terrain, pass, driver_.here(), Round::turned, then_to_), driver_.here());
  keep_near_gate(task);
  return task;
}

/// The other way round, where that has not been tried with the first.
bool Work::work_turned(const HeadlandPass& pass) {
  if (!pass.closed || either_way_round_) return false;
  Task task = closed_pass_task(driver_.terrain(), pass, driver_.here(), Round::turned, then_to_);
  keep_near_gate(task);
  return driver_.drive_to(task);
}

std::vector<std::string> Work::left() const {
  std::vector<std::string> ids;
  for (const Task& task : put_off_) ids.push_back(task.id);
  ids.insert(ids.end(), dead_ends_.begin(), dead_ends_.end());
  return ids;
}

}  // namespace selion
