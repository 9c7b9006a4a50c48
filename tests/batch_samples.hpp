// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "selion/batch/run.hpp"

namespace selion {

/// An empty folder that is gone after the test.
struct BatchScratch {
  std::filesystem::path at;
  BatchScratch();
  BatchScratch(const BatchScratch&) = delete;
  BatchScratch& operator=(const BatchScratch&) = delete;
  BatchScratch(BatchScratch&&) = delete;
  BatchScratch& operator=(BatchScratch&&) = delete;
  ~BatchScratch();
};

/// A file of `count` small fields: every third too narrow for any machine, every fifth crossing itself.
std::filesystem::path small_fields(const std::filesystem::path& folder, int count);

/// A batch of `fields` into `folder` on one thread.
BatchOptions small_batch(const std::filesystem::path& fields, const std::filesystem::path& folder);

/// Nobody looks on.
BatchWatch nobody();

/// The bytes of every file below, by its name.
std::map<std::string, std::string> files_below(const std::filesystem::path& folder);

}  // namespace selion
