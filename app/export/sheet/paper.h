#pragma once

#include <cairo.h>

#include <functional>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "render/film/image.h"

namespace loomlight {

/// A sheet of paper that is written and drawn on, in millimetres from its top left. Texts are UTF-8.
class Paper {
 public:
  /// For a PDF file; for a PNG where it has so many `pixels_per_mm`.
  Paper(double width_mm, double height_mm, double pixels_per_mm = 0);
  ~Paper();
  Paper(const Paper&) = delete;
  Paper& operator=(const Paper&) = delete;

  struct Font {
    double size_mm = 2.6;  ///< of the font's body
    bool bold = false;
    double grey = 0.1;  ///< 0 black, 1 white
  };
  /// On the line at y; returns where it ends. What goes beyond `room_mm` is cut off with an ellipsis; 0: no limit.
  double text(double x, double y, const std::string& text, const Font& font, double room_mm = 0);
  double width(const std::string& text, const Font& font);
  /// In lines as wide as the room, at most so many; returns the y of the line below.
  double paragraph(double x, double y, const std::string& text, const Font& font, double room_mm, int mostLines);
  void line(double x0, double y0, double x1, double y1, double width_mm, double grey = 0.6);
  void fill(double x, double y, double width, double height, const Rgb& srgb);
  /// Three channels, stretched into the rectangle.
  void picture(double x, double y, double width, double height, const Pixels8& pixels);
  /// Draws with cairo itself, in points, the origin at (x, y).
  void draw(double x, double y, const std::function<void(cairo_t*)>& how);

  /// Goes on on another sheet of this size; in a PNG it lies below the last.
  void newPage();

  /// What covers the sheets: the ink of texts, and pictures.
  struct Box {
    int page = 0;
    double x = 0, y = 0, width = 0, height = 0;
    std::string text;  ///< empty for a picture
  };
  const std::vector<Box>& boxes() const { return boxes_; }

  /// The pages as a file, once. Throws InputError naming it where that failed.
  void write(const std::string& file);

 private:
  void begin();

  double width_mm_, height_mm_, pixels_per_mm_;
  std::string bytes_;
  bool isPdf_;
  std::vector<Box> boxes_;
  std::vector<cairo_surface_t*> full_;  ///< the pages before, of a PNG
  int page_ = 0;
  cairo_surface_t* surface_;
  cairo_t* canvas_;
};

}  // namespace loomlight
