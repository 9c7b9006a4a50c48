// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <fstream>

#include "batch_samples.hpp"
#include "selion/batch/journal.hpp"

using namespace selion;

namespace {

const BatchIdentity kIdentity{"0.1.0", "in", "job", "options"};

BatchResult planned_field() {
  BatchResult result;
  result.number = 7;
  result.file = "a \"b\".gpkg";
  result.layer = "caf\xC3\xA9";
  result.feature = 9;
  result.name = "line\nbreak, comma";
  result.status = BatchStatus::partial;
  result.reason = "block 2: too narrow";
  result.area_m2 = 12345.6789;
  result.figures = BatchFigures{10000.5, 12.25, 30, 2, 4567.125, 890.5};
  result.verified = "ok";
  result.plan = "plans/0000/7_line.geojson";
  result.plan_bytes = 123456789012;
  result.boundary = {
      {{{5, 52}, {5.001, 52}, {5.001, 52.001}}, {{{5.0005, 52.0002}, {5.0006, 52.0002}, {5.0006, 52.0003}}}},
      {{{6, 52}, {6.001, 52}, {6.001, 52.001}}, {}}};
  return result;
}

BatchResult unreadable_file() {
  BatchResult result;
  result.number = 8;
  result.file = result.name = "broken.shp";
  result.status = BatchStatus::error;
  result.reason = "cut off";
  return result;
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream{file, std::ios::binary} << text;
}

}  // namespace

TEST_CASE("a result comes back from its journal line as it was", "[batch]") {
  for (const BatchResult& result : {planned_field(), unreadable_file()}) {
    const std::string line = journal_line(result);
    CHECK(line.find('\n') == line.size() - 1);
    CHECK(result_of_line(line) == result);
  }
}

TEST_CASE("a journal cut off anywhere counts up to its last whole line", "[batch]") {
  const BatchScratch scratch;
  const auto file = scratch.at / "1-of-1.jsonl";
  const std::string header = journal_header(kIdentity, {2, 3});
  const std::string first = journal_line(planned_field());
  const std::string second = journal_line(unreadable_file());
  const std::string whole = header + first + second + journal_end(8);
  const std::size_t all_results = header.size() + first.size() + second.size();
  for (std::size_t bytes = 0; bytes <= whole.size(); ++bytes) {
    write(file, whole.substr(0, bytes));
    std::size_t told = 0;
    const JournalIndex index = read_journal(file, [&told](const BatchResult&) { ++told; });
    const std::size_t expected =
        (bytes >= header.size() + first.size() ? 1U : 0U) + (bytes >= all_results ? 1U : 0U);
    CAPTURE(bytes);
    REQUIRE(told == expected);
    REQUIRE(index.lines.size() == expected);
    REQUIRE(index.identity.has_value() == (bytes >= header.size()));
    REQUIRE(index.numbers.has_value() == (bytes == whole.size()));
    REQUIRE(index.good_bytes <= bytes);
    REQUIRE(whole.compare(0, index.good_bytes, whole, 0, bytes) <= 0);
  }
}

TEST_CASE("what stands behind a broken line of a journal does not count", "[batch]") {
  const BatchScratch scratch;
  const auto file = scratch.at / "journal";
  const std::string good = journal_header(kIdentity, {1, 1}) + journal_line(planned_field());
  for (const std::string& broken :
       {std::string(50, '\0') + "\n", std::string{"{\"number\": 3}\n"}, std::string{"[]\n"}}) {
    write(file, good + broken + journal_line(unreadable_file()));
    const JournalIndex index = read_journal(file, [](const BatchResult&) {});
    CHECK(index.lines.size() == 1);
    CHECK(index.good_bytes == good.size());
  }
}

TEST_CASE("the lines of a journal are found again by their places", "[batch]") {
  const BatchScratch scratch;
  const auto file = scratch.at / "journal";
  const std::string text =
      journal_header(kIdentity, {1, 1}) + journal_line(planned_field()) + journal_line(unreadable_file());
  write(file, text);
  const JournalIndex index = read_journal(file, [](const BatchResult&) {});
  REQUIRE(index.lines.size() == 2);
  CHECK(result_of_line(text.substr(index.lines[1].offset, index.lines[1].bytes)) == unreadable_file());
}

TEST_CASE("a journal says what a batch was begun with", "[batch]") {
  CHECK(difference(kIdentity, kIdentity).empty());
  CHECK(difference(kIdentity, {"0.2.0", "in", "job", "options"}).find("0.2.0") != std::string::npos);
  CHECK(difference(kIdentity, {"0.1.0", "other", "job", "options"}).find("fields") != std::string::npos);
  CHECK(difference(kIdentity, {"0.1.0", "in", "other", "options"}).find("job") != std::string::npos);
  CHECK(difference(kIdentity, {"0.1.0", "in", "job", "other"}).find("options") != std::string::npos);
}
