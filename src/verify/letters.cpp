// SPDX-License-Identifier: GPL-3.0-or-later
#include "letters.hpp"

namespace selion::verifying {

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace selion::verifying
