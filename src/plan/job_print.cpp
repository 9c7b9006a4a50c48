// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/plan/job_file.hpp"
#include "selion/plan/text.hpp"

namespace selion {

std::string job_toml(const Job& job) {
  std::string out;
  std::string_view table;
  for (const JobKey& key : job_keys()) {
    if (key.table != table) out += "\n[" + std::string{key.table} + "]\n";
    table = key.table;
    out += std::string{key.name} + " = " + text_of_value(key, key.get(job)) + "\n";
  }
  return out;
}

std::string job_json(const Job& job) {
  std::string out = "{";
  std::string_view table;
  for (const JobKey& key : job_keys()) {
    if (key.table != table) {
      if (!table.empty()) out += '}';
      out += "," + in_quotes(key.table) + ":{";
    } else if (out.size() > 1) {
      out += ',';
    }
    table = key.table;
    std::string value = text_of_value(key, key.get(job));
    if (key.type == JobType::line) std::erase(value, ' ');
    out += in_quotes(key.name) + ":" + value;
  }
  return out + "}}";
}

}  // namespace selion
