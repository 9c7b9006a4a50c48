// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_panel.hpp"

#include <algorithm>

namespace selion {
namespace {

constexpr double kSampleWidth_mm = 10;
constexpr double kIndent_mm = 2.6;
constexpr TextStyle kLoud{9, Weight::bold};
constexpr double kInset_mm = 13;  // of the text beside the warning sign

using Lines = std::vector<std::string>;

double height_of(const Lines& lines, TextStyle style) {
  return static_cast<double>(lines.size()) * line_height_mm(style);
}

/// Baseline of the first line in an item that begins at `top_mm`.
double first_baseline(double top_mm, TextStyle style) { return top_mm + line_height_mm(style) * 0.8; }

void draw_text_lines(Drawing& page, const Lines& lines, PagePoint corner, TextStyle style, Align align) {
  double y = first_baseline(corner.y_mm, style);
  for (const std::string& line : lines) {
    page.add(PageText{line, {corner.x_mm, y}, style, align, 0, kBlack});
    y += line_height_mm(style);
  }
}

PanelItem heading(const std::string& text) {
  const double height = line_height_mm(kHeading) + 1.6;
  return {height, true, [text](Drawing& page, PagePoint corner) {
            page.add(PageText{text,
                              {corner.x_mm, corner.y_mm + 0.8 + line_height_mm(kHeading) * 0.8},
                              kHeading,
                              Align::left,
                              0,
                              kBlack});
          }};
}

PanelItem legend_item(const Font& font, Mark mark, const std::string& words, double width_mm) {
  const Lines lines = font.wrapped(words, kBody, width_mm - kSampleWidth_mm - 2);
  const double height = std::max(4.9, height_of(lines, kBody) + 1);
  return {height, false, [mark, lines, height](Drawing& page, PagePoint corner) {
            draw_sample(page, mark,
                        {corner.x_mm, corner.y_mm, corner.x_mm + kSampleWidth_mm, corner.y_mm + height});
            draw_text_lines(
                page, lines,
                {corner.x_mm + kSampleWidth_mm + 2, corner.y_mm + (height - height_of(lines, kBody)) / 2},
                kBody, Align::left);
          }};
}

PanelItem data_item(const Font& font, const std::pair<std::string, std::string>& figure, double width_mm) {
  const auto& [label, value] = figure;
  const double value_mm = std::min(font.width_mm(value, kBody), width_mm * 0.6);
  const Lines labels = font.wrapped(label, kBody, width_mm - value_mm - 2);
  const Lines values = font.wrapped(value, kBody, width_mm * 0.6 + 1e-6);
  const double height = std::max(height_of(labels, kBody), height_of(values, kBody)) + 0.5;
  return {height, false, [labels, values, width_mm, height](Drawing& page, PagePoint corner) {
            draw_text_lines(page, labels, corner, kBody, Align::left);
            draw_text_lines(page, values, {corner.x_mm + width_mm, corner.y_mm}, kBody, Align::right);
            const double y = corner.y_mm + height - 0.1;
            page.add(PageShape{{{{corner.x_mm, y}, {corner.x_mm + width_mm, y}}},
                               Ends::open,
                               {},
                               Stroke{{200, 200, 200}, 0.1, {}}});
          }};
}

PanelItem bullet(const Lines& lines) {
  return {height_of(lines, kBody) + 0.5, false, [lines](Drawing& page, PagePoint corner) {
            page.add(PageText{
                "\u2022", {corner.x_mm, first_baseline(corner.y_mm, kBody)}, kBody, Align::left, 0, kBlack});
            draw_text_lines(page, lines, {corner.x_mm + kIndent_mm, corner.y_mm}, kBody, Align::left);
          }};
}

PanelItem bullet(const Font& font, const std::string& text, double width_mm) {
  return bullet(font.wrapped(text, kBody, width_mm - kIndent_mm));
}

PanelItem more_in_report(const Font& font, std::size_t count, double width_mm) {
  return bullet(font, std::to_string(count) + " more: see report.json", width_mm);
}

/// Of a long text the first lines.
Lines first_lines(const Font& font, const std::string& text, std::size_t most, double width_mm) {
  constexpr std::size_t kLetters = 120;  // that no line holds
  Lines lines = font.wrapped(text.substr(0, (most + 1) * kLetters), kBody, width_mm);
  if (lines.size() <= most) return lines;
  lines.resize(most);
  lines.back() = font.shortened(lines.back() + "\u2026", kBody, width_mm);
  return lines;
}

/// The columns that result when none may be higher than `height_mm`: for each item its column.
std::vector<int> columns_of(const std::vector<PanelItem>& items, double height_mm) {
  std::vector<int> columns;
  int column = 0;
  double used = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    double wanted = items[i].height_mm;
    if (items[i].heads && i + 1 < items.size()) wanted += items[i + 1].height_mm;
    const bool stays_with_heading = i > 0 && items[i - 1].heads;
    if (used > 0 && !stays_with_heading && used + wanted > height_mm) {
      ++column;
      used = 0;
    }
    used += items[i].height_mm;
    columns.push_back(column);
  }
  return columns;
}

double highest_column(const std::vector<PanelItem>& items, const std::vector<int>& columns) {
  std::map<int, double> heights;
  double highest = 0;
  for (std::size_t i = 0; i < items.size(); ++i)
    highest = std::max(highest, heights[columns[i]] += items[i].height_mm);
  return highest;
}

}  // namespace

std::vector<PanelItem> legend_items(const Font& font, const std::map<Mark, std::string>& drawn,
                                    double width_mm) {
  std::vector<PanelItem> items;
  if (drawn.empty()) return items;
  items.push_back(heading("Legend"));
  for (const auto& [mark, words] : drawn) items.push_back(legend_item(font, mark, words, width_mm));
  return items;
}

std::vector<PanelItem> data_items(const Font& font, const MapText& text, double width_mm) {
  std::vector<PanelItem> items;
  if (text.data.empty()) return items;
  items.push_back(heading("Figures"));
  for (const auto& figure : text.data) items.push_back(data_item(font, figure, width_mm));
  return items;
}

std::vector<PanelItem> assumption_items(const Font& font, const MapText& text, std::size_t most,
                                        double width_mm) {
  std::vector<PanelItem> items;
  if (text.assumptions.empty()) return items;
  items.push_back(heading("Assumed"));
  const std::size_t shown = std::min(most, text.assumptions.size());
  for (std::size_t i = 0; i < shown; ++i) items.push_back(bullet(font, text.assumptions[i], width_mm));
  if (shown < text.assumptions.size())
    items.push_back(more_in_report(font, text.assumptions.size() - shown, width_mm));
  return items;
}

std::vector<PanelItem> note_items(const Font& font, const std::vector<std::string>& notes,
                                  std::size_t most_lines, double width_mm) {
  constexpr std::size_t kMostOfOne = 4;
  std::vector<PanelItem> items;
  if (notes.empty()) return items;
  items.push_back(heading("Notes"));
  std::size_t used = 0;
  std::size_t shown = 0;
  for (; shown < notes.size(); ++shown) {
    const Lines lines = first_lines(font, notes[shown], kMostOfOne, width_mm - kIndent_mm);
    used += lines.size();
    if (used > most_lines) break;
    items.push_back(bullet(lines));
  }
  if (shown < notes.size()) items.push_back(more_in_report(font, notes.size() - shown, width_mm));
  return items;
}

double flowed_height_mm(const std::vector<PanelItem>& items, int columns) {
  double low = 0;
  double high = 0;
  for (const PanelItem& item : items) high += item.height_mm;
  for (int i = 0; i < 24; ++i) {
    const double middle = (low + high) / 2;
    const std::vector<int> filled = columns_of(items, middle);
    const bool fits =
        filled.empty() || (filled.back() < columns && highest_column(items, filled) <= middle + 1e-9);
    (fits ? high : low) = middle;
  }
  return high;
}

void draw_flow(Drawing& page, const std::vector<PanelItem>& items, PageBox box, int columns, double gap_mm) {
  const std::vector<int> filled = columns_of(items, flowed_height_mm(items, columns) + 1e-6);
  const double step_mm = (box.width_mm() + gap_mm) / columns;
  double y = box.top_mm;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0 && filled[i] != filled[i - 1]) y = box.top_mm;
    items[i].draw(page, {box.left_mm + filled[i] * step_mm, y});
    y += items[i].height_mm;
  }
}

PanelItem warning_box(const Font& font, const std::vector<std::string>& warnings, double width_mm) {
  std::vector<Lines> paragraphs;
  double height = 3;
  for (const std::string& warning : warnings) {
    paragraphs.push_back(font.wrapped(warning, kLoud, width_mm - kInset_mm - 3));
    height += height_of(paragraphs.back(), kLoud) + 0.6;
  }
  height = std::max(height, 11.0);
  return {
      height, false, [paragraphs, width_mm, height](Drawing& page, PagePoint corner) {
        PageShape frame =
            filled({corner.x_mm, corner.y_mm, corner.x_mm + width_mm, corner.y_mm + height}, {255, 243, 205});
        frame.stroke = Stroke{kBlack, 0.9, {}};
        page.add(frame);
        const PagePoint sign{corner.x_mm + 6.5, corner.y_mm + height / 2};
        page.add(PageShape{{{{sign.x_mm, sign.y_mm - 4},
                             {sign.x_mm + 4.4, sign.y_mm + 3.6},
                             {sign.x_mm - 4.4, sign.y_mm + 3.6}}},
                           Ends::closed,
                           kWhite,
                           Stroke{kVermillion, 1, {}}});
        page.add(PageText{"!", {sign.x_mm, sign.y_mm + 2.6}, {13, Weight::bold}, Align::centre, 0, kBlack});
        double text_mm = 0;
        for (const Lines& lines : paragraphs) text_mm += height_of(lines, kLoud) + 0.6;
        double y = corner.y_mm + (height - text_mm + 0.6) / 2;
        for (const Lines& lines : paragraphs) {
          draw_text_lines(page, lines, {corner.x_mm + kInset_mm, y}, kLoud, Align::left);
          y += height_of(lines, kLoud) + 0.6;
        }
      }};
}

PanelItem paragraph(const Font& font, const std::string& text, TextStyle style, double width_mm) {
  const Lines lines = font.wrapped(text, style, width_mm);
  return {height_of(lines, style), false, [lines, style](Drawing& page, PagePoint corner) {
            draw_text_lines(page, lines, corner, style, Align::left);
          }};
}

}  // namespace selion
