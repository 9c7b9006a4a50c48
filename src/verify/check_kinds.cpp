// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "check.hpp"

namespace selion::verifying {
namespace {

/// What the lines of a plan are, by block and id.
using Kinds = std::map<std::pair<int, std::string>, std::string>;

/// "12", "12a".
bool is_numbered(std::string_view id) {
  const std::size_t letters = std::min(id.find_first_not_of("0123456789"), id.size());
  return letters > 0 && id.find_first_not_of("abcdefghijklmnopqrstuvwxyz", letters) == std::string_view::npos;
}

/// Pockets too.
bool names_swath(std::string_view id) {
  return is_numbered(id.starts_with('L') || id.starts_with('P') ? id.substr(1) : id);
}

bool names_pass(std::string_view id) { return id.starts_with('H') && is_numbered(id.substr(1)); }

/// What a line is decides what it must keep: its id says it as its record does (docs/plan.md).
template <class Record>
void add_kinds(Case& plan, Kinds& kinds, const std::vector<Record>& records, const std::string& kind,
               bool (*fits)(std::string_view id)) {
  for (const Record& record : records) {
    kinds[{record.block, record.id}] = kind;
    if (!fits(record.id))
      plan.findings.add("line_kind", record.block, plan.plane.to_local(record.line.front()), {},
                        "a " + kind + " is called " + record.id + ", as none is");
  }
}

void check_driven(Case& plan, const Driven& driven, const Kinds& kinds) {
  for (std::size_t i = 0; i < driven.pieces.size(); ++i) {
    const PieceRecord& piece = driven.pieces[i].record();
    if (piece.tool == 0 && !piece.ref.empty())
      plan.findings.add("line_kind", driven.record->block, driven.pieces[i].spot(0).at, {},
                        piece_name(driven, i) + " works nothing, and is said to be of line " + piece.ref);
    const auto line = kinds.find({driven.record->block, piece.ref});
    if (piece.tool != 1 || line == kinds.end() || line->second == piece.kind) continue;
    plan.findings.add("line_kind", driven.record->block, driven.pieces[i].spot(0).at, {},
                      piece_name(driven, i) + " works a line that is a " + line->second);
  }
}

/// A block's robots are numbered from 1.
void check_numbers(Case& plan) {
  std::map<int, std::set<int>> robots;
  for (const Driven& driven : plan.drives) robots[driven.record->block].insert(driven.record->robot);
  for (const auto& [block, numbers] : robots)
    if (const int count = static_cast<int>(numbers.size());
        *numbers.begin() != 1 || *numbers.rbegin() != count)
      plan.findings.add("robot", block, std::nullopt, {1.0 * *numbers.rbegin(), 1.0 * count},
                        "the block's robots, " + std::to_string(count) + ", go from number " +
                            std::to_string(*numbers.begin()) + " to " + std::to_string(*numbers.rbegin()));
}

}  // namespace

void check_kinds(Case& plan) {
  Kinds kinds;
  add_kinds(plan, kinds, plan.plan.swaths, "swath", names_swath);
  add_kinds(plan, kinds, plan.plan.headland_passes, "headland_pass", names_pass);
  for (const Driven& driven : plan.drives) check_driven(plan, driven, kinds);
  check_numbers(plan);
}

}  // namespace selion::verifying
