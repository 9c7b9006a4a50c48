// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <set>
#include <string>

#include "selion/planfile/planfile.hpp"

using selion::plan_id;

TEST_CASE("an id is the documented hash", "[planfile][id]") {
  // docs/plan.md's formula, worked out in another language.
  CHECK(plan_id("", "") == "b9034ad37056f5fb");
  CHECK(plan_id("field", "{\"a\":1}") == "005d27195792dc53");
}

TEST_CASE("an id tells input from job, and any change of either", "[planfile][id]") {
  CHECK(plan_id("ab", "c") != plan_id("a", "bc"));
  std::set<std::string> ids;
  for (int i = 0; i < 20'000; ++i)
    ids.insert(plan_id("field " + std::to_string(i % 100), std::to_string(i / 100)));
  CHECK(ids.size() == 20'000);
}
