// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace selion {

/// While it lives, GDAL's messages of this thread are kept here instead of being printed.
class GdalMessages {
 public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;
  GdalMessages(GdalMessages&&) = delete;
  GdalMessages& operator=(GdalMessages&&) = delete;

  std::vector<std::string> failures;
  std::vector<std::string> warnings;  ///< each once
};

/// A folder in memory, gone with its files at the end: GDAL writes beside what it reads, which the user's
/// folder is spared.
class MemoryFolder {
 public:
  MemoryFolder();
  ~MemoryFolder();
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;
  MemoryFolder(MemoryFolder&&) = delete;
  MemoryFolder& operator=(MemoryFolder&&) = delete;

  /// @returns its path for GDAL. `bytes` must outlive the folder.
  std::string add(const std::string& name, const std::string& bytes);

 private:
  std::string path_;
};

/// A whole file, GDAL's virtual ones too. @throws InputError where it cannot be read or is beyond 2 GB.
std::string gdal_file_bytes(const std::string& path, const std::string& label);
/// As its folder or archive says; 0 where there is none.
unsigned long long gdal_file_size(const std::string& path);
bool gdal_file_exists(const std::string& path);

/// The names of the drivers that may open a user's file, ended by a null: all but those that open whatever
/// place the file's text names.
const char* const* gdal_drivers();

}  // namespace selion
