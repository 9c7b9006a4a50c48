// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "selion/batch/result.hpp"
#include "selion/batch/shard.hpp"

namespace selion {

/// What a batch was begun with. Results of two batches may stand together only where all of it is the same.
struct BatchIdentity {
  std::string version;  ///< of selion
  std::string input;    ///< a hash of the files' bytes
  std::string job;      ///< a hash of the effective job
  std::string options;  ///< a hash of how files are read and what is written

  friend bool operator==(const BatchIdentity&, const BatchIdentity&) = default;
};

/// A line of a journal as it stands, its end included.
std::string journal_header(const BatchIdentity& identity, const Shard& shard);
std::string journal_line(const BatchResult& result);
/// The last line: all fields of the shard have a result, and there are `numbers` in the whole batch.
std::string journal_end(std::size_t numbers);

/// What a journal holds. A process may have been killed while it wrote, or the machine lost its power: a
/// journal counts up to its first line that is not whole.
struct JournalIndex {
  struct Line {
    std::size_t number = 0;
    std::uint64_t offset = 0;
    std::uint32_t bytes = 0;
  };
  std::optional<BatchIdentity> identity;  ///< absent where not even the header was written
  Shard shard;
  std::vector<Line> lines;             ///< of results, in the order of the file
  std::optional<std::size_t> numbers;  ///< in the whole batch, where the journal has its end
  std::uint64_t good_bytes = 0;        ///< what follows is no use
};

/// Reads a journal; `each` is told every result. A file that is not there is an empty journal.
/// @throws InputError where it cannot be read.
JournalIndex read_journal(const std::filesystem::path& file,
                          const std::function<void(const BatchResult&)>& each);

/// The result on one line. @throws InputError where it is none.
BatchResult result_of_line(std::string_view line);

/// Why a batch may not go on in `folder`; empty where it may.
std::string difference(const BatchIdentity& begun, const BatchIdentity& now);

}  // namespace selion
