// SPDX-License-Identifier: GPL-3.0-or-later
#include "georeference.hpp"

#include <array>
#include <cmath>

#include <proj.h>

#include "selion/core/error.hpp"
#include "selion/core/units.hpp"
#include "text.hpp"

namespace selion {
namespace {

constexpr const char* kTarget = "EPSG:4326";
constexpr const char* kWgs84Datum = "World Geodetic System 1984";
constexpr double kRounding_deg = 1e-6;  // a reprojected 180 may come as 180.0000001

std::string name_of(const ProjContext& context, const PJ* crs) {
  const char* authority = proj_get_id_auth_name(crs, 0);
  const char* code = proj_get_id_code(crs, 0);
  const std::string name = proj_get_name(crs);
  (void)context;
  return authority != nullptr && code != nullptr ? std::string{authority} + ":" + code + " (" + name + ")"
                                                 : name;
}

ProjObject geodetic_of(const ProjContext& context, const PJ* crs) {
  return ProjObject{proj_crs_get_geodetic_crs(context.get(), crs)};
}

std::string datum_of(const ProjContext& context, const PJ* geodetic) {
  const ProjObject datum{proj_crs_get_datum_forced(context.get(), geodetic)};
  std::string name = datum ? proj_get_name(datum.get()) : "unknown";
  const std::string tail = " ensemble";
  if (name.ends_with(tail)) name.erase(name.size() - tail.size());
  return name;
}

std::optional<double> degrees_per_unit(const ProjContext& context, const PJ* crs) {
  const PJ_TYPE type = proj_get_type(crs);
  if (type != PJ_TYPE_GEOGRAPHIC_2D_CRS && type != PJ_TYPE_GEOGRAPHIC_3D_CRS) return std::nullopt;
  const ProjObject axes{proj_crs_get_coordinate_system(context.get(), crs)};
  double radians = 0;
  if (!axes || proj_cs_get_axis_info(context.get(), axes.get(), 0, nullptr, nullptr, nullptr, &radians,
                                     nullptr, nullptr, nullptr) == 0)
    return 1;
  const double degrees = degrees_of_radians(radians);
  return std::abs(degrees - 1) < 1e-9 ? 1 : degrees;
}

/// Conversions within one datum have no accuracy of their own: they are exact. Where a datum changes, -1 is
/// "not known".
std::optional<double> accuracy_of(const ProjContext& context, const PJ* operation, bool same_datum) {
  if (same_datum) return 0;
  if (proj_coordoperation_has_ballpark_transformation(context.get(), operation) != 0) return std::nullopt;
  const double accuracy = proj_coordoperation_get_accuracy(context.get(), operation);
  if (accuracy < 0) return std::nullopt;
  return accuracy;
}

std::vector<std::string> missing_grids(const ProjContext& context, const PJ* operation) {
  std::vector<std::string> missing;
  const int count = proj_coordoperation_get_grid_used_count(context.get(), operation);
  for (int i = 0; i < count; ++i) {
    const char* name = nullptr;
    int available = 0;
    if (proj_coordoperation_get_grid_used(context.get(), operation, i, &name, nullptr, nullptr, nullptr,
                                          nullptr, nullptr, &available) != 0 &&
        available == 0 && name != nullptr)
      missing.emplace_back(name);
  }
  return missing;
}

LonLat transformed(PJ* operation, RawPoint p) {
  const PJ_COORD out = proj_trans(operation, PJ_FWD, proj_coord(p.x, p.y, 0, HUGE_VAL));
  return {out.xy.x, out.xy.y};
}

bool finite(LonLat p) { return std::isfinite(p.lon_deg) && std::isfinite(p.lat_deg); }

/// What PROJ's database says of WGS84 itself; to open that takes longer than to read a field.
std::optional<std::string> name_of_wgs84(const std::string& crs) {
  if (crs == "OGC:CRS84") return "OGC:CRS84 (WGS 84 (CRS84))";
  if (crs == "EPSG:4326") return "EPSG:4326 (WGS 84)";
  return std::nullopt;
}

}  // namespace

Georeference::Georeference(const std::string& crs, const std::string& where) : context_{make_proj_context()} {
  if (auto name = name_of_wgs84(crs)) {
    name_ = *std::move(name);
    datum_ = kWgs84Datum;
    degrees_per_unit_ = 1;
    is_wgs84_ = true;
    return;
  }
  crs_.reset(proj_create(context_.get(), crs.c_str()));
  if (!crs_ || proj_is_crs(crs_.get()) == 0)
    throw InputError{where + ": PROJ does not know the CRS '" + crs.substr(0, 80) +
                     "'; give one as --crs EPSG:CODE"};
  const ProjObject geodetic = geodetic_of(context_, crs_.get());
  const ProjObject target{proj_create(context_.get(), kTarget)};
  const ProjObject raw{
      geodetic ? proj_create_crs_to_crs_from_pj(context_.get(), crs_.get(), target.get(), nullptr, nullptr)
               : nullptr};
  if (raw) rough_.reset(proj_normalize_for_visualization(context_.get(), raw.get()));
  if (!rough_)
    throw InputError{where + ": the CRS " + name_of(context_, crs_.get()) +
                     " has no known place on earth; give the true one as --crs EPSG:CODE"};
  name_ = name_of(context_, crs_.get());
  datum_ = datum_of(context_, geodetic.get());
  degrees_per_unit_ = degrees_per_unit(context_, crs_.get());
  is_wgs84_ = degrees_per_unit_ == 1.0 && datum_ == kWgs84Datum;
  Area area;
  const char* about = nullptr;
  if (!degrees_per_unit_ &&
      proj_get_area_of_use(context_.get(), crs_.get(), &area.west, &area.south, &area.east, &area.north,
                           &about) != 0 &&
      area.west > -1000) {
    area.name = about == nullptr ? "" : about;
    area_ = area;
  }
}

void Georeference::check(RawPoint p, const std::string& where) const {
  if (!degrees_per_unit_) {
    if (!finite(rough(p)))
      throw InputError{where + ": x " + shortest(p.x) + ", y " + shortest(p.y) +
                       " lies outside the range of " + name_ +
                       "; check the file's CRS and whether its axes are swapped"};
    return;
  }
  const double lon = p.x * *degrees_per_unit_;
  const double lat = p.y * *degrees_per_unit_;
  if (std::abs(lon) <= 180 + kRounding_deg && std::abs(lat) <= 90 + kRounding_deg) return;
  const bool swapped = std::abs(lat) <= 180 && std::abs(lon) <= 90;
  const bool beyond_lat = std::abs(lat) > 90 + kRounding_deg;
  throw InputError{
      where + ": " +
      (beyond_lat ? "latitude " + shortest(p.y) + " is outside -90 to 90"
                  : "longitude " + shortest(p.x) + " is outside -180 to 180") +
      (swapped ? "; are longitude and latitude swapped?"
               : "; these are no degrees of " + name_ +
                     ": correct the file's CRS, or name it with --crs EPSG:CODE where the file has none")};
}

LonLat Georeference::rough(RawPoint p) const {
  return rough_ ? transformed(rough_.get(), p) : LonLat{p.x, p.y};
}

bool Georeference::in_area(LonLat p, double margin_deg) const {
  const double width =
      area_->east - area_->west + (area_->east < area_->west ? 360 : 0);  // some cross the antimeridian
  const double from_middle = std::remainder(p.lon_deg - (area_->west + width / 2), 360);
  return std::abs(from_middle) <= width / 2 + margin_deg && p.lat_deg >= area_->south - margin_deg &&
         p.lat_deg <= area_->north + margin_deg;
}

std::optional<std::string> Georeference::outside_area_of_use(RawPoint p, const std::string& where) const {
  constexpr double kMargin_deg = 1;
  constexpr double kFar_deg = 10;
  if (!area_) return std::nullopt;
  const LonLat at = rough(p);
  if (in_area(at, kMargin_deg)) return std::nullopt;
  const LonLat mirrored = rough({p.y, p.x});
  const std::string about = where + " lies at " + place(at) + ", outside the area of use of " + name_ + " (" +
                            area_->name.substr(0, area_->name.find(':')) + ")";
  if (finite(mirrored) && in_area(mirrored, kMargin_deg))
    throw InputError{about + "; with x and y swapped it lies inside: correct the axis order of the file"};
  if (!in_area(at, kFar_deg)) throw InputError{about + "; correct the file's CRS, or the coordinates"};
  return about + "; check the CRS";
}

DatumStep Georeference::best_step(LonLat low, LonLat high) const {
  const ProjObject target{proj_create(context_.get(), kTarget)};
  const ProjFactory factory{proj_create_operation_factory_context(context_.get(), nullptr)};
  proj_operation_factory_context_set_area_of_interest(context_.get(), factory.get(), low.lon_deg, low.lat_deg,
                                                      high.lon_deg, high.lat_deg);
  proj_operation_factory_context_set_spatial_criterion(context_.get(), factory.get(),
                                                       PROJ_SPATIAL_CRITERION_PARTIAL_INTERSECTION);
  proj_operation_factory_context_set_grid_availability_use(context_.get(), factory.get(),
                                                           PROJ_GRID_AVAILABILITY_USED_FOR_SORTING);
  const ProjList found{proj_create_operations(context_.get(), crs_.get(), target.get(), factory.get())};
  DatumStep step;
  std::vector<std::pair<double, std::vector<std::string>>> unavailable;
  for (int i = 0; i < (!found ? 0 : proj_list_get_count(found.get())); ++i) {
    const ProjObject operation{proj_list_get(context_.get(), found.get(), i)};
    const bool works = proj_coordoperation_is_instantiable(context_.get(), operation.get()) != 0;
    if (works && !step.operation) {
      step.operation.reset(proj_normalize_for_visualization(context_.get(), operation.get()));
      step.name = proj_get_name(operation.get());
      step.accuracy_m = accuracy_of(context_, operation.get(), datum_ == kWgs84Datum);
    } else if (!works) {
      unavailable.emplace_back(proj_coordoperation_get_accuracy(context_.get(), operation.get()),
                               missing_grids(context_, operation.get()));
    }
  }
  for (auto& [accuracy, grids] : unavailable) {
    const bool better = accuracy >= 0 && (!step.accuracy_m || accuracy < *step.accuracy_m);
    if (better && step.missing_grids.empty()) step.missing_grids = std::move(grids);
  }
  return step;
}

const DatumStep& Georeference::step_at(RawPoint p) {
  constexpr double kCell_deg = 0.25;
  const LonLat at = rough(p);
  const std::pair cell{static_cast<int>(std::floor(at.lon_deg / kCell_deg)),
                       static_cast<int>(std::floor(at.lat_deg / kCell_deg))};
  if (const auto known = steps_.find(cell); known != steps_.end()) return known->second;
  const LonLat low{cell.first * kCell_deg, cell.second * kCell_deg};
  DatumStep step;
  if (is_wgs84_)
    step = {nullptr, "none", 0.0, {}};
  else
    step = best_step(low, {low.lon_deg + kCell_deg, low.lat_deg + kCell_deg});
  return steps_.emplace(cell, std::move(step)).first->second;
}

LonLat Georeference::converted(RawPoint p, const DatumStep& step) const {
  if (is_wgs84_) return {p.x, p.y};
  return transformed(step.operation ? step.operation.get() : rough_.get(), p);
}

bool same_crs(const std::string& a, const std::string& b) {
  const ProjContext context = make_proj_context();
  const ProjObject first{proj_create(context.get(), a.c_str())};
  const ProjObject second{proj_create(context.get(), b.c_str())};
  return first && second &&
         proj_is_equivalent_to_with_ctx(context.get(), first.get(), second.get(),
                                        PJ_COMP_EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS) != 0;
}

}  // namespace selion
