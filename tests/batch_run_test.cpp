// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>

#include "batch_samples.hpp"
#include "field_samples.hpp"
#include "files.hpp"
#include "selion/core/error.hpp"
#include "selion/field/read.hpp"
#include "selion/field/stream.hpp"
#include "selion/plan/plan.hpp"
#include "selion/planfile/planfile.hpp"

using namespace selion;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

constexpr int kFields = 12;

/// Lines of the table that have this status.
int rows_with(const std::map<std::string, std::string>& files, const std::string& status) {
  const std::string& table = files.at("results.csv");
  int count = 0;
  for (auto at = table.find("," + status + ","); at != std::string::npos;
       at = table.find("," + status + ",", at + 1))
    ++count;
  return count;
}

std::map<std::string, std::string> batch_of_one_run(const BatchScratch& scratch, const fs::path& fields) {
  run_batch(small_batch(fields, scratch.at / "whole"), nobody());
  return files_below(scratch.at / "whole");
}

}  // namespace

TEST_CASE("every field of a batch has one result", "[batch]") {
  const BatchScratch scratch;
  const fs::path fields = small_fields(scratch.at, kFields);

  const BatchCount count = run_batch(small_batch(fields, scratch.at / "out"), nobody());

  CHECK(count.total() == kFields);
  CHECK(count.numbers == kFields);
  CHECK(count.tables);
  const auto files = files_below(scratch.at / "out");
  CHECK(rows_with(files, "infeasible") == 4);
  CHECK(rows_with(files, "error") == 2);
  CHECK(rows_with(files, "done") + rows_with(files, "partial") == 6);
  CHECK(files.contains("plans/0000/1_field,_1.geojson"));
  CHECK_FALSE(files.contains("plans/0000/3_field,_3.geojson"));
}

TEST_CASE("a batch is summed up in a few figures", "[batch]") {
  BatchSummary summary;
  CHECK_FALSE(summary.covered_percent(0.5));
  BatchResult result;
  result.area_m2 = 1000;
  for (int percent = 1; percent <= 100; ++percent) {
    result.figures = BatchFigures{.covered_m2 = 10.0 * percent + 0.5};
    result.verified = percent == 7 ? "failed: outside" : percent > 90 ? "" : "passed";
    summary.take(result);
  }
  result.figures.reset();
  for (const auto* reason : {"too narrow: a swath needs 3.6 m", "block 2: too narrow: a swath needs 5 m",
                             "gate 1 is 1.50 m wide"}) {
    result.status = BatchStatus::infeasible;
    result.reason = reason;
    summary.take(result);
  }
  result.status = BatchStatus::error;
  summary.take(result);

  CHECK(summary.planned() == 100);
  CHECK(summary.covered_percent(0) == 1.0);
  CHECK(summary.covered_percent(0.1) == 10.0);
  CHECK(summary.covered_percent(0.5) == 50.0);
  CHECK(summary.covered_percent(1) == 100.0);
  CHECK(summary.checked() == 90);
  CHECK(summary.check_failed() == 1);
  CHECK(summary.reasons() ==
        std::map<std::string, std::size_t>{{"error", 1}, {"gate", 1}, {"too narrow", 2}});
}

TEST_CASE("a batch tells which of its fields took long", "[batch]") {
  BatchSlow slow;
  BatchResult result;
  result.file = "a.gpkg";
  for (const double took_s : {0.1, 2.5, 7.0, 2.0, 3.0}) {
    ++result.number;
    slow.take(result, took_s);
  }
  CHECK(slow.fields == 3);
  REQUIRE(slow.slowest.size() == 5);
  CHECK(slow.slowest[0].took_s == 7.0);
  CHECK(slow.slowest[0].place == "a.gpkg, field 4");
  CHECK(slow.slowest[1].place == "a.gpkg, field 6");
  for (int i = 0; i < 20; ++i) slow.take(result, 5.0);
  CHECK(slow.slowest.size() == BatchSlow::kMostNamed);
  CHECK(slow.slowest[0].took_s == 7.0);
  CHECK(slow.fields == 23);

  const BatchScratch scratch;
  const BatchCount count = run_batch(small_batch(small_fields(scratch.at, 2), scratch.at / "out"), nobody());
  REQUIRE(count.slow.slowest.size() == 2);
  CHECK(count.slow.slowest[0].took_s > 0);
  CHECK(count.slow.slowest[0].place.find(", field ") != std::string::npos);
}

TEST_CASE("a batch writes the plan that selion plan writes", "[batch]") {
  const BatchScratch scratch;
  const fs::path file = small_fields(scratch.at, 2);
  const BatchOptions options = small_batch(file, scratch.at / "out");
  run_batch(options, nobody());
  const auto fields = read_fields(file, {}, std::cin);
  const auto plan = selion::plan(fields.at(1), options.job, Repair::notes_only, no_progress);
  REQUIRE(plan.has_value());
  CHECK(files_below(scratch.at / "out").at("plans/0000/2_field,_2.geojson") == to_geojson(plan->file));
}

TEST_CASE("a batch has the same bytes on any number of threads", "[batch]") {
  const BatchScratch scratch;
  const fs::path fields = small_fields(scratch.at, kFields);
  const auto one = batch_of_one_run(scratch, fields);
  BatchOptions options = small_batch(fields, scratch.at / "four");
  options.threads = 4;
  run_batch(options, nobody());
  CHECK(files_below(options.folder) == one);
}

TEST_CASE("a batch stopped after any field and resumed has the same bytes", "[batch]") {
  const BatchScratch scratch;
  const fs::path fields = small_fields(scratch.at, kFields);
  const auto whole = batch_of_one_run(scratch, fields);
  BatchOptions options = small_batch(fields, scratch.at / "stopped");
  options.earlier = Earlier::resume;
  std::size_t planned = 0;
  for (int run = 0; run <= kFields; ++run) {
    BatchWatch watch = nobody();
    bool one_done = false;
    watch.progress = [&](const BatchProgress&) { one_done = true, ++planned; };
    watch.stop = [&] { return one_done; };
    if (!run_batch(options, watch).stopped) break;
    CHECK_FALSE(files_below(options.folder).contains("results.csv"));
  }
  CHECK(planned == kFields);
  CHECK(files_below(options.folder) == whole);
}

TEST_CASE("a journal torn at any byte of its last lines is taken up", "[batch]") {
  const BatchScratch scratch;
  const fs::path fields = small_fields(scratch.at, 3);
  const auto whole = batch_of_one_run(scratch, fields);
  const fs::path journal = scratch.at / "whole/journal/1-of-1.jsonl";
  BatchOptions options = small_batch(fields, scratch.at / "whole");
  options.earlier = Earlier::resume;
  const std::size_t bytes = whole.at("journal/1-of-1.jsonl").size();
  for (std::size_t cut = 0; cut < 700 && cut <= bytes; cut += 9) {
    fs::resize_file(journal, bytes - cut);
    std::ofstream{journal, std::ios::app | std::ios::binary} << (cut % 2 == 0 ? "" : "\0torn");
    run_batch(options, nobody());
    CAPTURE(cut);
    REQUIRE(files_below(options.folder) == whole);
  }
}

TEST_CASE("a plan file that was lost is made again", "[batch]") {
  const BatchScratch scratch;
  const fs::path fields = small_fields(scratch.at, 3);
  const auto whole = batch_of_one_run(scratch, fields);
  BatchOptions options = small_batch(fields, scratch.at / "whole");
  options.earlier = Earlier::resume;
  fs::resize_file(options.folder / "plans/0000/1_field,_1.geojson", 10);
  fs::remove(options.folder / "plans/0000/2_field,_2.geojson");
  run_batch(options, nobody());
  CHECK(files_below(options.folder) == whole);
}

TEST_CASE("shards merged are the batch", "[batch]") {
  const BatchScratch scratch;
  const fs::path fields = small_fields(scratch.at, kFields);
  const auto whole = batch_of_one_run(scratch, fields);
  BatchOptions options = small_batch(fields, scratch.at / "shards");
  for (const int index : {2, 3}) {
    options.shard = {index, 3};
    CHECK_FALSE(run_batch(options, nobody()).tables);
  }
  CHECK_THROWS_WITH(merge_batch(options.folder, Earlier::refuse), Contains("not finished: 1;"));
  options.shard = {1, 3};
  run_batch(options, nobody());
  const BatchCount count = merge_batch(options.folder, Earlier::refuse);
  CHECK(count.total() == kFields);
  const auto merged = files_below(options.folder);
  for (const auto& [name, bytes] : whole) {
    CAPTURE(name);
    if (!name.starts_with("journal/")) CHECK((merged.contains(name) && merged.at(name) == bytes));
  }
  CHECK_THROWS_WITH(merge_batch(options.folder, Earlier::refuse), Contains("--overwrite"));
}

TEST_CASE("shards of another division or job do not mix", "[batch]") {
  const BatchScratch scratch;
  const fs::path fields = small_fields(scratch.at, 3);
  BatchOptions options = small_batch(fields, scratch.at / "out");
  options.shard = {1, 2};
  run_batch(options, nobody());
  options.shard = {1, 3};
  CHECK_THROWS_WITH(run_batch(options, nobody()), Contains("another division"));
  options.shard = {2, 2};
  options.job.layout.overlap_m = 0.25;
  run_batch(options, nobody());
  CHECK_THROWS_WITH(merge_batch(options.folder, Earlier::refuse), Contains("another job"));
}

TEST_CASE("a batch that runs is not cleared away for another division", "[batch]") {
  const BatchScratch scratch;
  const fs::path fields = small_fields(scratch.at, 4);
  BatchOptions options = small_batch(fields, scratch.at / "out");
  options.shard = {1, 2};
  run_batch(options, nobody());
  BatchOptions other = options;
  other.shard = {1, 3};
  other.earlier = Earlier::replace;
  std::string refused;
  BatchWatch watch = nobody();
  watch.progress = [&](const BatchProgress&) { refused = error_of([&] { run_batch(other, nobody()); }); };
  options.shard = {2, 2};
  run_batch(options, watch);
  CHECK_THAT(refused, Contains("2-of-2.jsonl is being written by another process: this shard runs already"));
  CHECK(merge_batch(options.folder, Earlier::refuse).total() == 4);
  CHECK(run_batch(other, nobody()).total() > 0);  // once it has ended
  CHECK_FALSE(fs::exists(options.folder / "journal/2-of-2.jsonl"));
}

TEST_CASE("a batch is resumed only as it was begun", "[batch]") {
  const BatchScratch scratch;
  const fs::path fields = small_fields(scratch.at, 2);
  BatchOptions options = small_batch(fields, scratch.at / "out");
  run_batch(options, nobody());
  CHECK_THROWS_WITH(run_batch(options, nobody()), Contains("--resume"));
  options.earlier = Earlier::resume;
  options.job.layout.overlap_m = 0.25;
  CHECK_THROWS_WITH(run_batch(options, nobody()), Contains("another job"));
  options.job.layout.overlap_m = 0;
  options.repair = Repair::accept;
  CHECK_THROWS_WITH(run_batch(options, nobody()), Contains("other options"));
  options.repair = Repair::notes_only;
  small_fields(scratch.at, 4);
  CHECK_THROWS_WITH(run_batch(options, nobody()), Contains("other fields"));
  options.earlier = Earlier::replace;
  CHECK(run_batch(options, nobody()).total() == 4);
}

TEST_CASE("a batch is not resumed where a file beside its fields was changed", "[batch]") {
  const auto [fields, beside] =
      GENERATE(std::pair{"a.shp", "a.dbf"}, std::pair{"a.shp", "a.DBF"}, std::pair{"a.gpkg", "a.gpkg-wal"},
               std::pair{"a.sqlite", "a.sqlite-wal"}, std::pair{"a.tab", "a.map"},
               std::pair{"a.TAB", "a.DAT"}, std::pair{"a.mif", "a.mid"}, std::pair{"a.gml", "a.gfs"});
  CAPTURE(fields, beside);
  const BatchScratch scratch;
  fs::create_directories(scratch.at / "in");
  small_fields(scratch.at / "in", 1);
  std::ofstream{scratch.at / "in" / fields} << "none that can be read: one result";
  std::ofstream{scratch.at / "in" / beside} << "before";
  BatchOptions options = small_batch(scratch.at / "in", scratch.at / "out");
  CHECK(run_batch(options, nobody()).total() == 2);
  options.earlier = Earlier::resume;
  CHECK(run_batch(options, nobody()).total() == 2);
  std::ofstream{scratch.at / "in" / beside} << "after";
  CHECK_THROWS_WITH(run_batch(options, nobody()), Contains("other fields"));
}

TEST_CASE("a file of a folder that cannot be read is one result", "[batch]") {
  const BatchScratch scratch;
  fs::create_directories(scratch.at / "in/below");
  small_fields(scratch.at / "in/below", 2);
  std::ofstream{scratch.at / "in/a.geojson"} << "{\"type\": \"Feat";
  std::ofstream{scratch.at / "in/notes.md"} << "no field file";
  fs::create_directories(scratch.at / "in/.hidden");
  small_fields(scratch.at / "in/.hidden", 2);
  // the batch's own folder may lie among the fields
  BatchOptions options = small_batch(scratch.at / "in", scratch.at / "in/out");
  CHECK(run_batch(options, nobody()).total() == 3);
  options.earlier = Earlier::resume;
  CHECK(run_batch(options, nobody()).total() == 3);
  const std::string table = files_below(options.folder).at("results.csv");
  CHECK_THAT(table, Contains("\n1,a.geojson,,,a.geojson,error,"));
  CHECK_THAT(table, Contains("\n2,below/small.geojson,,1,\"field, 1\",done,"));
}

TEST_CASE("a batch writes into no folder that it reads", "[batch]") {
  const BatchScratch scratch;
  fs::create_directories(scratch.at / "in");
  small_fields(scratch.at / "in", 2);
  const auto before = files_below(scratch.at / "in");
  CHECK_THROWS_WITH(run_batch(small_batch(scratch.at / "in", scratch.at / "in/../in"), nobody()),
                    Contains("is to be read and written to"));
  CHECK(files_below(scratch.at / "in") == before);
}

TEST_CASE("a batch of one file that cannot be read begins nothing", "[batch]") {
  const BatchScratch scratch;
  std::ofstream{scratch.at / "a.geojson"} << "{\"type\": \"Feat";
  CHECK_THROWS_AS(run_batch(small_batch(scratch.at / "a.geojson", scratch.at / "out"), nobody()), InputError);
  CHECK_FALSE(fs::exists(scratch.at / "out"));
}

TEST_CASE("fields read one after another are the fields of the file", "[batch][field]") {
  const std::string folder = (data_dir() / "fields/").string();
  for (const char* name : {"f1.geojson", "f1.zip", "gates_obstacles.geojson", "with_pond.geojson"}) {
    CAPTURE(name);
    const auto all = read_fields(folder + name, {}, std::cin);
    FieldStream stream{folder + name, {}};
    CHECK(stream.size() == all.size());
    for (const Field& field : all) {
      const auto next = stream.next();
      REQUIRE(next.has_value());
      CHECK(next->name == field.name);
      CHECK(stream.field() == field);
    }
    CHECK_FALSE(stream.next().has_value());
  }
}

TEST_CASE("fields of a large GeoPackage read one after another are those of the file", "[batch][field]") {
  const fs::path file = shared_dir() / "fields/batch/fields_batch.gpkg";
  if (!fs::exists(file)) {
    std::cout << "skipped: " << file << " is not there\n";
    return;
  }
  ReadOptions options;
  options.layer = "nl_waterland_brp2020";
  const auto all = read_fields(file, options, std::cin);
  FieldStream stream{file, options};
  REQUIRE(stream.size() == all.size());
  std::size_t same = 0;
  for (const Field& field : all) same += stream.next() && stream.field() == field ? 1 : 0;
  CHECK(same == all.size());
}
