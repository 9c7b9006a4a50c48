// SPDX-License-Identifier: GPL-3.0-or-later
#include "folder.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "selion/core/error.hpp"
#include "selion/output/file_name.hpp"

namespace selion {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFieldsAFolder = 1000;
constexpr std::size_t kFlushAfter = 64;  // results: what a loss of power, not a killed process, may undo

[[noreturn]] void fail(const fs::path& what, const std::string& action, int error) {
  throw InputError{what.string() + ": cannot be " + action + ": " + std::generic_category().message(error)};
}

/// 0, or the error that kept some of the bytes out.
int write_all(int handle, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(handle, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

void flush_file(const fs::path& file) {
  const FileHandle handle{::open(file.c_str(), O_RDONLY | O_CLOEXEC)};
  if (handle.number() < 0) return;  // it was written, and then taken away by somebody else
  if (::fsync(handle.number()) != 0 && errno != EINVAL && errno != EROFS) fail(file, "written", errno);
}

void remove_plan(const fs::path& folder, const BatchResult& result) {
  if (result.plan.empty()) return;
  std::error_code ignored;  // it may never have been there
  fs::remove(folder / result.plan, ignored);
  const std::string place = place_of(result.number, result.name);
  for (const char* ending : {".svg", ".pdf"}) fs::remove(folder / "maps" / (place + ending), ignored);
}

/// Held by this process alone until the handle is gone.
FileHandle locked(const fs::path& journal) {
  FileHandle handle{::open(journal.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)};
  if (handle.number() < 0) fail(journal, "written", errno);
  if (::flock(handle.number(), LOCK_EX | LOCK_NB) == 0) return handle;
  const int error = errno;
  if (error == EWOULDBLOCK)
    throw InputError{journal.string() + " is being written by another process: this shard runs already"};
  fail(journal, "locked", error);
}

bool is_of_division(const fs::path& journal, const Shard& shard) {
  return journal.filename().string().ends_with("-of-" + std::to_string(shard.count) + ".jsonl");
}

}  // namespace

fs::path journal_file(const fs::path& folder, const Shard& shard) {
  return folder / "journal" / (name_of(shard) + ".jsonl");
}

std::string place_of(std::size_t number, const std::string& name) {
  std::string group = std::to_string((number - 1) / kFieldsAFolder);
  group.insert(0, 4 - std::min<std::size_t>(group.size(), 4), '0');
  return group + "/" + folder_name(static_cast<int>(number), name);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail(folder, "made", error.value());
}

void write_beside(const fs::path& beside, const fs::path& file, std::string_view bytes) {
  const int handle = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (handle < 0) fail(file, "written", errno);
  int error = write_all(handle, bytes);
  if (::close(handle) != 0 && error == 0) error = errno;
  if (error != 0) fail(file, "written", error);
  put_in_place(beside, file);
}

void put_in_place(const fs::path& beside, const fs::path& file) {
  std::error_code error;
  fs::rename(beside, file, error);
  if (error == std::errc::no_such_file_or_directory) {
    make_folder(file.parent_path());
    fs::rename(beside, file, error);
  }
  if (error) fail(file, "written", error.value());
}

FileHandle::~FileHandle() {
  if (number_ >= 0) ::close(number_);
}

ShardJournal::ShardJournal(fs::path folder, const BatchIdentity& identity, const Shard& shard,
                           Earlier earlier)
    : folder_{std::move(folder)},
      shard_{shard},
      file_{journal_file(folder_, shard)},
      part_{fs::path{file_}.replace_extension(".part")} {
  clear_other_divisions(earlier);
  open();
  const JournalIndex index = read_journal(file_, [&](const BatchResult& result) {
    std::error_code error;
    const bool whole =
        result.plan.empty() || (fs::file_size(folder_ / result.plan, error) == result.plan_bytes && !error);
    if (earlier == Earlier::replace) remove_plan(folder_, result);
    if (earlier == Earlier::resume && whole) done_[result.number] = result.status;
  });
  if (earlier == Earlier::refuse) refuse_earlier(index);
  if (earlier == Earlier::resume && index.identity) {
    const std::string why = difference(*index.identity, identity);
    if (!why.empty())
      throw InputError{"the batch in " + folder_.string() + " " + why +
                       "; go on as it was begun, or begin anew with --overwrite or another -o DIR"};
    take_up(index);
  } else if (::ftruncate(handle_.number(), 0) != 0) {
    fail(file_, "written", errno);
  }
  fs::remove_all(part_);
  make_folder(part_);
  if (earlier != Earlier::resume || !index.identity) append(journal_header(identity, shard_));
}

ShardJournal::~ShardJournal() {
  std::error_code ignored;
  fs::remove_all(part_, ignored);
}

void ShardJournal::open() {
  make_folder(file_.parent_path());
  handle_ = locked(file_);
}

void ShardJournal::refuse_earlier(const JournalIndex& index) const {
  std::error_code ignored;
  const bool tables = std::ranges::any_of(
      kBatchTables, [&](std::string_view name) { return fs::exists(folder_ / name, ignored); });
  const bool plans = shard_.count == 1 && fs::exists(folder_ / "plans", ignored);
  if (!index.identity && !tables && !plans) return;
  throw InputError{folder_.string() +
                   ": holds a batch already; give --resume to go on with it, --overwrite to "
                   "replace it, or choose another -o DIR"};
}

/// Shards of 1/4 and of 1/8 do not add up to a batch.
void ShardJournal::clear_other_divisions(Earlier earlier) const {
  std::error_code none;
  std::vector<std::pair<fs::path, FileHandle>> others;  // all are locked before the first is removed
  for (const fs::directory_entry& entry : fs::directory_iterator{file_.parent_path(), none}) {
    const fs::path& other = entry.path();
    if (other.extension() != ".jsonl" || is_of_division(other, shard_)) continue;
    if (earlier != Earlier::replace)
      throw InputError{folder_.string() + ": holds " + other.stem().string() +
                       " of a batch, another division than " + name_of(shard_) +
                       "; go on with that one, give --overwrite to replace it, or choose another -o DIR"};
    others.emplace_back(other, locked(other));
  }
  for (const auto& [other, lock] : others) {
    read_journal(other, [&](const BatchResult& result) { remove_plan(folder_, result); });
    fs::remove(other);
  }
  if (earlier != Earlier::replace) return;
  for (const std::string_view table : kBatchTables) fs::remove(folder_ / table, none);
}

/// Goes on behind the last whole result, or knows that there is nothing left to do.
void ShardJournal::take_up(const JournalIndex& index) {
  const bool all_whole = std::ranges::all_of(
      index.lines, [&](const JournalIndex::Line& line) { return done_.contains(line.number); });
  std::uint64_t keep = index.good_bytes;
  if (index.numbers && all_whole)
    numbers_ = index.numbers;
  else if (index.numbers)
    keep -= journal_end(*index.numbers).size();
  if (::ftruncate(handle_.number(), static_cast<off_t>(keep)) != 0) fail(file_, "written", errno);
  if (::lseek(handle_.number(), 0, SEEK_END) < 0) fail(file_, "written", errno);
}

void ShardJournal::append(std::string_view line) {
  if (const int error = write_all(handle_.number(), line); error != 0) fail(file_, "written", error);
}

std::array<std::size_t, kBatchStatusNames.size()> ShardJournal::counts() const {
  std::array<std::size_t, kBatchStatusNames.size()> counts{};
  for (const auto& [number, status] : done_) ++counts.at(static_cast<std::size_t>(status));
  return counts;
}

void ShardJournal::add(const BatchResult& result) {
  append(journal_line(result));
  done_[result.number] = result.status;
  if (!result.plan.empty()) unflushed_.push_back(folder_ / result.plan);
  if (unflushed_.size() >= kFlushAfter) flush();
}

void ShardJournal::flush() {
  for (const fs::path& file : unflushed_) flush_file(file);
  unflushed_.clear();
  if (::fsync(handle_.number()) != 0 && errno != EINVAL && errno != EROFS) fail(file_, "written", errno);
}

void ShardJournal::finish(std::size_t numbers) {
  flush();
  JournalIndex index = read_journal(file_, [](const BatchResult&) {});
  // of a field that was planned twice, its plan file having been lost, the last line counts
  std::ranges::stable_sort(index.lines, {}, &JournalIndex::Line::number);
  std::ifstream journal{file_, std::ios::binary};
  const fs::path sorted = part_ / "journal";
  std::ofstream out{sorted, std::ios::binary};
  std::string text;
  std::getline(journal, text);
  out << text << '\n';
  for (std::size_t i = 0; i < index.lines.size(); ++i) {
    const JournalIndex::Line& line = index.lines[i];
    if (i + 1 < index.lines.size() && index.lines[i + 1].number == line.number) continue;
    text.resize(line.bytes);
    journal.seekg(static_cast<std::streamoff>(line.offset));
    journal.read(text.data(), static_cast<std::streamsize>(text.size()));
    out << text << '\n';
  }
  out << journal_end(numbers);
  out.close();
  if (!journal || !out) fail(file_, "written", EIO);
  flush_file(sorted);
  put_in_place(sorted, file_);
  numbers_ = numbers;
}

}  // namespace selion
