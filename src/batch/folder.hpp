// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "selion/batch/journal.hpp"
#include "selion/batch/run.hpp"

namespace selion {

// The folder of a batch:
//   plans/0001/1042_Long_acre.geojson   and, where maps are drawn, maps/0001/1042_Long_acre.svg and .pdf
//   journal/2-of-8.jsonl                what each shard has done
//   journal/2-of-8.part/                where its files are written before they are renamed
//   results.csv, results.gpkg

std::filesystem::path journal_file(const std::filesystem::path& folder, const Shard& shard);

/// "0001/1042_Long_acre": no folder has more than a thousand fields.
std::string place_of(std::size_t number, const std::string& name);

/// A file that is written under another name and gets its own when it is whole.
/// @throws InputError naming the file and why it cannot be written.
void write_beside(const std::filesystem::path& beside, const std::filesystem::path& file,
                  std::string_view bytes);
/// The same for a file that is written already.
void put_in_place(const std::filesystem::path& beside, const std::filesystem::path& file);
/// @throws InputError
void make_folder(const std::filesystem::path& folder);

/// An open file of the system's.
class FileHandle {
 public:
  FileHandle() = default;
  explicit FileHandle(int number) : number_{number} {}
  FileHandle(const FileHandle&) = delete;
  FileHandle& operator=(const FileHandle&) = delete;
  FileHandle(FileHandle&& other) noexcept : number_{std::exchange(other.number_, -1)} {}
  FileHandle& operator=(FileHandle&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~FileHandle();

  [[nodiscard]] int number() const { return number_; }  ///< below 0: none is open

 private:
  int number_ = -1;
};

/// A shard's journal, held by this process alone.
class ShardJournal {
 public:
  /// Opens, locks and clears away as `earlier` says. @throws InputError where an earlier batch is in the way.
  ShardJournal(std::filesystem::path folder, const BatchIdentity& identity, const Shard& shard,
               Earlier earlier);
  ShardJournal(const ShardJournal&) = delete;
  ShardJournal& operator=(const ShardJournal&) = delete;
  ShardJournal(ShardJournal&&) = delete;
  ShardJournal& operator=(ShardJournal&&) = delete;
  ~ShardJournal();

  [[nodiscard]] const std::unordered_map<std::size_t, BatchStatus>& results() const { return done_; }
  /// How many of each status.
  [[nodiscard]] std::array<std::size_t, kBatchStatusNames.size()> counts() const;
  /// Fields in the whole batch, where all of this shard have their result.
  [[nodiscard]] std::optional<std::size_t> numbers() const { return numbers_; }
  /// Where this shard's files are written before they are renamed.
  [[nodiscard]] const std::filesystem::path& part_folder() const { return part_; }

  /// A result whose files are in place.
  void add(const BatchResult& result);
  /// All fields have theirs: brings the lines into the order of the fields, so that a journal has the same
  /// bytes however often its process was stopped.
  void finish(std::size_t numbers);
  /// What was added is on the disk after it.
  void flush();

 private:
  void open();
  void refuse_earlier(const JournalIndex& index) const;
  void clear_other_divisions(Earlier earlier) const;
  void take_up(const JournalIndex& index);
  void append(std::string_view line);

  std::filesystem::path folder_;
  Shard shard_;
  std::filesystem::path file_;
  std::filesystem::path part_;
  FileHandle handle_;
  std::unordered_map<std::size_t, BatchStatus> done_;
  std::optional<std::size_t> numbers_;
  std::vector<std::filesystem::path> unflushed_;
};

}  // namespace selion
