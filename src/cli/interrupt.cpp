// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <string_view>
#include <thread>

#include <unistd.h>

namespace selion::cli {
namespace {

/// How many parts of the program would rather end by themselves; and whether they were asked to. One for the
/// whole process, as signals are.
std::atomic<int>& listeners() {
  static std::atomic<int> count = 0;
  return count;
}
std::atomic<bool>& asked() {
  static std::atomic<bool> once = false;
  return once;
}

void wait_for(const sigset_t& signals) {
  int signal = 0;
  while (sigwait(&signals, &signal) != 0) {
  }
}

[[noreturn]] void wait_and_end(const sigset_t& signals) {
  wait_for(signals);
  while (listeners() > 0 && !asked().exchange(true)) wait_for(signals);
  // A disk that hangs must not keep the program for ever.
  static_cast<void>(writing().try_lock_for(std::chrono::seconds{10}));
  constexpr std::string_view kMessage = "\ninterrupted\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kMessage.data(), kMessage.size());
  _exit(130);
}

bool is_ignored(int signal) {
  struct sigaction now {};
  return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

std::timed_mutex& writing() {
  static std::timed_mutex mutex;
  return mutex;
}

StopRequest::StopRequest() { ++listeners(); }
StopRequest::~StopRequest() { --listeners(); }
bool StopRequest::made() { return asked(); }

void watch_for_interrupts() {
  writing(), listeners(), asked();
  std::signal(SIGXFSZ, SIG_IGN);  // a file above the user's limit is an error with a message, not the end
  sigset_t signals;
  sigemptyset(&signals);
  for (int signal : std::array{SIGINT, SIGTERM})
    if (!is_ignored(signal)) sigaddset(&signals, signal);  // nohup and background shells want it ignored
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread{wait_and_end, signals}.detach();
}

}  // namespace selion::cli
