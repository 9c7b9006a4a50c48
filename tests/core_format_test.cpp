// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <clocale>
#include <limits>
#include <stdexcept>

#include "selion/core/format.hpp"

using selion::append_fixed;
using selion::fixed;

TEST_CASE("a number is rounded to its decimals", "[core][format]") {
  CHECK(fixed(12.5, 2) == "12.50");
  CHECK(fixed(2.0 / 3, 4) == "0.6667");
  CHECK(fixed(-1234567.891, 1) == "-1234567.9");
  CHECK(fixed(9.99, 0) == "10");
  CHECK(fixed(3.409432100499, 9) == "3.409432100");
}

TEST_CASE("a zero has no sign, a small negative number keeps it", "[core][format]") {
  CHECK(fixed(-0.0, 3) == "0.000");
  CHECK(fixed(-0.0004, 3) == "0.000");
  CHECK(fixed(-0.0, 0) == "0");
  CHECK(fixed(-0.0006, 3) == "-0.001");
}

TEST_CASE("the largest number fits", "[core][format]") {
  CHECK(fixed(std::numeric_limits<double>::lowest(), 17).size() == 1 + 309 + 1 + 17);
}

TEST_CASE("what is not a number is never written", "[core][format]") {
  CHECK_THROWS_AS(fixed(std::numeric_limits<double>::quiet_NaN(), 3), std::logic_error);
  CHECK_THROWS_AS(fixed(-std::numeric_limits<double>::infinity(), 3), std::logic_error);
}

TEST_CASE("numbers are written behind what is there", "[core][format]") {
  std::string out = "x = ";
  append_fixed(out, 1.25, 1);
  CHECK(out == "x = 1.2");
}

TEST_CASE("no locale changes the point", "[core][format]") {
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr)
    WARN("skipped: no locale de_DE.UTF-8 on this machine");
  CHECK(fixed(1234.5, 1) == "1234.5");
  std::setlocale(LC_ALL, "C");
}
