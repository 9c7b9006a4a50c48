// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch_text.hpp"

#include <array>
#include <filesystem>

#include "selion/core/format.hpp"
#include "selion/core/json_writer.hpp"
#include "terminal.hpp"

namespace selion::cli {
namespace {

struct Share {
  double share;
  const char* key;
  const char* words;
};
constexpr auto kShares = std::to_array<Share>({{0, "least", "least"},
                                               {0.01, "1_percent", "1 % of them at most"},
                                               {0.1, "10_percent", "10 % at most"},
                                               {0.5, "median", "half at most"},
                                               {0.9, "90_percent", "90 % at most"}});

void add_summary(JsonWriter& json, const BatchSummary& summary) {
  json.key("covered_percent").begin_object(JsonSpread::line);
  for (const Share& share : kShares)
    if (const auto percent = summary.covered_percent(share.share)) json.key(share.key).number(*percent, 1);
  json.end().key("without_plan").begin_object(JsonSpread::line);
  for (const auto& [reason, times] : summary.reasons()) json.key(reason).whole(static_cast<long long>(times));
  json.end().key("checked").whole(static_cast<long long>(summary.checked()));
  json.key("check_failed").whole(static_cast<long long>(summary.check_failed()));
}

std::string summary_text(const BatchSummary& summary) {
  std::string text;
  if (summary.planned() > 0) {
    text += "  covered, of fields with a plan: ";
    for (const Share& share : kShares)
      text += std::string{share.words} + " " + fixed(*summary.covered_percent(share.share), 1) +
              (&share == &kShares.back() ? " %\n" : " %, ");
  }
  std::string reasons;
  for (const auto& [reason, times] : summary.reasons())
    reasons += (reasons.empty() ? "" : ", ") + std::to_string(times) + " " + reason;
  if (!reasons.empty()) text += "  without a plan: " + reasons + "\n";
  if (summary.checked() > 0)
    text += "  the independent check: " + std::to_string(summary.checked() - summary.check_failed()) +
            " passed, " + std::to_string(summary.check_failed()) + " failed\n";
  return text;
}

}  // namespace

std::string json_of(const BatchCount& count, const std::string& folder) {
  JsonWriter json;
  json.begin_object(JsonSpread::line).key("folder").text(folder);
  json.key("fields").whole(static_cast<long long>(count.total()));
  for (std::size_t i = 0; i < kBatchStatusNames.size(); ++i)
    json.key(kBatchStatusNames.at(i)).whole(static_cast<long long>(count.by_status.at(i)));
  json.key("finished").raw(count.stopped ? "false" : "true");
  if (count.tables) add_summary(json, count.summary);
  return json.end().str() + "\n";
}

std::string text_of(const BatchCount& count, const std::string& folder) {
  std::string text = std::to_string(count.total()) + (count.total() == 1 ? " field: " : " fields: ");
  for (std::size_t i = 0; i < kBatchStatusNames.size(); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(count.by_status.at(i)) + " " +
            std::string{kBatchStatusNames.at(i)};
  text += "\n";
  if (!count.tables) return text;
  text += summary_text(count.summary);
  text += "  in " + printable((std::filesystem::path{folder} / "").string()) + ": ";
  for (const std::string_view table : kBatchTables) text += std::string{table} + ", ";
  return text + "plans\n";
}

}  // namespace selion::cli
