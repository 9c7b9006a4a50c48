// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "files.hpp"
#include "selion/core/error.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/suggest.hpp"

using namespace selion;
using Catch::Contains;

namespace {

Job job_from(const std::string& toml) { return job_of(settings_of_toml(toml, "job.toml")); }

JobSetting flag(const std::string& full, const std::string& text) {
  const JobKey& key = job_key(full);
  return {&key, value_of_text(key, text), std::string{key.flag}};
}

std::string message_of(const auto& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const std::string& toml) {
  return message_of([&] { job_from(toml); });
}

/// A value that differs from the default and is allowed, as a flag's text.
std::string other_value(const JobKey& key) {
  if (key.name == "max_speed_mps") return "4.5";  // not below the other speeds
  if (key.name == "overlap_m") return "0.25";
  if (key.name == "ab") return "3.43,46.33,3.44,46.34";
  if (key.name == "start") return "gate:2";
  if (key.name == "crs") return "EPSG:2154";
  if (key.name == "direction") return "77.5";
  if (key.name == "tramlines" || key.name == "overhang_m") return "0";
  const JobValue usual = key.get(Job{});
  if (key.type == JobType::truth) return std::get<bool>(usual) ? "false" : "true";
  if (key.type == JobType::count) return "3";
  if (key.type == JobType::number) return std::holds_alternative<Absent>(usual) ? "1.25" : "0.875";
  return std::string{split_at_bars(key.choices).back()};
}

}  // namespace

TEST_CASE("a job without settings is the struct's defaults", "[plan]") { CHECK(job_of({}) == Job{}); }

TEST_CASE("a flag is the key's last part without its unit", "[plan]") {
  std::set<std::string_view> flags;
  for (const JobKey& key : job_keys()) {
    CAPTURE(full_name(key));
    CHECK(flags.insert(key.flag).second);
    CHECK_FALSE(key.help.empty());
    std::string name{key.name};
    for (const char* unit : {"_deg_s", "_mps2", "_mps", "_deg", "_kg", "_m", "_s"})
      if (name.ends_with(unit)) {
        name.resize(name.size() - std::string{unit}.size());
        break;
      }
    std::ranges::replace(name, '_', '-');
    const bool renamed = name == "kind" || name == "preset" || name == "crs" || name == "order";
    if (!renamed) CHECK(key.flag == "--" + name);
  }
}

TEST_CASE("a job printed, read and printed again is the same bytes", "[plan]") {
  JobSettings settings;
  for (const JobKey& key : job_keys())
    settings.push_back({&key, value_of_text(key, other_value(key)), "test"});
  const auto name = GENERATE(0, 1, 2, 3, 4, 5, 6);
  if (name < 6)
    settings.assign(
        1, flag("machine.preset", std::string{machine_presets()[static_cast<std::size_t>(name)].name}));
  const Job job = job_of(settings);

  const std::string printed = job_toml(job);
  const Job again = job_from(printed);

  CHECK(job_toml(again) == printed);
  CHECK(again == job);
  CHECK(job_json(again) == job_json(job));
  for (const JobKey& key : job_keys())
    CHECK_THAT(printed, Contains("\n" + std::string{key.name} + " = ") ||
                            Catch::StartsWith(std::string{key.name} + " = "));
}

TEST_CASE("each key can be set by flag and file alike", "[plan]") {
  for (const JobKey& key : job_keys()) {
    CAPTURE(full_name(key));
    const std::string text = other_value(key);
    const JobValue value = value_of_text(key, text);
    const std::string table = key.table.empty() ? "" : "[" + std::string{key.table} + "]\n";
    const Job by_file = job_from(table + std::string{key.name} + " = " + text_of_value(key, value));
    Job by_flag = job_of(JobSettings{{&key, value, "test"}});
    CHECK(by_file == by_flag);
    const bool can_differ = text != "0" && split_at_bars(key.choices).size() != 1;
    if (can_differ) CHECK_FALSE(job_toml(by_flag) == job_toml(Job{}));
    const JobValue held = key.get(by_flag);
    if (key.type != JobType::heading) CHECK(held == value);
  }
}

TEST_CASE("no key takes a value of another type", "[plan]") {
  for (const JobKey& key : job_keys()) {
    CAPTURE(full_name(key));
    CHECK_THROWS_AS(fitted(key, std::vector<double>{1, 2, 3}), InputError);
    if (key.type == JobType::text) CHECK_THROWS_AS(fitted(key, 3.0), InputError);
    if (key.type != JobType::text) CHECK_THROWS_AS(fitted(key, std::string{"bananas"}), InputError);
    if (key.type != JobType::truth) CHECK_THROWS_AS(fitted(key, true), InputError);
    if (key.type == JobType::number)
      CHECK_THROWS_AS(fitted(key, std::numeric_limits<double>::quiet_NaN()), InputError);
    if (key.type == JobType::count) CHECK_THROWS_AS(fitted(key, 2.5), InputError);
    for (std::string_view choice : split_at_bars(key.later))
      CHECK_THROWS_WITH(value_of_text(key, choice), Contains("not supported yet; there is"));
  }
}

TEST_CASE("numbers far out of range are refused with the range and the place", "[plan]") {
  for (const JobKey& key : job_keys()) {
    if (key.type != JobType::number && key.type != JobType::count && key.type != JobType::heading) continue;
    const std::string table = "[" + std::string{key.table} + "]\n" + std::string{key.name} + " = ";
    const std::string message = refusal(table + "1e9");
    CAPTURE(full_name(key), message);
    if (key.type == JobType::count) {
      CHECK_THAT(message, Contains("not a whole number"));
    } else {
      CHECK_THAT(message, Contains("job.toml:2:1: " + full_name(key) + " = 1000000000 is out of range: "));
      CHECK_THAT(refusal(table + "-1e9"), Contains("is out of range"));
    }
  }
}

TEST_CASE("whole numbers that no double holds exactly are out of range like others", "[plan]") {
  CHECK_THAT(refusal("[headland]\npasses = 444444444444444442"), Contains("job.toml:2:1"));
  CHECK_THAT(refusal("[machine]\nworking_width_m = 9223372036854775807"), Contains("job.toml:2:1"));
  CHECK_THAT(refusal("[layout]\nab = [9007199254740993, 50, 10, 50]"), Contains("job.toml:2:1"));
}

TEST_CASE("a preset brings its margins, and the job's own win", "[plan]") {
  CHECK(job_from("[machine]\npreset = 'p3'").field.edge_margin_m == 0.05);
  CHECK(job_from("[machine]\npreset = 'p3'\n[field]\nedge_margin_m = 0.2").field.edge_margin_m == 0.2);
  CHECK(job_from("[machine]\npreset = 'p3'\nworking_width_m = 4").machine.working_width_m == 4);
  CHECK(job_from("[machine]\npreset = 'p3'").machine_assumed == false);
  CHECK(job_from("[machine]\nworking_width_m = 4").machine_assumed);
}

TEST_CASE("the operation sets when the headland is worked, unless the job does", "[plan]") {
  CHECK(job_from("operation = 'tillage'").headland.order == HeadlandOrder::last);
  CHECK(job_from("operation = 'spraying'").headland.order == HeadlandOrder::first);
  CHECK(job_from("operation = 'scouting'").headland.order == HeadlandOrder::none);
  CHECK(job_from("operation = 'harvest'\n[headland]\norder = 'last'").headland.order == HeadlandOrder::last);
}

TEST_CASE("corners of headland passes are rounded unless the job fills them", "[plan]") {
  CHECK(job_from("").headland.corners == HeadlandCorners::round);
  CHECK(job_from("[headland]\ncorners = 'fill'").headland.corners == HeadlandCorners::fill);
  CHECK(job_of(JobSettings{flag("headland.corners", "fill")}).headland.corners == HeadlandCorners::fill);
  CHECK_THAT(refusal("[headland]\ncorners = 'fil'"), Contains("job.toml:2:1: headland.corners = 'fil'") &&
                                                         Contains("round or fill") &&
                                                         Contains("did you mean 'fill'?"));
}

TEST_CASE("of two values for a key the later one wins", "[plan]") {
  JobSettings settings = settings_of_toml("[machine]\nworking_width_m = 6", "job.toml");
  settings.push_back(flag("machine.working_width_m", "4"));
  CHECK(job_of(settings).machine.working_width_m == 4);
}

TEST_CASE("an unknown key names its place and the nearest one", "[plan]") {
  CHECK(refusal("[machine]\n  working_widht_m = 4") ==
        "job.toml:2:3: unknown key 'working_widht_m' in [machine]; did you mean 'working_width_m'?");
  CHECK(refusal("working_width_m = 4") ==
        "job.toml:1:1: unknown key 'working_width_m'; it belongs in [machine]");
  CHECK_THAT(refusal("[machin]\nfront_m = 1"), Contains("unknown key 'machin'; did you mean 'machine'?"));
  CHECK_THAT(refusal("[layout]\noperation = 'seeding'"), Contains("it belongs at the top of the file"));
  CHECK_THAT(refusal("zebra = 1"), Catch::EndsWith("unknown key 'zebra'"));
  CHECK_THAT(refusal("[layout.ab]\nlon = 1"), Contains("job.toml:1"));
  CHECK_THAT(refusal("machine = 3"), Contains("write [machine]"));
}

TEST_CASE("an unknown value names what there is and the nearest", "[plan]") {
  CHECK_THAT(refusal("[machine]\npreset = 'tractor-9m'"), Contains("did you mean 'tractor-6m'?"));
  CHECK_THAT(refusal("[output]\npaper = 'a4'"), Contains("there is A4, A3 or letter; did you mean 'A4'?"));
  CHECK_THAT(refusal("operation = 'sedding'"), Contains("did you mean 'seeding'?"));
  CHECK_THAT(refusal("[layout]\ndirection = 'egde'"), Contains("did you mean 'edge'?"));
}

TEST_CASE("what a later version will do is refused as such", "[plan]") {
  CHECK_THAT(refusal("[[fleet]]\ncount = 2"), Contains("job.toml:1:3: [[fleet]] is not supported yet"));
  CHECK_THAT(refusal("[layout]\nkind = 'spiral'"), Contains("not supported yet; there is linear"));
  CHECK_THAT(refusal("[layout]\ndirection = 'cost'"),
             Contains("not supported yet; there is edge, p3 or a compass heading"));
  CHECK_THAT(refusal("[layout]\ntramlines = 2"), Contains("not supported yet; there is only 0"));
  CHECK_THAT(refusal("[route]\norder = 'lands'"), Contains("not supported yet; there is adjacent"));
  CHECK_THAT(refusal("[field]\noverhang_m = 1"), Contains("not supported yet"));
}

TEST_CASE("broken TOML names line and column", "[plan]") {
  CHECK_THAT(refusal("operation = \"seeding\"\n[machine\nfront_m = 1"), Catch::StartsWith("job.toml:2:9: "));
  CHECK_THAT(refusal("operation = seeding"), Catch::StartsWith("job.toml:1:"));
  CHECK_THAT(refusal("[machine]\nfront_m = 1\nfront_m = 2"), Catch::StartsWith("job.toml:3:"));
  CHECK_THAT(refusal("[machine]\nfront_m = 1979-05-27"), Contains("job.toml:2:1: neither a number"));
  CHECK_THAT(refusal("[machine]\nfront_m = nan"), Contains("machine.front_m = a number that is not finite"));
}

TEST_CASE("an AB line needs two places on earth", "[plan]") {
  CHECK(job_from("[layout]\nab = []").layout.ab == std::nullopt);
  CHECK(job_from("[layout]\nab = [3, 46, 3.1, 46.1]").layout.ab == std::array<double, 4>{3, 46, 3.1, 46.1});
  CHECK_THAT(refusal("[layout]\nab = [3, 46, 3.1]"), Contains("needs four numbers"));
  CHECK_THAT(refusal("[layout]\nab = [3, 96, 3.1, 46]"), Contains("layout.ab = 96 is no latitude"));
  CHECK_THAT(refusal("[layout]\nab = [3, 46, 3, 46]"), Contains("the same place"));
  CHECK_THAT(refusal("[layout]\nab = [3, '46', 3, 46]"),
             Contains("job.toml:2:1: the list may hold numbers only"));
}

TEST_CASE("frame and gate are written in one way", "[plan]") {
  CHECK_THAT(refusal("[frame]\ncrs = 'epsg2154'"), Contains("'EPSG:2154'"));
  CHECK_THAT(refusal("[route]\nstart = 'gate'"), Contains("'gate:1'"));
  CHECK(job_from("[route]\nstart = 'gate:12'").route.start == "gate:12");
}

TEST_CASE("a machine file holds its keys with or without the table", "[plan]") {
  const Job bare = job_of(settings_of_machine_toml("working_width_m = 9\npreset = 'tractor-12m'", "m.toml"));
  CHECK(bare ==
        job_of(settings_of_machine_toml("[machine]\nworking_width_m = 9\npreset = 'tractor-12m'", "m.toml")));
  CHECK(bare.machine.working_width_m == 9);
  CHECK(bare.machine.mass_kg == 14000);
  CHECK_FALSE(job_of(settings_of_machine_toml("working_width_m = 9", "m.toml")).machine_assumed);
  CHECK_THROWS_WITH(settings_of_machine_toml("[machine]\nfront_m = 1\n[layout]\nab = []", "m.toml"),
                    Contains("--job"));
  CHECK_THROWS_WITH(settings_of_machine_toml("edge_margin_m = 1", "m.toml"),
                    Contains("it belongs in [field]"));
}

TEST_CASE("flags of the wrong kind say what is right", "[plan]") {
  CHECK_THROWS_WITH(flag("machine.working_width_m", "3,5"), Contains("decimals follow a point"));
  CHECK_THROWS_WITH(flag("machine.working_width_m", "4m"),
                    Contains("machine.working_width_m = '4m': not a number (m)"));
  CHECK_THROWS_WITH(flag("machine.may_reverse", "perhaps"), Contains("neither true nor false"));
  CHECK_THROWS_WITH(flag("headland.passes", "many"), Contains("not a whole number or 'auto'"));
  CHECK_THROWS_WITH(flag("layout.ab", "3,46,x,47"), Contains("needs four numbers"));
}

TEST_CASE("the distance between words counts letters and swaps", "[plan]") {
  CHECK(edit_distance("width", "width") == 0);
  CHECK(edit_distance("widht", "width") == 1);
  CHECK(edit_distance("with", "width") == 1);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("a job's JSON has no spaces and holds the machine in full", "[plan]") {
  const std::string json = job_json(job_from("[layout]\nab = [3, 46, 3.1, 46.1]\ndirection = 12.5"));
  CHECK_THAT(json, Catch::StartsWith("{\"operation\":\"seeding\",\"machine\":{\"preset\":\"robot-3m\","
                                     "\"kind\":\"car\",\"working_width_m\":3,"));
  CHECK_THAT(json, Contains("\"direction\":12.5,\"ab\":[3,46,3.1,46.1],"));
  CHECK_THAT(json, Catch::EndsWith("\"output\":{\"units\":\"metric\",\"paper\":\"A4\"}}"));
  CHECK(json.find(' ') == std::string::npos);
}

TEST_CASE("docs/job.md has each key with its flag, unit, default and meaning, and no other", "[plan]") {
  std::ifstream stream{project_dir() / "docs/job.md"};
  const std::string page{std::istreambuf_iterator<char>{stream}, {}};
  for (const JobKey& key : job_keys()) {
    const std::string unit = key.unit.empty() ? "" : std::string{key.unit} + " ";
    const std::string row = "| `" + std::string{key.name} + "` | `" + std::string{key.flag} + "` | " + unit +
                            "| `" + text_of_value(key, key.get(Job{})) + "` | " + std::string{key.help} +
                            " |";
    CHECK_THAT(page, Contains("\n" + row + "\n"));
  }
  std::size_t rows = 0;
  for (std::size_t at = page.find("\n| `"); at != std::string::npos; at = page.find("\n| `", at + 1))
    if (page.find("` | `--", at) < page.find('\n', at + 1)) ++rows;
  CHECK(rows == job_keys().size());
}
