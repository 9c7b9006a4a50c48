// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/field/frame.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include <proj.h>

#include "proj_handles.hpp"
#include "selion/core/error.hpp"
#include "selion/core/format.hpp"
#include "selion/core/units.hpp"
#include "text.hpp"

namespace selion {

struct LocalFrame::Projection {
  ProjContext context = make_proj_context();
  ProjObject from_wgs84;
};

namespace {

constexpr const char* kWgs84 = "+proj=longlat +datum=WGS84 +no_defs +type=crs";

constexpr std::string_view kOnWgs84 = " +datum=WGS84";

/// From radians, for a plane of the same datum: its own formulas, without the search for operations between
/// two reference systems and without the choice of one at every point.
ProjObject plain_projection(const ProjContext& context, std::string plane) {
  plane.replace(plane.find(kOnWgs84), kOnWgs84.size(), " +ellps=WGS84");
  return ProjObject{proj_create(context.get(), plane.c_str())};
}

ProjObject transformation(const ProjContext& context, const std::string& plane) {
  const ProjObject raw{
      proj_create_crs_to_crs(context.get(), kWgs84, (plane + " +type=crs").c_str(), nullptr)};
  if (!raw) return nullptr;
  return ProjObject{proj_normalize_for_visualization(context.get(), raw.get())};
}

/// The value behind " +key=", moved by `by`; added where the string has none.
std::string moved(std::string proj, const std::string& key, double by) {
  const std::string mark = " +" + key + "=";
  const auto at = proj.find(mark);
  if (at == std::string::npos) return proj + mark + shortest(by);
  const auto from = at + mark.size();
  const auto to = std::min(proj.find(' ', from), proj.size());
  double value = 0;
  std::from_chars(proj.data() + from, proj.data() + to, value);
  return proj.replace(from, to - from, shortest(value + by));
}

bool in_metres(const ProjContext& context, const PJ* crs) {
  const ProjObject axes{proj_crs_get_coordinate_system(context.get(), crs)};
  double metres = 0;
  return axes &&
         proj_cs_get_axis_info(context.get(), axes.get(), 0, nullptr, nullptr, nullptr, &metres, nullptr,
                               nullptr, nullptr) != 0 &&
         metres == 1;
}

/// " +towgs84=..." of the best step near `at` that seven numbers can say; empty where the datum is WGS84's.
std::optional<std::string> shift_to_wgs84(const ProjContext& context, const PJ* crs, LonLat at) {
  const ProjObject geodetic{proj_crs_get_geodetic_crs(context.get(), crs)};
  const ProjObject wgs84{proj_create(context.get(), "EPSG:4326")};
  const ProjFactory factory{proj_create_operation_factory_context(context.get(), nullptr)};
  proj_operation_factory_context_set_area_of_interest(context.get(), factory.get(), at.lon_deg, at.lat_deg,
                                                      at.lon_deg, at.lat_deg);
  proj_operation_factory_context_set_spatial_criterion(context.get(), factory.get(),
                                                       PROJ_SPATIAL_CRITERION_PARTIAL_INTERSECTION);
  const ProjList found{proj_create_operations(context.get(), geodetic.get(), wgs84.get(), factory.get())};
  for (int i = 0; found && i < proj_list_get_count(found.get()); ++i) {
    const ProjObject operation{proj_list_get(context.get(), found.get(), i)};
    std::array<double, 7> values{};
    constexpr int kQuietly = 0;
    if (proj_coordoperation_get_towgs84_values(context.get(), operation.get(), values.data(), 7, kQuietly) ==
        0)
      continue;
    std::string text = " +towgs84=";
    for (const double value : values) text += (text.ends_with('=') ? "" : ",") + shortest(value);
    return text;
  }
  return std::nullopt;
}

/// PROJ's utm takes no false origin: the same as a transverse Mercator does.
std::string without_utm(std::string proj) {
  const std::string mark = "+proj=utm +zone=";
  const auto at = proj.find(mark);
  if (at == std::string::npos) return proj;
  int zone = 0;
  const auto from = at + mark.size();
  const char* end = std::from_chars(proj.data() + from, proj.data() + proj.size(), zone).ptr;
  const std::string rest{static_cast<const char*>(end), static_cast<const char*>(proj.data()) + proj.size()};
  const auto south = rest.find(" +south");
  const std::string plane = "+proj=tmerc +lat_0=0 +lon_0=" + std::to_string(zone * 6 - 183) +
                            " +k=0.9996 +x_0=500000 +y_0=" + (south == std::string::npos ? "0" : "10000000");
  return plane + (south == std::string::npos ? rest : rest.substr(0, south) + rest.substr(south + 7));
}

/// @throws InputError unless the code is a projected CRS in metres that PROJ ties to WGS84 without a grid.
std::string proj_string_of(const ProjContext& context, const std::string& code, LonLat at) {
  const ProjObject crs{proj_create(context.get(), code.c_str())};
  const std::string where = "frame CRS '" + code + "'";
  if (!crs) throw InputError{where + " is not known to PROJ; give a code such as EPSG:2154, or auto"};
  if (proj_get_type(crs.get()) != PJ_TYPE_PROJECTED_CRS || !in_metres(context, crs.get()))
    throw InputError{where + " (" + proj_get_name(crs.get()) +
                     ") is not a projected CRS in metres; give another, or auto"};
  const char* text = proj_as_proj_string(context.get(), crs.get(), PJ_PROJ_4, nullptr);
  if (text == nullptr) throw InputError{where + " cannot be written as a PROJ string; give another, or auto"};
  std::string proj = text;
  if (const auto type = proj.find(" +type=crs"); type != std::string::npos) proj.erase(type);
  if (proj.find("+datum=WGS84") == std::string::npos && proj.find("+towgs84=") == std::string::npos) {
    const auto shift = shift_to_wgs84(context, crs.get(), at);
    if (!shift)
      throw InputError{where + " is not tied to WGS84 at " + place(at) +
                       " by numbers that a plan can carry: it needs a grid, or is made for another place; "
                       "give another, or auto"};
    if (const auto datum = proj.find(" +datum="); datum != std::string::npos) {
      const auto end = std::min(proj.find(' ', datum + 1), proj.size());
      const ProjObject ellipsoid{proj_get_ellipsoid(context.get(), crs.get())};
      double major_m = 0;
      double inverse_flattening = 0;
      proj_ellipsoid_get_parameters(context.get(), ellipsoid.get(), &major_m, nullptr, nullptr,
                                    &inverse_flattening);
      proj.replace(datum, end - datum, " +a=" + shortest(major_m) + " +rf=" + shortest(inverse_flattening));
    }
    proj += *shift;
  }
  return without_utm(proj);
}

}  // namespace

LocalFrame::LocalFrame(std::string proj, LonLat origin) : proj_{std::move(proj)}, origin_{origin} {
  auto made = std::make_shared<Projection>();
  same_datum_ = proj_.find(kOnWgs84) != std::string::npos;
  made->from_wgs84 =
      same_datum_ ? plain_projection(made->context, proj_) : transformation(made->context, proj_);
  if (!made->from_wgs84) throw InputError{"PROJ makes no projection of '" + proj_ + "'; use the frame auto"};
  projection_ = std::move(made);
}

LocalFrame LocalFrame::centred(LonLat origin) {
  return {"+proj=tmerc +lat_0=" + shortest(origin.lat_deg) + " +lon_0=" + shortest(origin.lon_deg) +
              " +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
          origin};
}

namespace {

/// A projection made for another place would make every width and length wrong.
void check_scale(const LocalFrame& frame, const std::string& code, LonLat origin) {
  constexpr double kMost = 0.001;  // national grids and UTM zones stay within that
  constexpr double kSpan_m = 200;
  const LocalFrame exact = LocalFrame::centred(origin);
  for (const Point to : {Point{kSpan_m, 0}, Point{0, kSpan_m}}) {
    const double stretch = length_m(frame.to_local(exact.to_lonlat(to))) / kSpan_m - 1;
    if (!(std::abs(stretch) <= kMost))
      throw InputError{"frame CRS '" + code + "' stretches lengths by " + fixed(100 * stretch, 2) + " % at " +
                       place(origin) + "; give one made for that place, or auto"};
  }
}

}  // namespace

LocalFrame LocalFrame::of_crs(const std::string& code, LonLat origin) {
  const ProjContext context = make_proj_context();
  const std::string proj = proj_string_of(context, code, origin);
  const Point at = LocalFrame{proj, origin}.to_local(origin);
  if (!std::isfinite(at.x_m) || !std::isfinite(at.y_m))
    throw InputError{"frame CRS '" + code + "' does not reach " + place(origin) + "; give another, or auto"};
  LocalFrame frame{moved(moved(proj, "x_0", -at.x_m), "y_0", -at.y_m), origin};
  constexpr double kMoved_m = 1e-6;
  if (!(length_m(frame.to_local(origin)) < kMoved_m))
    throw InputError{"frame CRS '" + code + "' takes no false origin; give another, or auto"};
  check_scale(frame, code, origin);
  return frame;
}

Point LocalFrame::to_local(LonLat p) const {
  const PJ_COORD given =
      same_datum_ ? proj_coord(radians_of_degrees(p.lon_deg), radians_of_degrees(p.lat_deg), 0, HUGE_VAL)
                  : proj_coord(p.lon_deg, p.lat_deg, 0, HUGE_VAL);
  const PJ_COORD out = proj_trans(projection_->from_wgs84.get(), PJ_FWD, given);
  return {out.xy.x, out.xy.y};
}

LonLat LocalFrame::to_lonlat(Point p) const {
  constexpr double kExact_m = 1e-8;
  constexpr int kMost = 3;
  LonLat found;
  Point aim = p;
  // A datum shift in two dimensions drops the height, so PROJ's way back misses by up to a millimetre.
  for (int i = 0; i < kMost; ++i) {
    const PJ_COORD out =
        proj_trans(projection_->from_wgs84.get(), PJ_INV, proj_coord(aim.x_m, aim.y_m, 0, HUGE_VAL));
    if (same_datum_) return {degrees_of_radians(out.xy.x), degrees_of_radians(out.xy.y)};
    found = {out.xy.x, out.xy.y};
    const Point missed = p - to_local(found);
    if (!(length_m(missed) > kExact_m)) break;
    aim = aim + missed;
  }
  return found;
}

double LocalFrame::bearing_deg(Point p, Point ahead) const {
  constexpr double kStep_m = 50;  // long against rounding, short against the change of convergence
  const LonLat from = to_lonlat(p - kStep_m * ahead);
  const LonLat to = to_lonlat(p + kStep_m * ahead);
  const double middle_rad = radians_of_degrees((from.lat_deg + to.lat_deg) / 2);
  constexpr double kFlatteningSquared = 0.00669437999014;  // e2 of WGS84
  const double w2 = 1 - kFlatteningSquared * std::sin(middle_rad) * std::sin(middle_rad);
  const double east = std::remainder(to.lon_deg - from.lon_deg, 360) * std::cos(middle_rad);
  const double up =
      (to.lat_deg - from.lat_deg) * (1 - kFlatteningSquared) / w2;  // radii M : N = (1 - e2) : w2
  return degrees_of_radians(std::atan2(east, up));
}

double LocalFrame::convergence_deg(Point p) const { return bearing_deg(p, {0, 1}); }

LocalFrame LocalFrame::cloned() const { return {proj_, origin_}; }

LonLat centre(const Field& field) {
  double reference = 0;
  bool first = true;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  LonLat low{kInfinity, kInfinity};
  LonLat high{-kInfinity, -kInfinity};
  for (const LonLatPolygon& part : field.parts) {
    for (const LonLat p : part.shell) {
      if (std::exchange(first, false)) reference = p.lon_deg;
      const double lon = reference + std::remainder(p.lon_deg - reference, 360);
      low = {std::min(low.lon_deg, lon), std::min(low.lat_deg, p.lat_deg)};
      high = {std::max(high.lon_deg, lon), std::max(high.lat_deg, p.lat_deg)};
    }
  }
  if (first) throw InputError{field.source + " has no boundary"};
  const auto rounded = [](double degrees) {
    return std::round(degrees * 1e9) / 1e9;
  };  // as a plan file writes it
  return {rounded(std::remainder((low.lon_deg + high.lon_deg) / 2, 360)),
          rounded((low.lat_deg + high.lat_deg) / 2)};
}

}  // namespace selion
