// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <map>
#include <string>

#include "selion/batch/shard.hpp"
#include "selion/core/error.hpp"

using namespace selion;
using Catch::Contains;

namespace {

Environment environment(std::map<std::string, std::string> variables) {
  return [variables = std::move(variables)](const std::string& name) -> std::optional<std::string> {
    const auto found = variables.find(name);
    if (found == variables.end()) return std::nullopt;
    return found->second;
  };
}

const Environment kNone = environment({});

}  // namespace

TEST_CASE("every field belongs to exactly one of the shards", "[batch]") {
  for (int count = 1; count <= 7; ++count)
    for (std::size_t number = 1; number <= 30; ++number) {
      int owners = 0;
      for (int index = 1; index <= count; ++index) owners += Shard{index, count}.has(number) ? 1 : 0;
      CAPTURE(count, number);
      CHECK(owners == 1);
    }
}

TEST_CASE("a share is written I/N", "[batch]") {
  CHECK(shard_of("3/8", kNone) == Shard{3, 8});
  CHECK(name_of(Shard{3, 8}) == "3-of-8");
  for (const char* text : {"", "3", "3/", "/8", "3/8/9", "x/8", "3/-1", "3 /8", "auto/x"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(shard_of(text, kNone), InputError);
  }
  CHECK_THROWS_WITH(shard_of("9/8", kNone), Contains("no share 9 of 8"));
  CHECK_THROWS_WITH(shard_of("0/8", kNone), Contains("count from 1"));
}

TEST_CASE("a scheduler's task knows its share", "[batch]") {
  const auto slurm = environment({{"SLURM_ARRAY_TASK_ID", "7"},
                                  {"SLURM_ARRAY_TASK_MIN", "1"},
                                  {"SLURM_ARRAY_TASK_MAX", "16"},
                                  {"SLURM_ARRAY_TASK_STEP", "2"}});
  CHECK(shard_of("auto", slurm) == Shard{4, 8});
  CHECK(shard_of("auto", environment({{"SGE_TASK_ID", "2"},
                                      {"SGE_TASK_FIRST", "1"},
                                      {"SGE_TASK_LAST", "4"},
                                      {"SGE_TASK_STEPSIZE", "1"}})) == Shard{2, 4});
  CHECK(shard_of("auto", environment({{"LSB_JOBINDEX", "5"}, {"LSB_JOBINDEX_END", "6"}})) == Shard{5, 6});
  CHECK(shard_of("auto", environment({{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "3"}})) ==
        Shard{1, 3});
  CHECK(shard_of("auto/5", environment({{"PBS_ARRAY_INDEX", "5"}})) == Shard{5, 5});
  // one task of eight submitted again
  CHECK(shard_of("auto/8", environment({{"SLURM_ARRAY_TASK_ID", "3"},
                                        {"SLURM_ARRAY_TASK_MIN", "3"},
                                        {"SLURM_ARRAY_TASK_MAX", "3"}})) == Shard{3, 8});
  CHECK_THROWS_WITH(shard_of("auto/8", environment({{"SLURM_ARRAY_TASK_ID", "0"}})),
                    Contains("count from 1"));
  CHECK_THROWS_WITH(shard_of("auto", environment({{"PBS_ARRAY_INDEX", "5"}})), Contains("auto/N"));
  CHECK_THROWS_WITH(shard_of("auto", kNone), Contains("no scheduler"));
  CHECK_THROWS_WITH(shard_of("auto", environment({{"SGE_TASK_ID", "undefined"}})), Contains("no scheduler"));
}
