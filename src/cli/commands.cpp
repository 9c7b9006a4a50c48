// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "selion/core/error.hpp"
#include "selion/plan/suggest.hpp"

namespace selion::cli {
namespace {

constexpr auto kCommands = std::to_array<Command>({
    {"plan", "FIELD... -o DIR", "plan fields: a map to print, paths to drive, a report",
     "  selion plan home.shp -o out\n"
     "  selion plan home.kml -o out --machine tractor-6m --operation spraying\n"
     "  selion plan farm.gpkg -o out --field 'Long acre' --direction 12.5\n"
     "A job to keep: print it, change it, use it.\n"
     "  selion plan --machine tractor-6m --working-width 9 --print-job > job.toml\n"
     "  selion plan farm.gpkg -o out --job job.toml --overwrite\n",
     setup_plan},
    {"batch", "FIELDS -o DIR", "plan thousands of fields, in parallel, resumable, in shards",
     "  selion batch province.gpkg -o out\n"
     "  selion batch province.gpkg -o out --resume\n"
     "  selion batch province.gpkg -o out --shard 3/8\n"
     "  selion batch --merge -o out\n",
     setup_batch},
    {"inspect", "FILE", "show what is in a field file or a plan, and what is wrong with it",
     "  selion inspect farm.gpkg\n"
     "  selion inspect out/plan.geojson --json\n",
     setup_inspect},
    {"verify", "PLAN [FIELD]", "check a plan independently: what is wrong, and where",
     "  selion verify out/plan.geojson\n"
     "  selion verify out/plan.geojson home.shp --json\n",
     setup_verify},
    {"help", "[COMMAND]", "explain selion, or one of its commands", "  selion help plan\n", setup_help},
});

constexpr auto kLater =
    std::to_array<std::string_view>({"compare", "simulate", "targets", "export", "study"});

}  // namespace

std::span<const Command> commands() { return kCommands; }

const Command& command_named(std::string_view name) {
  const auto found = std::ranges::find(kCommands, name, &Command::name);
  if (found != kCommands.end()) return *found;
  std::vector<std::string_view> names;
  names.reserve(kCommands.size());
  for (const Command& command : kCommands) names.push_back(command.name);
  const std::string there_is = "there is " + spoken_list(names);
  if (std::ranges::find(kLater, name) != kLater.end())
    throw InputError{"the command '" + std::string{name} + "' is not in this version; " + there_is};
  throw InputError{"no command '" + std::string{name} + "'; " + there_is + did_you_mean(name, names)};
}

}  // namespace selion::cli
