// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "selion/core/error.hpp"

namespace selion {
namespace {

constexpr double kMargin_mm = 9;
constexpr double kTickRoom_mm = 5.5;  // numbers of the graticule
constexpr double kScaleRoom_mm = 15;
constexpr double kSidePanel_mm = 64;
constexpr double kLeastFrame_mm = 70;
constexpr double kPadding_mm = 9;  // between field and frame, for the names of gates

/// How much text is shown; the later ones are for pages that would have no room for a map.
struct Budget {
  std::size_t warnings;
  std::size_t letters;  ///< of a warning
  std::size_t data;
  std::size_t note_lines;
  std::size_t assumptions;
};
constexpr std::size_t kAll = 1'000'000;
constexpr std::array<Budget, 6> kBudgets{{{kAll, kAll, kAll, 16, kAll},
                                          {kAll, kAll, kAll, 16, 8},
                                          {kAll, kAll, kAll, 12, 4},
                                          {10, 400, 30, 8, 3},
                                          {6, 250, 20, 4, 1},
                                          {4, 150, 10, 1, 0}}};

enum class PanelSide { below, beside };
struct Sheet {
  double width_mm;
  double height_mm;
  PanelSide side;
};

std::array<Sheet, 4> sheets(Paper paper, bool wide) {
  const bool letter = paper == Paper::letter;
  const double small = letter ? 215.9 : paper == Paper::a4 ? 210 : 297;
  const double large = letter ? 279.4 : paper == Paper::a4 ? 297 : 420;
  std::array<Sheet, 4> all{{{small, large, PanelSide::below},
                            {large, small, PanelSide::beside},
                            {large, small, PanelSide::below},
                            {small, large, PanelSide::beside}}};
  if (wide) std::swap(all[0], all[2]);
  return all;
}

/// The warnings of the text and of the plan, each once.
std::vector<std::string> warnings_of(const PlanFile& plan, const MapText& text, const Budget& budget) {
  std::vector<std::string> all = text.warnings;
  for (const std::string& warning : plan.warnings)
    if (std::find(all.begin(), all.end(), warning) == all.end()) all.push_back(warning);
  std::vector<std::string> shown;
  for (const std::string& warning : all) {
    if (shown.size() == budget.warnings) {
      shown.push_back(std::to_string(all.size() - shown.size()) +
                      " more warnings: read report.json before driving");
      break;
    }
    shown.push_back(warning.size() <= budget.letters
                        ? warning
                        : printable(warning.substr(0, budget.letters)) + "\u2026 (see report.json)");
  }
  return shown;
}

std::vector<PanelItem> head_items(const PlanFile& plan, const MapText& text, const Budget& budget,
                                  const Font& font, double width_mm) {
  std::vector<std::string> title = font.wrapped(text.title, kTitle, width_mm);
  if (title.size() > 2) title = {title[0], font.shortened(title[1] + ' ' + title[2], kTitle, width_mm)};
  std::vector<PanelItem> items;
  items.reserve(title.size() + 2);
  for (const std::string& line : title) items.push_back(paragraph(font, line, kTitle, width_mm));
  std::string about = "Plan " + plan.id + "  \u00B7  selion " + plan.version;
  if (text.date) about += "  \u00B7  " + *text.date;
  items.push_back(paragraph(font, about, {8, Weight::regular}, width_mm));
  items.back().height_mm += 1.5;
  if (const auto warnings = warnings_of(plan, text, budget); !warnings.empty()) {
    items.push_back(warning_box(font, warnings, width_mm));
    items.back().height_mm += 2.5;
  }
  return items;
}

std::vector<PanelItem> foot_items(const PlanFile& plan, const Font& font, double width_mm) {
  return {paragraph(
      font,
      "Plan, not a survey: drive the boundary before you rely on it. Datum WGS 84. Local frame: " + plan.proj,
      kSmall, width_mm)};
}

double height_of(const std::vector<PanelItem>& items) {
  double sum = 0;
  for (const PanelItem& item : items) sum += item.height_mm;
  return sum;
}

/// A denominator that a person can work with, no smaller than needed.
double round_denominator(double needed) {
  const double power = std::pow(10, std::floor(std::log10(needed)));
  for (const double digits :
       {1.0, 1.1, 1.25, 1.5, 1.75, 2.0, 2.25, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0, 7.0, 8.0, 9.0})
    if (digits * power >= needed * (1 - 1e-12)) return digits * power;
  return 10 * power;
}

/// Splits what is between head and foot into map, scale and panel; false where that leaves no room for a map.
bool split(PageLayout& layout, PanelSide side, double top_mm, const std::vector<PanelItem>& items) {
  const PageBox& page = layout.content;
  const double bottom_mm = layout.foot_top_mm - 2.5;
  const double panel_mm = flowed_height_mm(items, layout.panel_columns);
  PageBox map{page.left_mm, top_mm, page.right_mm, bottom_mm};
  if (side == PanelSide::below) {
    map.bottom_mm -= panel_mm + 2;
    layout.panel = {page.left_mm, map.bottom_mm + 2, page.right_mm, bottom_mm};
  } else {
    map.right_mm -= layout.column_mm + kColumnGap_mm;
    layout.panel = {map.right_mm + kColumnGap_mm, top_mm, page.right_mm, bottom_mm};
    if (panel_mm > layout.panel.height_mm()) return false;
  }
  layout.scale = {map.left_mm, map.bottom_mm - kScaleRoom_mm, map.right_mm, map.bottom_mm};
  layout.frame = {map.left_mm + kTickRoom_mm, map.top_mm, map.right_mm - 1.6,
                  map.bottom_mm - kScaleRoom_mm - kTickRoom_mm};
  return layout.frame.height_mm() >= kLeastFrame_mm && layout.frame.width_mm() >= kLeastFrame_mm;
}

class Composer {
 public:
  Composer(const PageContent& content, const Font& font) : content_{content}, font_{font} {}

  [[nodiscard]] std::optional<PageLayout> best(Paper paper, const Budget& budget) const {
    const Point size = content_.extent.high - content_.extent.low;
    std::optional<PageLayout> best;
    for (const Sheet& sheet : sheets(paper, size.x_m > size.y_m)) {
      const auto layout = on(sheet, budget);
      if (!layout) continue;
      const auto area = [](const PageLayout& l) { return l.frame.width_mm() * l.frame.height_mm(); };
      const bool larger =
          !best || layout->scale_denominator < best->scale_denominator * 0.999 ||
          (layout->scale_denominator < best->scale_denominator * 1.001 && area(*layout) > 1.02 * area(*best));
      if (larger) best = layout;
    }
    return best;
  }

 private:
  [[nodiscard]] std::optional<PageLayout> on(const Sheet& sheet, const Budget& budget) const {
    PageLayout layout;
    layout.width_mm = sheet.width_mm;
    layout.height_mm = sheet.height_mm;
    layout.content = {kMargin_mm, kMargin_mm, sheet.width_mm - kMargin_mm, sheet.height_mm - kMargin_mm};
    const double width_mm = layout.content.width_mm();
    layout.head = head_items(content_.plan, content_.text, budget, font_, width_mm);
    layout.foot = foot_items(content_.plan, font_, width_mm);
    layout.foot_top_mm = layout.content.bottom_mm - height_of(layout.foot);
    layout.data_shown = budget.data;
    layout.note_lines_shown = budget.note_lines;
    layout.assumptions_shown = budget.assumptions;
    layout.panel_columns =
        sheet.side == PanelSide::beside ? 1 : static_cast<int>((width_mm + kColumnGap_mm) / 62);
    layout.column_mm = sheet.side == PanelSide::beside
                           ? kSidePanel_mm
                           : (width_mm + kColumnGap_mm) / layout.panel_columns - kColumnGap_mm;
    const double top_mm = layout.content.top_mm + height_of(layout.head) + 0.5;
    if (!split(layout, sheet.side, top_mm, panel_items(font_, content_.text, content_.legend, layout)))
      return std::nullopt;
    const Point size = content_.extent.high - content_.extent.low;
    layout.scale_denominator =
        round_denominator(std::max({1000 * size.x_m / (layout.frame.width_mm() - 2 * kPadding_mm),
                                    1000 * size.y_m / (layout.frame.height_mm() - 2 * kPadding_mm), 10.0}));
    return layout;
  }

  const PageContent& content_;
  const Font& font_;
};

}  // namespace

std::vector<PanelItem> panel_items(const Font& font, const MapText& text,
                                   const std::map<Mark, std::string>& legend, const PageLayout& layout) {
  MapText shown = text;
  if (shown.data.size() > layout.data_shown) {
    shown.data.resize(layout.data_shown);
    shown.data.emplace_back("more figures", "report.json");
  }
  std::vector<PanelItem> items = legend_items(font, legend, layout.column_mm);
  for (auto& more : {data_items(font, shown, layout.column_mm),
                     note_items(font, text.notes, layout.note_lines_shown, layout.column_mm),
                     assumption_items(font, shown, layout.assumptions_shown, layout.column_mm)})
    items.insert(items.end(), more.begin(), more.end());
  return items;
}

PageLayout page_layout(const PageContent& content, const Font& font, Paper paper) {
  const Composer composer{content, font};
  for (const Budget& budget : kBudgets)
    if (auto layout = composer.best(paper, budget)) return *layout;
  throw InputError{
      "map: title, plan id or frame of the plan are too long for a page; shorten the field's name"};
}

}  // namespace selion
