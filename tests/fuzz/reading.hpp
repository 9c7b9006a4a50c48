// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "field/raw.hpp"

namespace selion::fuzz {

std::string text_of(const std::uint8_t* data, std::size_t size);

/// Reads a file of these bytes called "field" + `ending` as the command would, and cleans what is read.
/// InputError is an answer; whatever else is thrown is a fault, which libFuzzer reports.
void read_and_clean(const std::string& bytes, const std::string& ending, const ReadOptions& options);

/// Brings what a reader made of a file to WGS84 and cleans it.
void locate_and_clean(const RawFile& file);

}  // namespace selion::fuzz
