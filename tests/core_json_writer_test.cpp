// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <limits>
#include <stdexcept>

#include "selion/core/json_writer.hpp"

using selion::JsonSpread;
using selion::JsonWriter;

namespace {

std::string quoted(std::string_view text) { return JsonWriter{}.text(text).str(); }

}  // namespace

TEST_CASE("members stand in the order of the calls, spread as asked", "[core][json]") {
  JsonWriter json;
  json.begin_object(JsonSpread::lines);
  json.key("width_m").number(3, 2);
  json.key("at").begin_array(JsonSpread::line).number(1, 1).whole(-2).end();
  json.key("rows").begin_array(JsonSpread::lines);
  json.begin_object(JsonSpread::line).key("id").text("12a").key("job").raw("{\"a\":1.0}").end();
  json.begin_object(JsonSpread::lines).end();
  json.end().end();

  CHECK(json.str() == R"({
  "width_m": 3.00,
  "at": [1.0, -2],
  "rows": [
    {"id": "12a", "job": {"a":1.0}},
    {}
  ]
})");
}

TEST_CASE("quotes, backslashes and control characters are escaped", "[core][json]") {
  CHECK(quoted("a\"b\\c\n\r\t\x01/") == R"("a\"b\\c\n\r\t\u0001/")");
  CHECK(quoted(std::string_view{"\0", 1}) == R"("\u0000")");
}

TEST_CASE("well-formed UTF-8 passes, each other byte becomes a replacement character", "[core][json]") {
  const std::string_view good = "\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8C\xBE";
  CHECK(quoted(good) == "\"" + std::string{good} + "\"");
  const auto bad =
      GENERATE("\xE9", "\x80", "\xC3", "\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82");
  const std::string text = quoted(std::string{bad} + "x");
  CHECK(text.find("\xEF\xBF\xBD") == 1);
  CHECK(text.substr(text.size() - 2) == "x\"");
}

TEST_CASE("JSON never holds a number that is not finite", "[core][json]") {
  CHECK_THROWS_AS(JsonWriter{}.number(std::numeric_limits<double>::infinity(), 2), std::logic_error);
}
