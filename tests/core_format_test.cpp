// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <array>
#include <charconv>
#include <clocale>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

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

TEST_CASE("numbers are rounded as to_chars rounds them", "[core][format]") {
  const auto exact = [](double value, int decimals) {
    std::array<char, 400> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals)
            .ptr;
    return std::string{digits.data(), end};
  };
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> share{-1, 1};
  std::size_t wrong = 0;
  const auto compare = [&](double value, int decimals) {
    const std::string text = exact(value, decimals);
    const bool zero = text.find_first_not_of("-0.") == std::string::npos;
    wrong += fixed(value, decimals) != (zero && text.front() == '-' ? text.substr(1) : text) ? 1 : 0;
  };
  for (int decimals = 0; decimals <= 10; ++decimals)
    for (int i = 0; i < 20'000; ++i) {
      const double value = share(random) * std::pow(10, static_cast<int>(random() % 18) - 10);
      compare(value, decimals);
      // halves of the last decimal, as near as doubles come, and their neighbours
      const double unit = std::pow(10, decimals);
      const double half = (std::floor(share(random) * 1e6) + 0.5) / unit;
      for (const double near : {half, std::nextafter(half, 1e9), std::nextafter(half, -1e9)})
        compare(near, decimals);
    }
  CHECK(wrong == 0);
}

TEST_CASE("no locale changes the point", "[core][format]") {
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr)
    WARN("skipped: no locale de_DE.UTF-8 on this machine");
  CHECK(fixed(1234.5, 1) == "1234.5");
  std::setlocale(LC_ALL, "C");
}
