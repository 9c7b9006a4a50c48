// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <cmath>

#include "field_samples.hpp"
#include "selion/core/units.hpp"
#include "selion/field/frame.hpp"

using namespace selion;

namespace {

const LonLat kHere{3.430409, 46.336788};

/// Vincenty's inverse formula (1975), for lengths that know nothing of our frame.
double geodesic_m(LonLat p, LonLat q) {
  const double a = 6378137;
  const double f = 1 / 298.257223563;
  const double b = a * (1 - f);
  const double u1 = std::atan((1 - f) * std::tan(radians_of_degrees(p.lat_deg)));
  const double u2 = std::atan((1 - f) * std::tan(radians_of_degrees(q.lat_deg)));
  const double l = radians_of_degrees(q.lon_deg - p.lon_deg);
  double lambda = l, sigma = 0, sin_sigma = 0, cos_sigma = 0, cos2_alpha = 0, cos_2m = 0;
  for (int i = 0; i < 50; ++i) {
    const double s = std::cos(u2) * std::sin(lambda);
    const double t = std::cos(u1) * std::sin(u2) - std::sin(u1) * std::cos(u2) * std::cos(lambda);
    sin_sigma = std::hypot(s, t);
    cos_sigma = std::sin(u1) * std::sin(u2) + std::cos(u1) * std::cos(u2) * std::cos(lambda);
    sigma = std::atan2(sin_sigma, cos_sigma);
    const double sin_alpha = std::cos(u1) * std::cos(u2) * std::sin(lambda) / sin_sigma;
    cos2_alpha = 1 - sin_alpha * sin_alpha;
    cos_2m = cos_sigma - 2 * std::sin(u1) * std::sin(u2) / cos2_alpha;
    const double c = f / 16 * cos2_alpha * (4 + f * (4 - 3 * cos2_alpha));
    lambda = l + (1 - c) * f * sin_alpha *
                     (sigma + c * sin_sigma * (cos_2m + c * cos_sigma * (-1 + 2 * cos_2m * cos_2m)));
  }
  const double u = cos2_alpha * (a * a - b * b) / (b * b);
  const double big_a = 1 + u / 16384 * (4096 + u * (-768 + u * (320 - 175 * u)));
  const double big_b = u / 1024 * (256 + u * (-128 + u * (74 - 47 * u)));
  const double delta = big_b * sin_sigma * (cos_2m + big_b / 4 * (cos_sigma * (-1 + 2 * cos_2m * cos_2m)));
  return b * big_a * (sigma - delta);
}

}  // namespace

TEST_CASE("a frame's origin is its zero and 10 km away it still returns", "[field][frame]") {
  const auto frame = LocalFrame::centred(kHere);
  CHECK(length_m(frame.to_local(kHere)) < 1e-7);
  for (const Point p : {Point{10e3, 0}, Point{0, -10e3}, Point{-7e3, 7e3}, Point{0.25, 400}})
    CHECK(distance_m(frame.to_local(frame.to_lonlat(p)), p) < 1e-7);
}

TEST_CASE("nine decimals of a degree keep a tenth of a millimetre", "[field][frame]") {
  const auto frame = LocalFrame::centred(kHere);
  const Point p{1234.5678, -987.6543};
  const LonLat exact = frame.to_lonlat(p);
  const LonLat written{std::round(exact.lon_deg * 1e9) / 1e9, std::round(exact.lat_deg * 1e9) / 1e9};
  CHECK(distance_m(frame.to_local(written), p) < 1e-4);
}

TEST_CASE("lengths in the default frame are lengths on the ellipsoid", "[field][frame]") {
  const auto frame = LocalFrame::centred(kHere);
  for (const Point p : {Point{1000, 0}, Point{0, 1000}, Point{-600, 800}})
    CHECK(geodesic_m(kHere, frame.to_lonlat(p)) == Approx(1000).margin(1e-4));
}

TEST_CASE("a frame by code is the same plane with its origin at the field", "[field][frame]") {
  const auto frame = LocalFrame::of_crs("EPSG:2154", kHere);
  CHECK(length_m(frame.to_local(kHere)) < 1e-6);
  CHECK(frame.proj().find("+proj=lcc") != std::string::npos);
  // Lambert-93 has its parallels at 44 and 49 degrees: at 46.3 it shrinks lengths by nearly a thousandth.
  const double scale = length_m(frame.to_local(LocalFrame::centred(kHere).to_lonlat({1000, 0}))) / 1000;
  CHECK(scale > 0.9985);
  CHECK(scale < 0.9995);
  const auto again = LocalFrame::of_crs("EPSG:2154", kHere);
  CHECK(again.proj() == frame.proj());
}

TEST_CASE("a frame in another datum comes back to the same place", "[field][frame]") {
  const LonLat amsterdam{4.9, 52.37};
  const auto frame = LocalFrame::of_crs("EPSG:28992", amsterdam);
  CHECK(length_m(frame.to_local(amsterdam)) < 1e-6);
  const Point p{300, -200};
  CHECK(distance_m(frame.to_local(frame.to_lonlat(p)), p) < 1e-7);
  CHECK(length_m(LocalFrame::centred(amsterdam).to_local(frame.to_lonlat(p))) ==
        Approx(length_m(p)).epsilon(1.2e-4));
}

TEST_CASE("UTM frames take their false origin too, north and south", "[field][frame]") {
  CHECK(length_m(LocalFrame::of_crs("EPSG:32631", kHere).to_local(kHere)) < 1e-6);
  const LonLat south{-46.1, -12.2};
  const auto frame = LocalFrame::of_crs("EPSG:32723", south);
  CHECK(length_m(frame.to_local(south)) < 1e-6);
  CHECK(frame.to_local({south.lon_deg, south.lat_deg + 0.001}).y_m == Approx(110.6).margin(0.5));
}

TEST_CASE("a frame needs a projected CRS in metres", "[field][frame]") {
  CHECK(mentions(error_of([] { LocalFrame::of_crs("EPSG:4326", kHere); }), "not a projected CRS"));
  CHECK(mentions(error_of([] {
                   LocalFrame::of_crs("EPSG:2263", {-74, 40.7});
                 }),
                 "not a projected CRS"));  // US survey feet
  CHECK(mentions(error_of([] { LocalFrame::of_crs("EPSG:999999", kHere); }), "not known"));
  CHECK(mentions(error_of([] { LocalFrame::of_crs("EPSG:2193", kHere); }), "is made for another place"));
}

TEST_CASE("the convergence is zero on the central meridian and its formula beside it", "[field][frame]") {
  const auto frame = LocalFrame::centred(kHere);
  CHECK(frame.convergence_deg({0, 500}) == Approx(0).margin(1e-7));
  // tan(gamma) = tan(dlon) sin(lat) on the sphere; grid north leans to the east of true north east of the
  // meridian.
  const Point east{5000, 0};
  const LonLat there = frame.to_lonlat(east);
  const double expected = (there.lon_deg - kHere.lon_deg) * std::sin(radians_of_degrees(there.lat_deg));
  CHECK(std::abs(frame.convergence_deg(east)) == Approx(expected).epsilon(1e-3));
  const LonLat up = frame.to_lonlat(east + Point{0, 1000});
  CHECK((up.lon_deg > there.lon_deg) == (frame.convergence_deg(east) > 0));
}

TEST_CASE("bearings are true where the frame keeps no angles", "[field][frame]") {
  // Europe's equal area frame (EPSG:3035) far from its centre; 100 m to the north-east on the ellipsoid
  const LonLat here{26, 62};
  const auto frame = LocalFrame::of_crs("EPSG:3035", here);
  const auto tangent = LocalFrame::centred(here);
  const Point at = frame.to_local(here);
  int askew = 0;
  for (const double bearing : {0.0, 30.0, 45.0, 90.0, 135.0, -60.0}) {
    CAPTURE(bearing);
    const double heading = radians_of_degrees(90 - bearing);
    const Point ahead = frame.to_local(tangent.to_lonlat(100 * unit(heading))) - at;
    const Point unit_ahead = (1 / length_m(ahead)) * ahead;
    CHECK(frame.bearing_deg(at, unit_ahead) == Approx(bearing).margin(1e-3));
    const double leaning = 90 - degrees_of_radians(heading_rad(ahead)) + frame.convergence_deg(at);
    askew += std::abs(std::remainder(leaning - bearing, 360)) > 0.05 ? 1 : 0;
  }
  CHECK(askew > 0);
}

TEST_CASE("a clone of a frame gives the same metres", "[field][frame]") {
  const auto frame = LocalFrame::centred(kHere);
  const auto copy = frame.cloned();
  CHECK(copy.proj() == frame.proj());
  CHECK(copy.to_local({3.44, 46.34}) == frame.to_local({3.44, 46.34}));
}

TEST_CASE("the centre of a field across the antimeridian lies there", "[field][frame]") {
  Field field;
  field.parts = {{{{179.998, -16.8}, {-179.998, -16.8}, {-179.998, -16.797}, {179.998, -16.797}}, {}}};
  CHECK(std::abs(centre(field).lon_deg) == Approx(180).margin(1e-6));
  CHECK(centre(field).lat_deg == Approx(-16.7985));
}
