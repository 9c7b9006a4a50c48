// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <string_view>

#include "selion/planfile/planfile.hpp"

namespace selion {
namespace {

// FNV-1a of Fowler, Noll and Vo, 64 bits.
constexpr std::uint64_t kOffsetBasis = 0xcbf29ce484222325;
constexpr std::uint64_t kPrime = 0x100000001b3;

std::uint64_t hashed(std::uint64_t state, std::string_view bytes) {
  for (const char byte : bytes) state = (state ^ static_cast<unsigned char>(byte)) * kPrime;
  return state;
}

// FNV's high bits barely feel the last bytes; Appleby's finaliser (MurmurHash3, fmix64) spreads them over
// all.
std::uint64_t mixed(std::uint64_t h) {
  h = (h ^ (h >> 33U)) * 0xff51afd7ed558ccd;
  h = (h ^ (h >> 33U)) * 0xc4ceb9fe1a85ec53;
  return h ^ (h >> 33U);
}

}  // namespace

std::string plan_id(const std::string& cleaned_input, const std::string& job_json) {
  constexpr std::string_view kSeparator{"\0",
                                        1};  // else input "ab" with job "c" would be input "a" with job "bc"
  std::uint64_t rest = mixed(hashed(hashed(hashed(kOffsetBasis, cleaned_input), kSeparator), job_json));
  std::string digits(16, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, rest >>= 4U)
    *digit = "0123456789abcdef"[rest & 15U];
  return digits;
}

}  // namespace selion
