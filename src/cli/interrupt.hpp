// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

namespace selion::cli {

/// Held while files are being written and renamed: an interrupt waits for it, so that none is left half done.
std::timed_mutex& writing();

/// While it lives, the first SIGINT or SIGTERM only asks; the second ends the program as ever.
class StopRequest {
 public:
  StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;
  StopRequest(StopRequest&&) = delete;
  StopRequest& operator=(StopRequest&&) = delete;
  ~StopRequest();

  [[nodiscard]] static bool made();
};

/// From here on SIGINT and SIGTERM end the program with status 130. Called before any other thread starts.
void watch_for_interrupts();

}  // namespace selion::cli
