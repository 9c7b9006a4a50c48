// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_dir.hpp"

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "interrupt.hpp"
#include "selion/core/error.hpp"

namespace selion::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& what, const std::string& action, int error) {
  throw InputError{what.string() + ": cannot be " + action + ": " + std::generic_category().message(error)};
}

void check_name(const fs::path& file, Existing existing) {
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(file, ignored);
  if (status.type() == fs::file_type::directory)
    throw InputError{file.string() + ": is a folder; choose another -o DIR"};
  if (fs::exists(status) && existing == Existing::refuse)
    throw InputError{file.string() + ": exists; give --overwrite to replace it, or choose another -o DIR"};
}

/// The nearest folder above that is there: what decides whether `folder` can be made.
fs::path existing_part(fs::path folder) {
  std::error_code ignored;
  folder = fs::absolute(folder).lexically_normal();
  while (!fs::exists(folder, ignored) && folder.has_relative_path()) folder = folder.parent_path();
  return folder;
}

/// Removes what was begun unless all of it was finished.
class Unfinished {
 public:
  Unfinished() = default;
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  Unfinished(Unfinished&&) = delete;
  Unfinished& operator=(Unfinished&&) = delete;
  ~Unfinished() {
    std::error_code ignored;  // what cannot be removed was reported by what failed before
    for (const fs::path& file : files_) fs::remove(file, ignored);
    std::ranges::reverse(folders_);
    for (const fs::path& folder : folders_) fs::remove(folder, ignored);  // only where it is empty
  }

  void add_file(const fs::path& file) { files_.push_back(file); }
  void add_folder(const fs::path& folder) { folders_.push_back(folder); }
  void finished() {
    files_.clear();
    folders_.clear();
  }

 private:
  std::vector<fs::path> files_;
  std::vector<fs::path> folders_;
};

void make_folder(const fs::path& folder, Unfinished& begun) {
  std::error_code error;
  if (folder.empty() || fs::is_directory(folder, error)) return;
  make_folder(folder.parent_path(), begun);
  if (fs::create_directory(folder, error)) begun.add_folder(folder);
  if (error) fail(folder, "made", error.value());
}

/// 0, or the error that kept some of the bytes from the disk.
int write_all(int handle, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(handle, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  if (::fsync(handle) != 0 && errno != EINVAL && errno != EROFS)
    return errno;  // some file systems have no fsync
  return 0;
}

void write_file(const fs::path& file, const fs::path& meant, std::string_view bytes) {
  const int handle = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (handle < 0) fail(meant, "written", errno);
  int error = write_all(handle, bytes);
  if (::close(handle) != 0 && error == 0) error = errno;
  if (error != 0) fail(meant, "written", error);
}

}  // namespace

void check_output(const fs::path& folder, std::span<const std::string_view> names, Existing existing) {
  const fs::path there = existing_part(folder);
  std::error_code ignored;
  if (!fs::is_directory(there, ignored))
    throw InputError{there.string() + ": is not a folder; choose another -o DIR"};
  if (::access(there.c_str(), W_OK | X_OK) != 0) fail(there, "written to", errno);
  for (std::string_view name : names) check_name(folder / name, existing);
}

void write_output(const fs::path& folder, std::span<const OutputFile> files, Existing existing) {
  const std::scoped_lock no_interrupt{writing()};
  Unfinished begun;
  make_folder(folder, begun);
  const std::string mark = ".selion-" + std::to_string(::getpid()) + "-";
  for (const OutputFile& file : files) check_name(folder / file.name, existing);
  for (const OutputFile& file : files) {
    const fs::path beside = folder / (mark + file.name);
    begun.add_file(beside);
    write_file(beside, folder / file.name, file.bytes);
  }
  for (const OutputFile& file : files) {
    std::error_code error;
    fs::rename(folder / (mark + file.name), folder / file.name, error);
    if (error) fail(folder / file.name, "written", error.value());
    if (existing == Existing::refuse) begun.add_file(folder / file.name);
  }
  begun.finished();
}

}  // namespace selion::cli
