// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/plan/job_keys.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "selion/plan/text.hpp"

namespace selion {
namespace {

constexpr auto kOperations = std::to_array<std::pair<Operation, std::string_view>>({
    {Operation::tillage, "tillage"},
    {Operation::seeding, "seeding"},
    {Operation::weeding, "weeding"},
    {Operation::spraying, "spraying"},
    {Operation::mowing, "mowing"},
    {Operation::harvest, "harvest"},
    {Operation::scouting, "scouting"},
});
constexpr auto kOrders = std::to_array<std::pair<HeadlandOrder, std::string_view>>(
    {{HeadlandOrder::first, "first"}, {HeadlandOrder::last, "last"}, {HeadlandOrder::none, "none"}});
constexpr auto kCorners = std::to_array<std::pair<HeadlandCorners, std::string_view>>(
    {{HeadlandCorners::round, "round"}, {HeadlandCorners::fill, "fill"}});
constexpr auto kKinds = std::to_array<std::pair<MachineKind, std::string_view>>(
    {{MachineKind::car, "car"}, {MachineKind::differential, "differential"}});

template <class Names, class Enum>
std::string_view name_in(const Names& names, Enum wanted) {
  for (const auto& [value, name] : names)
    if (value == wanted) return name;
  throw std::logic_error{"a job holds a choice that has no name"};
}

template <class Enum, class Names>
Enum named(const Names& names, const JobValue& value) {
  for (const auto& [choice, name] : names)
    if (name == std::get<std::string>(value)) return choice;
  throw std::logic_error{"a choice was not checked before it was set"};
}

JobValue to_value(double x) { return x; }
JobValue to_value(int x) { return static_cast<double>(x); }
JobValue to_value(bool x) { return x; }
JobValue to_value(Operation x) { return std::string{name_in(kOperations, x)}; }
JobValue to_value(HeadlandOrder x) { return std::string{name_in(kOrders, x)}; }
JobValue to_value(HeadlandCorners x) { return std::string{name_in(kCorners, x)}; }
JobValue to_value(MachineKind x) { return std::string{name_in(kKinds, x)}; }
JobValue to_value(const std::array<double, 4>& x) { return std::vector<double>(x.begin(), x.end()); }
template <class T>
JobValue to_value(const std::optional<T>& x) {
  return x ? to_value(*x) : JobValue{Absent{}};
}
JobValue to_value(const std::string& x) { return x; }

void assign(double& to, const JobValue& value) { to = std::get<double>(value); }
void assign(int& to, const JobValue& value) { to = static_cast<int>(std::get<double>(value)); }
void assign(bool& to, const JobValue& value) { to = std::get<bool>(value); }
void assign(Operation& to, const JobValue& value) { to = named<Operation>(kOperations, value); }
void assign(HeadlandOrder& to, const JobValue& value) { to = named<HeadlandOrder>(kOrders, value); }
void assign(HeadlandCorners& to, const JobValue& value) { to = named<HeadlandCorners>(kCorners, value); }
void assign(MachineKind& to, const JobValue& value) { to = named<MachineKind>(kKinds, value); }
void assign(std::array<double, 4>& to, const JobValue& value) {
  std::ranges::copy(std::get<std::vector<double>>(value), to.begin());
}
void assign(std::string& to, const JobValue& value) {
  const double* number = std::get_if<double>(&value);
  to = number != nullptr ? number_text(*number) : std::get<std::string>(value);
}
template <class T>
void assign(std::optional<T>& to, const JobValue& value) {
  to.reset();
  if (!std::holds_alternative<Absent>(value)) assign(to.emplace(), value);
}

/// The words of a key; what it is and where it lies in Job comes from the template below.
struct Words {
  std::string_view table, name, flag, unit, help;
  std::string_view choices{}, later{}, absent{}, alias{};
};

template <JobType Type, auto... Path>
JobKey key(const Words& words) {
  return {words.table,
          words.name,
          words.flag,
          words.alias,
          Type,
          words.unit,
          words.choices,
          words.later,
          words.absent,
          words.help,
          [](const Job& job) { return to_value((job.*....*Path)); },
          [](Job& job, const JobValue& value) { assign((job.*....*Path), value); }};
}

template <auto Member>
JobKey machine(std::string_view name, std::string_view flag, std::string_view unit, std::string_view help,
               std::string_view absent = {}) {
  return key<JobType::number, &Job::machine, Member>(
      {.table = "machine", .name = name, .flag = flag, .unit = unit, .help = help, .absent = absent});
}

/// The presets as a list with bars: the table refers to it for as long as the program runs.
const std::string& preset_names() {
  static const std::string names = [] {
    std::string out;
    for (const MachinePreset& preset : machine_presets())
      out += (out.empty() ? "" : "|") + std::string{preset.name};
    return out;
  }();
  return names;
}

using M = Machine;

std::vector<JobKey> machine_keys() {
  return {
      key<JobType::text, &Job::machine, &M::preset>({"machine", "preset", "--machine", "",
                                                     "the machine to start from; the keys below change it",
                                                     preset_names()}),
      key<JobType::text, &Job::machine, &M::kind>({"machine", "kind", "--machine-kind", "",
                                                   "steered like a car, or by the speeds of its sides",
                                                   "car|differential"}),
      machine<&M::working_width_m>("working_width_m", "--working-width", "m", "width that one pass works"),
      machine<&M::tool_x_m>("tool_x_m", "--tool-x", "m",
                            "the tool's place ahead of the rear axle; behind it negative"),
      machine<&M::body_width_m>("body_width_m", "--body-width", "m", "width of the body, tool raised"),
      machine<&M::front_m>("front_m", "--front", "m", "reach of the body ahead of the rear axle"),
      machine<&M::rear_m>("rear_m", "--rear", "m", "reach of the body and tool behind the rear axle"),
      machine<&M::wheelbase_m>("wheelbase_m", "--wheelbase", "m", "front axle to rear axle"),
      machine<&M::track_m>("track_m", "--track", "m", "left wheels to right wheels, centre to centre"),
      machine<&M::max_steer_deg>("max_steer_deg", "--max-steer", "deg", "largest steering angle"),
      machine<&M::max_steer_rate_deg_s>("max_steer_rate_deg_s", "--max-steer-rate", "deg/s",
                                        "how fast the steering turns"),
      machine<&M::min_turn_radius_m>("min_turn_radius_m", "--min-turn-radius", "m",
                                     "tightest turn, instead of the steering angle; auto: from the angle",
                                     "auto"),
      machine<&M::max_speed_mps>("max_speed_mps", "--max-speed", "m/s", "fastest speed anywhere"),
      machine<&M::work_speed_mps>("work_speed_mps", "--work-speed", "m/s",
                                  "fastest speed with the tool down"),
      machine<&M::turn_speed_mps>("turn_speed_mps", "--turn-speed", "m/s",
                                  "fastest speed where a turn is curved"),
      machine<&M::max_accel_mps2>("max_accel_mps2", "--max-accel", "m/s2", "how hard it speeds up"),
      machine<&M::max_brake_mps2>("max_brake_mps2", "--max-brake", "m/s2", "how hard it slows down"),
      machine<&M::max_lateral_mps2>("max_lateral_mps2", "--max-lateral", "m/s2",
                                    "largest sideways acceleration in a curve"),
      machine<&M::mass_kg>("mass_kg", "--mass", "kg", "mass of machine and tool"),
      key<JobType::truth, &Job::machine, &M::may_reverse>(
          {"machine", "may_reverse", "--may-reverse", "", "may it drive in reverse (tool up)"}),
      machine<&M::safety_radius_m>("safety_radius_m", "--safety-radius", "m",
                                   "circle around it that other machines keep out of"),
      machine<&M::safety_gap_m>("safety_gap_m", "--safety-gap", "m", "least distance between two bodies"),
      machine<&M::tyre_width_m>("tyre_width_m", "--tyre-width", "m", "width of one tyre"),
      machine<&M::clearance_m>("clearance_m", "--clearance", "m", "height of crop that passes below"),
      machine<&M::min_work_radius_m>("min_work_radius_m", "--min-work-radius", "m",
                                     "tightest curve with the tool down; auto: as without it", "auto"),
      machine<&M::run_in_m>("run_in_m", "--run-in", "m",
                            "straight way before the work on which the tool is lowered"),
      machine<&M::tool_raise_s>("tool_raise_s", "--tool-raise", "s", "time to raise the tool"),
      machine<&M::tool_lower_s>("tool_lower_s", "--tool-lower", "s", "time to lower the tool"),
      key<JobType::truth, &Job::machine, &M::may_pivot>(
          {"machine", "may_pivot", "--may-pivot", "", "may it turn on the spot (differential machines)"}),
      machine<&M::guidance_sd_m>("guidance_sd_m", "--guidance-sd", "m", "standard deviation of its guidance"),
  };
}

std::vector<JobKey> ground_keys() {
  using F = Job::FieldKeys;
  using L = Job::LayoutKeys;
  return {
      key<JobType::number, &Job::field, &F::edge_margin_m>(
          {"field", "edge_margin_m", "--edge-margin", "m", "between the border and the outermost lane"}),
      key<JobType::number, &Job::field, &F::obstacle_clearance_m>(
          {"field", "obstacle_clearance_m", "--obstacle-clearance", "m", "kept from holes and obstacles"}),
      key<JobType::number, &Job::field, &F::water_margin_m>(
          {"field", "water_margin_m", "--water-margin", "m", "kept from water"}),
      key<JobType::number, &Job::field, &F::overhang_m>(
          {"field", "overhang_m", "--overhang", "m",
           "how far a raised tool may pass over the border; only 0 yet"}),
      key<JobType::number, &Job::field, &F::boundary_accuracy_m>(
          {.table = "field",
           .name = "boundary_accuracy_m",
           .flag = "--boundary-accuracy",
           .unit = "m",
           .help = "how well the boundary was surveyed",
           .absent = "unknown"}),
      key<JobType::text, &Job::frame, &Job::FrameKeys::crs>(
          {"frame", "crs", "--frame-crs", "",
           "plane of the plan: auto is centred on the field, or a projected EPSG code"}),
      key<JobType::text, &Job::layout, &L::kind>(
          {"layout", "kind", "--layout", "", "how swaths lie", "linear", "spiral"}),
      key<JobType::heading, &Job::layout, &L::direction>(
          {"layout", "direction", "--direction", "deg",
           "of the swaths: best edge, the rule of Cariou 2020, or a compass heading", "edge|p3", "cost"}),
      key<JobType::line, &Job::layout, &L::ab>(
          {.table = "layout",
           .name = "ab",
           .flag = "--ab",
           .unit = "deg",
           .help = "an existing AB line: longitude, latitude of A, then of B; wins over direction",
           .absent = "none"}),
      key<JobType::number, &Job::layout, &L::ab_shift_m>(
          {"layout", "ab_shift_m", "--ab-shift", "m",
           "swaths shifted from the AB line; right of A to B positive"}),
      key<JobType::number, &Job::layout, &L::overlap_m>(
          {"layout", "overlap_m", "--overlap", "m", "overlap of neighbouring swaths"}),
      key<JobType::number, &Job::layout, &L::row_spacing_m>(
          {"layout", "row_spacing_m", "--row-spacing", "m", "distance of the crop's rows"}),
      key<JobType::count, &Job::layout, &L::tramlines>(
          {"layout", "tramlines", "--tramlines", "", "tramlines; only 0 yet"}),
  };
}

std::vector<JobKey> work_keys() {
  using H = Job::HeadlandKeys;
  using R = Job::RouteKeys;
  using O = Job::OutputKeys;
  return {
      key<JobType::count, &Job::headland, &H::passes>(
          {"headland", "passes", "--passes", "", "rounds along the border; auto: as many as the turns need",
           "", "", "auto", "--headland-passes"}),
      key<JobType::text, &Job::headland, &H::order>(
          {"headland", "order", "--headland-order", "",
           "when the headland is worked; by default as the operation wants it", "first|last|none"}),
      key<JobType::text, &Job::headland, &H::corners>(
          {"headland", "corners", "--corners", "",
           "of headland passes: rounded, or filled by backing into them or a loop", "round|fill"}),
      key<JobType::text, &Job::route, &R::order>({"route", "order", "--route-order", "",
                                                  "order of the swaths", "adjacent",
                                                  "skip|lands|spiral|optimised"}),
      key<JobType::text, &Job::route, &R::start>(
          {"route", "start", "--start", "", "gate to start and end at, gate:1; empty: the planner chooses"}),
      key<JobType::text, &Job::output, &O::units>(
          {"output", "units", "--units", "", "of map, report and summary", "metric|imperial"}),
      key<JobType::text, &Job::output, &O::paper>(
          {"output", "paper", "--paper", "", "of the printed map", "A4|A3|letter"}),
  };
}

std::vector<JobKey> all_keys() {
  std::vector<JobKey> keys{key<JobType::text, &Job::operation>(
      {"", "operation", "--operation", "", "what is done; sets when the headland is worked",
       "tillage|seeding|weeding|spraying|mowing|harvest|scouting"})};
  std::ranges::move(machine_keys(), std::back_inserter(keys));
  std::ranges::move(ground_keys(), std::back_inserter(keys));
  std::ranges::move(work_keys(), std::back_inserter(keys));
  return keys;
}

}  // namespace

std::string_view name_of(Operation operation) { return name_in(kOperations, operation); }
std::string_view name_of(HeadlandOrder order) { return name_in(kOrders, order); }

std::span<const JobKey> job_keys() {
  static const std::vector<JobKey> keys = all_keys();
  return keys;
}

std::string full_name(const JobKey& key) {
  return key.table.empty() ? std::string{key.name} : std::string{key.table} + "." + std::string{key.name};
}

const JobKey& job_key(std::string_view full) {
  for (const JobKey& key : job_keys())
    if (full_name(key) == full) return key;
  throw std::logic_error{"no job key " + std::string{full}};
}

}  // namespace selion
