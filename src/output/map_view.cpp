// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_view.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <proj.h>

#include "selion/core/error.hpp"
#include "selion/core/units.hpp"

namespace selion {

struct PlanPlane::Handle {
  PJ_CONTEXT* context = proj_context_create();
  PJ* projection = nullptr;
  bool in_radians = false;

  Handle() = default;
  ~Handle() {
    proj_destroy(projection);
    proj_context_destroy(context);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle(Handle&&) = delete;
  Handle& operator=(Handle&&) = delete;
};

namespace {

/// A projection of WGS84 itself is a formula: PROJ need not open its database of reference systems.
bool is_of_wgs84(const std::string& proj) {
  return proj.find("+datum=WGS84") != std::string::npos && proj.find("+towgs84") == std::string::npos &&
         proj.find("+nadgrids") == std::string::npos && proj.find("+axis") == std::string::npos &&
         proj.find("+type=crs") == std::string::npos;
}

PJ* between_systems(PJ_CONTEXT* context, const std::string& proj) {
  PJ* found =
      proj_create_crs_to_crs(context, "+proj=longlat +datum=WGS84 +no_defs +type=crs", proj.c_str(), nullptr);
  if (found == nullptr) return nullptr;
  PJ* normalized = proj_normalize_for_visualization(context, found);
  proj_destroy(found);
  return normalized;
}

}  // namespace

PlanPlane::PlanPlane(const std::string& proj) : handle_{std::make_unique<Handle>()} {
  proj_log_level(handle_->context, PJ_LOG_NONE);
  proj_context_set_enable_network(handle_->context, 0);  // a map must not hang on a download
  handle_->in_radians = is_of_wgs84(proj);
  handle_->projection = handle_->in_radians ? proj_create(handle_->context, proj.c_str())
                                            : between_systems(handle_->context, proj);
  if (handle_->projection == nullptr)
    throw InputError{"plan file: PROJ cannot use the frame \"" + proj + "\"; plan the field again"};
}

PlanPlane::~PlanPlane() = default;

Point PlanPlane::to_local(LonLat p) const {
  const double unit = handle_->in_radians ? radians_of_degrees(1) : 1;
  const PJ_COORD out =
      proj_trans(handle_->projection, PJ_FWD, proj_coord(unit * p.lon_deg, unit * p.lat_deg, 0, HUGE_VAL));
  if (!std::isfinite(out.xy.x) || !std::isfinite(out.xy.y))
    throw InputError{
        "plan file: a coordinate cannot be projected into the plan's frame; plan the field again"};
  return {out.xy.x, out.xy.y};
}

LonLat PlanPlane::to_lonlat(Point p) const {
  const PJ_COORD out = proj_trans(handle_->projection, PJ_INV, proj_coord(p.x_m, p.y_m, 0, HUGE_VAL));
  const double unit = handle_->in_radians ? radians_of_degrees(1) : 1;
  return {out.lp.lam / unit, out.lp.phi / unit};
}

double PlanPlane::convergence_deg(Point p) const {
  const LonLat here = to_lonlat(p);
  const double step_deg = here.lat_deg > 89 ? -1e-4 : 1e-4;
  const Point north =
      (step_deg > 0 ? 1.0 : -1.0) * (to_local({here.lon_deg, here.lat_deg + step_deg}) - to_local(here));
  return -degrees_of_radians(std::atan2(north.x_m, north.y_m));
}

PagePoint MapView::at(Point p) const {
  const PagePoint middle = frame.centre();
  return {middle.x_mm + mm_per_m * (p.x_m - centre.x_m), middle.y_mm - mm_per_m * (p.y_m - centre.y_m)};
}

PageLine MapView::at(const LonLatLine& line) const {
  PageLine out;
  for (const LonLat p : line) out.push_back(at(p));
  return out;
}

std::vector<PageLine> MapView::at(const LonLatArea& area) const {
  std::vector<PageLine> rings{at(area.shell)};
  for (const LonLatLine& hole : area.holes) rings.push_back(at(hole));
  return rings;
}

Point MapView::local(PagePoint p) const {
  const PagePoint middle = frame.centre();
  return {centre.x_m + (p.x_mm - middle.x_mm) / mm_per_m, centre.y_m - (p.y_mm - middle.y_mm) / mm_per_m};
}

double distance_mm(PagePoint a, PagePoint b) { return std::hypot(b.x_mm - a.x_mm, b.y_mm - a.y_mm); }

double length_mm(const PageLine& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance_mm(line[i - 1], line[i]);
  return sum;
}

PlaceOnLine place_on(const PageLine& line, double from_start_mm) {
  double left = std::max(from_start_mm, 0.0);
  std::size_t i = 1;
  for (; i + 1 < line.size(); ++i) {
    const double step = distance_mm(line[i - 1], line[i]);
    if (left <= step) break;
    left -= step;
  }
  const PagePoint a = line[i - 1];
  const PagePoint b = line[i];
  const double step = distance_mm(a, b);
  const double share = step > 0 ? std::min(left / step, 1.0) : 0;
  return {{a.x_mm + share * (b.x_mm - a.x_mm), a.y_mm + share * (b.y_mm - a.y_mm)},
          std::atan2(a.y_mm - b.y_mm, b.x_mm - a.x_mm)};
}

namespace {

double off_chord_mm(PagePoint p, PagePoint a, PagePoint b) {
  const double length = distance_mm(a, b);
  if (length <= 0) return distance_mm(p, a);
  const double dx = b.x_mm - a.x_mm;
  const double dy = b.y_mm - a.y_mm;
  const double share =
      std::clamp(((p.x_mm - a.x_mm) * dx + (p.y_mm - a.y_mm) * dy) / (length * length), 0.0, 1.0);
  return distance_mm(p, {a.x_mm + share * dx, a.y_mm + share * dy});
}

}  // namespace

PageLine thinned(const PageLine& line) {
  constexpr double kTolerance_mm = 0.05;
  if (line.size() < 3) return line;
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> spans{{0, line.size() - 1}};
  while (!spans.empty()) {
    const auto [from, to] = spans.back();
    spans.pop_back();
    double worst = kTolerance_mm;
    std::size_t corner = from;
    for (std::size_t i = from + 1; i < to; ++i)
      if (const double off = off_chord_mm(line[i], line[from], line[to]); off > worst) {
        worst = off;
        corner = i;
      }
    if (corner == from) continue;
    kept[corner] = true;
    spans.emplace_back(from, corner);
    spans.emplace_back(corner, to);
  }
  PageLine out;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (kept[i]) out.push_back(line[i]);
  return out;
}

}  // namespace selion
