// SPDX-License-Identifier: GPL-3.0-or-later
#include "merge.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <string>

#include "folder.hpp"
#include "selion/batch/journal.hpp"
#include "selion/core/error.hpp"
#include "table.hpp"

namespace selion {
namespace {

namespace fs = std::filesystem;

/// Where a result stands.
struct Place {
  JournalIndex::Line line;
  std::size_t journal = 0;
};

struct Shards {
  std::vector<fs::path> journals;
  std::vector<JournalIndex> indexes;
};

Shards shards_in(const fs::path& folder) {
  Shards shards;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder / "journal", none})
    if (entry.path().extension() == ".jsonl") shards.journals.push_back(entry.path());
  std::ranges::sort(shards.journals);
  for (const fs::path& journal : shards.journals)
    shards.indexes.push_back(read_journal(journal, [](const BatchResult&) {}));
  return shards;
}

std::string listed(const std::vector<int>& numbers) {
  constexpr std::size_t kShown = 20;
  std::string text;
  for (std::size_t i = 0; i < numbers.size() && i < kShown; ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  return text + (numbers.size() > kShown ? " and more" : "");
}

/// @throws InputError unless all shards of one batch are there, each with its end.
void check(const Shards& shards, const fs::path& folder) {
  if (shards.journals.empty())
    throw InputError{folder.string() + " holds no batch; name its folder with -o DIR"};
  const auto begun = std::ranges::find_if(
      shards.indexes, [](const JournalIndex& index) { return index.identity.has_value(); });
  if (begun == shards.indexes.end()) throw InputError{folder.string() + ": no shard has begun its journal"};
  std::map<int, bool> complete;
  for (std::size_t i = 0; i < shards.indexes.size(); ++i) {
    const JournalIndex& index = shards.indexes[i];
    if (!index.identity) continue;
    const std::string why = index.shard.count == begun->shard.count
                                ? difference(*begun->identity, *index.identity)
                                : "is of another division";
    if (!why.empty())
      throw InputError{shards.journals[i].string() + " does not belong to the others: the batch " + why};
    complete[index.shard.index] = index.numbers.has_value();
  }
  std::vector<int> missing;
  for (int i = 1; i <= begun->shard.count; ++i)
    if (!complete[i]) missing.push_back(i);
  if (!missing.empty())
    throw InputError{folder.string() + ": of " + std::to_string(begun->shard.count) +
                     " shards these are not finished: " + listed(missing) +
                     "; run them with --resume, then merge"};
}

std::vector<Place> places_of(const std::vector<JournalIndex>& indexes) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < indexes.size(); ++i)
    for (const JournalIndex::Line& line : indexes[i].lines) places.push_back({line, i});
  std::ranges::stable_sort(places, {}, [](const Place& place) { return place.line.number; });
  return places;
}

BatchCount tables_of(const fs::path& folder, const Shards& shards, const fs::path& part_folder) {
  const std::vector<Place> places = places_of(shards.indexes);
  std::vector<std::ifstream> journals;
  for (const fs::path& journal : shards.journals) journals.emplace_back(journal, std::ios::binary);
  BatchCount count;
  count.numbers = places.size();
  write_tables(folder, part_folder, [&](const std::function<void(const BatchResult&)>& take) {
    std::string line;
    for (const Place& place : places) {
      std::ifstream& journal = journals[place.journal];
      line.resize(place.line.bytes);
      journal.seekg(static_cast<std::streamoff>(place.line.offset));
      journal.read(line.data(), static_cast<std::streamsize>(line.size()));
      const BatchResult result = result_of_line(line);
      ++count.by_status.at(static_cast<std::size_t>(result.status));
      count.summary.take(result);
      take(result);
    }
  });
  count.tables = true;
  return count;
}

/// A folder that is gone at the end, whatever happens.
class PartFolder {
 public:
  explicit PartFolder(fs::path path) : path_{std::move(path)} { make_folder(path_); }
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;
  PartFolder(PartFolder&&) = delete;
  PartFolder& operator=(PartFolder&&) = delete;
  ~PartFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

BatchCount write_tables_of(const fs::path& folder, const std::vector<fs::path>& journals,
                           const fs::path& part_folder) {
  Shards shards{journals, {}};
  for (const fs::path& journal : journals)
    shards.indexes.push_back(read_journal(journal, [](const BatchResult&) {}));
  return tables_of(folder, shards, part_folder);
}

BatchCount merge_batch(const fs::path& folder, Earlier tables) {
  const Shards shards = shards_in(folder);
  check(shards, folder);
  for (const std::string_view table : kBatchTables)
    if (std::error_code ignored; tables == Earlier::refuse && fs::exists(folder / table, ignored))
      throw InputError{(folder / table).string() + ": exists; give --overwrite to replace it"};
  const PartFolder part{folder / "journal" / "merge.part"};
  return tables_of(folder, shards, part.path());
}

}  // namespace selion
