// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include "field/georeference.hpp"

using namespace selion;

TEST_CASE("what is known of WGS84 without PROJ's database is what that says", "[field]") {
  const auto [known, asked] = GENERATE(std::pair{"OGC:CRS84", "urn:ogc:def:crs:OGC::CRS84"},
                                       std::pair{"EPSG:4326", "urn:ogc:def:crs:EPSG::4326"});
  CAPTURE(known, asked);
  Georeference here{known, "here"};
  Georeference there{asked, "there"};
  CHECK(here.name() == there.name());
  CHECK(here.datum() == there.datum());
  const RawPoint p{4.9, 52.3};
  const DatumStep& a = here.step_at(p);
  const DatumStep& b = there.step_at(p);
  CHECK(a.name == b.name);
  CHECK(a.accuracy_m == b.accuracy_m);
  const LonLat at = here.converted(p, a);
  CHECK(at.lon_deg == there.converted(p, b).lon_deg);
  CHECK(at.lat_deg == there.converted(p, b).lat_deg);
  CHECK_THROWS(here.check({190, 10}, "there"));
  CHECK(!here.outside_area_of_use(p, "here").has_value());
}
