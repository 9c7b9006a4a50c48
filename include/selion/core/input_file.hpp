// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <istream>
#include <string>

namespace selion {

/// Devices, sockets and named pipes may never end, or never begin. Pipes that the shell has opened
/// (/dev/stdin, /dev/fd/63) are taken; what does not exist is for whoever opens it to tell.
/// @throws InputError naming the path.
void refuse_endless(const std::filesystem::path& path);

constexpr unsigned long long kLargestFile_bytes = 1ULL << 31U;
constexpr unsigned long long kLongestStream_bytes = 1ULL << 28U;

/// All of standard input or a pipe, which may never end.
/// @throws InputError, calling it `label`, where there are more than 256 MiB.
std::string text_of_stream(std::istream& stream, const std::string& label);

}  // namespace selion
