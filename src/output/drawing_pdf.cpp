// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <stdexcept>
#include <string>

#include <cairo-pdf.h>

#include "drawing.hpp"
#include "font.hpp"

namespace selion {
namespace {

constexpr double kPtPerMm = 72 / 25.4;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

class Painter {
 public:
  Painter(cairo_t* page, const Font& font) : page_{page}, font_{font} {
    cairo_scale(page_, kPtPerMm, kPtPerMm);
    cairo_set_fill_rule(page_, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_set_line_join(page_, CAIRO_LINE_JOIN_ROUND);
  }

  void add(const PageShape& shape) {
    for (const PageLine& line : shape.lines) {
      cairo_new_sub_path(page_);
      for (const PagePoint p : line) cairo_line_to(page_, p.x_mm, p.y_mm);
      if (shape.ends == Ends::closed) cairo_close_path(page_);
    }
    if (shape.fill) {
      use(*shape.fill);
      cairo_fill_preserve(page_);
    }
    if (shape.stroke) {
      const Stroke& stroke = *shape.stroke;
      use(stroke.colour);
      cairo_set_line_width(page_, stroke.width_mm);
      int dashes = 0;
      while (dashes < static_cast<int>(stroke.dash_mm.size()) &&
             stroke.dash_mm[static_cast<std::size_t>(dashes)] > 0)
        ++dashes;
      cairo_set_dash(page_, stroke.dash_mm.data(), dashes, 0);
      cairo_stroke_preserve(page_);
    }
    cairo_new_path(page_);
  }

  void add(const PageText& text) { font_.draw(page_, text); }

  void add(const LayerStart& layer) {
    cairo_save(page_);
    if (!layer.clip) return;
    cairo_rectangle(page_, layer.clip->left_mm, layer.clip->top_mm, layer.clip->width_mm(),
                    layer.clip->height_mm());
    cairo_clip(page_);
  }

  void add(const LayerEnd& /*end*/) { cairo_restore(page_); }

 private:
  void use(Colour c) { cairo_set_source_rgb(page_, c.red / 255.0, c.green / 255.0, c.blue / 255.0); }

  cairo_t* page_;
  const Font& font_;
};

/// Cairo always writes a date. A false one would mislead, so its entry becomes spaces, which keeps every
/// offset.
void drop_date(std::string& pdf) {
  const std::size_t from = pdf.rfind("/CreationDate (");
  if (from == std::string::npos) return;
  const std::size_t to = pdf.find(')', from);
  if (to != std::string::npos) pdf.replace(from, to + 1 - from, to + 1 - from, ' ');
}

}  // namespace

std::string to_pdf(const Drawing& page, const Font& font) {
  std::string pdf;
  cairo_surface_t* surface =
      cairo_pdf_surface_create_for_stream(append, &pdf, page.width_mm * kPtPerMm, page.height_mm * kPtPerMm);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, printable(page.title).c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, printable(page.creator).c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  cairo_t* context = cairo_create(surface);
  {
    Painter painter{context, font};
    for (const PageItem& item : page.items) std::visit([&painter](const auto& it) { painter.add(it); }, item);
  }
  const cairo_status_t drawn = cairo_status(context);
  cairo_destroy(context);
  cairo_surface_finish(surface);
  const cairo_status_t written = cairo_surface_status(surface);
  cairo_surface_destroy(surface);
  for (const cairo_status_t status : {drawn, written})
    if (status != CAIRO_STATUS_SUCCESS)
      throw std::runtime_error{std::string{"the map could not be drawn as PDF: "} +
                               cairo_status_to_string(status)};
  drop_date(pdf);
  return pdf;
}

}  // namespace selion
