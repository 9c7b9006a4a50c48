// SPDX-License-Identifier: GPL-3.0-or-later
#include "work.hpp"

#include <exception>
#include <string>
#include <utility>

#include "folder.hpp"
#include "selion/batch/verified.hpp"
#include "selion/core/error.hpp"
#include "selion/core/progress.hpp"
#include "selion/field/frame.hpp"
#include "selion/geometry/polygon.hpp"
#include "selion/output/map.hpp"
#include "selion/output/report.hpp"
#include "selion/plan/plan.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion {
namespace {

namespace fs = std::filesystem;

double area_m2_of(const LonLatRing& ring, const LocalFrame& frame) {
  Ring local;
  local.reserve(ring.size());
  for (const LonLat p : ring) local.push_back(frame.to_local(p));
  return std::abs(signed_area_m2(local));
}

/// Of a field that has no plan: as the file has it.
double area_m2_of(const Field& field) {
  const LocalFrame frame = LocalFrame::centred(centre(field));
  double sum_m2 = 0;
  for (const LonLatPolygon& part : field.parts) {
    sum_m2 += area_m2_of(part.shell, frame);
    for (const LonLatRing& hole : part.holes) sum_m2 -= area_m2_of(hole, frame);
  }
  return sum_m2;
}

void add_figures(const Plan& plan, BatchResult& into) {
  BatchFigures sum;
  double area_m2 = 0;
  for (const BlockReport& block : plan.blocks) {
    area_m2 += block.area_m2;
    if (!block.refused.empty()) {
      into.reason +=
          (into.reason.empty() ? "block " : "; block ") + std::to_string(block.number) + ": " + block.refused;
      continue;
    }
    sum.covered_m2 += block.covered_m2;
    sum.worked_twice_m2 += block.twice.total_m2();
    sum.swaths += block.swaths;
    sum.passes += block.headland_passes;
    sum.length_m += block.work_m + block.turn_m + block.transfer_m;
    sum.duration_s += block.work_s + block.turn_s + block.transfer_s;
  }
  into.area_m2 = area_m2;
  into.figures = sum;
  into.status = sum.covered_m2 < kPlannedShare * area_m2 ? BatchStatus::partial : BatchStatus::done;
}

/// Writes files of one field, each under its own name once it is whole.
class FieldFiles {
 public:
  FieldFiles(const BatchOptions& options, const fs::path& part_folder, const BatchResult& row)
      : options_{options}, part_folder_{part_folder}, place_{place_of(row.number, row.name)} {}

  /// In the batch's folder.
  [[nodiscard]] std::string name(const std::string& tree, const std::string& ending) const {
    return tree + "/" + place_ + ending;
  }
  void write(const std::string& tree, const std::string& ending, std::string_view bytes) const {
    write_beside(part_folder_ / fs::path{place_ + ending}.filename(), options_.folder / name(tree, ending),
                 bytes);
  }

 private:
  const BatchOptions& options_;
  const fs::path& part_folder_;
  std::string place_;
};

struct FieldBytes {
  std::string plan, svg, pdf;
};

void write_files(const FieldBytes& bytes, const FieldFiles& files, BatchResult& row) {
  if (!bytes.svg.empty()) files.write("maps", ".svg", bytes.svg);
  if (!bytes.pdf.empty()) files.write("maps", ".pdf", bytes.pdf);
  files.write("plans", ".geojson", bytes.plan);
  row.plan = files.name("plans", ".geojson");
  row.plan_bytes = bytes.plan.size();
}

/// Absent where the field is not planned: the row says why then.
std::optional<FieldBytes> planned(const Field& field, const BatchOptions& options, BatchResult& row) {
  Result<Plan> plan = selion::plan(field, options.job, options.repair, no_progress);
  if (!plan) {
    row.status = BatchStatus::infeasible;
    row.reason = plan.error().reason;
    row.area_m2 = area_m2_of(field);
    return std::nullopt;
  }
  add_figures(*plan, row);
  FieldBytes bytes{to_geojson(plan->file), "", ""};
  if (options.check == BatchCheck::verify) {
    plan->verification = verification_of(plan_from_geojson(bytes.plan, "the plan written"));
    row.verified =
        plan->verification->faults.empty() ? "passed" : "failed: " + plan->verification->faults.front();
  }
  if (options.maps == BatchMaps::drawn) {
    MapText text = map_text(*plan, options.job);
    text.date = options.date;
    MapFiles maps = map_files(plan->file, text, map_options(options.job));
    bytes.svg = std::move(maps.svg);
    bytes.pdf = std::move(maps.pdf);
  }
  return bytes;
}

}  // namespace

BatchResult worked(BatchTask task, const BatchOptions& options, const fs::path& part_folder) {
  BatchResult row = std::move(task.row);
  if (!task.field) return row;
  std::optional<FieldBytes> bytes;
  try {
    bytes = planned(*task.field, options, row);
  } catch (const InputError& error) {
    row.status = BatchStatus::error;
    row.reason = error.what();
  } catch (const std::exception& error) {
    row.status = BatchStatus::error;
    row.reason = std::string{"selion failed, and should not have: "} + error.what();
  }
  row.boundary = std::move(task.field->parts);
  if (bytes) write_files(*bytes, FieldFiles{options, part_folder, row}, row);
  return row;
}

}  // namespace selion
