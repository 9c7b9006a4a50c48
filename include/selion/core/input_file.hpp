// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace selion {

/// Devices, sockets and named pipes may never end, or never begin. Pipes that the shell has opened
/// (/dev/stdin, /dev/fd/63) are taken; what does not exist is for whoever opens it to tell.
/// @throws InputError naming the path.
void refuse_endless(const std::filesystem::path& path);

}  // namespace selion
