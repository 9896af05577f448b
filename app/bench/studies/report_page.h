#pragma once

#include <string>
#include <vector>

#include "render/film/image.h"

namespace loomlight {

/// A folder with a Markdown page, its pictures and its tables as CSV. Every file is whole or not there; the page is
/// written last, by finish().
class ReportPage {
 public:
  /// Makes the folder where there is none. Throws InputError where it cannot be made.
  ReportPage(std::string folder, std::string name, const std::string& title);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  /// The table on the page, and as NAME.csv. Every row has as many cells as the header.
  void table(const std::string& name, const std::vector<std::string>& header,
             const std::vector<std::vector<std::string>>& rows);
  /// A table that is written as NAME.csv and does not stand on the page.
  void csv(const std::string& name, const std::vector<std::string>& header,
           const std::vector<std::vector<std::string>>& rows);
  /// A picture, NAME.png, with a caption; and, halved as often as it takes, as small/NAME.png of kSmall_bytes at most.
  void picture(const std::string& name, const Pixels8& pixels, const std::string& caption);
  /// Writes NAME.md; returns its file name.
  std::string finish();

  static constexpr size_t kSmall_bytes = 100'000;

 private:
  std::string folder_, name_, text_;
};

/// The table as it stands on a page; what is in the first column is set left, all else right.
std::string markdownTable(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows);

/// Half as large each way, every pixel the mean of four; an odd last row or column is left out.
Pixels8 halved(const Pixels8& picture);
/// Every pixel as a square of n x n.
Pixels8 magnified(const Pixels8& picture, int n);
/// Pictures of equal height from left to right, with a small gap; 3 channels, over white.
Pixels8 sideBySide(const std::vector<Pixels8>& pictures);
/// Pictures of equal width one below the other, with a small gap.
Pixels8 stacked(const std::vector<Pixels8>& pictures);

}  // namespace loomlight
