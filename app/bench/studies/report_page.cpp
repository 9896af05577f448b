#include "app/bench/studies/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/file.h"

namespace loomlight {
namespace {

constexpr int kGap = 4;  // pixels between pictures

std::string markdownRow(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += fmt::format(" {} |", cell);
  return row + "\n";
}

/// Cells with commas in quotes (RFC 4180); no cell of ours holds a quote.
std::string csvRow(const std::vector<std::string>& cells) {
  std::string row;
  for (const std::string& cell : cells) {
    if (!row.empty()) row += ',';
    row += cell.find(',') == std::string::npos ? cell : fmt::format("\"{}\"", cell);
  }
  return row + "\n";
}

Pixels8 whitePage(int width, int height) {
  Pixels8 page{width, height, 3, {}};
  page.bytes.assign(static_cast<size_t>(width) * height * 3, 255);
  return page;
}

void paste(const Pixels8& picture, int x0, int y0, Pixels8& page) {
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const uint8_t* from = &picture.bytes[(static_cast<size_t>(y) * picture.width + x) * picture.channels];
      uint8_t* to = &page.bytes[(static_cast<size_t>(y0 + y) * page.width + x0 + x) * 3];
      if (picture.channels == 4 && from[3] == 0) continue;
      std::copy_n(from, 3, to);
    }
}

void writeSmallPng(const std::string& file, Pixels8 pixels) {
  writePng(file, pixels);
  while (std::filesystem::file_size(file) > ReportPage::kSmall_bytes) {
    pixels = halved(pixels);
    writePng(file, pixels);
  }
}

}  // namespace

std::string markdownTable(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows) {
  std::string text = markdownRow(header) + "|---|";
  for (size_t i = 1; i < header.size(); ++i) text += "---:|";
  text += "\n";
  for (const auto& row : rows) text += markdownRow(row);
  return text;
}

ReportPage::ReportPage(std::string folder, std::string name, const std::string& title)
    : folder_(std::move(folder)), name_(std::move(name)), text_(fmt::format("# {}\n", title)) {
  std::error_code error;
  std::filesystem::create_directories(folder_ + "/small", error);
  if (error) throw InputError(fmt::format("{}: expected a folder that can be made: {}", folder_, error.message()));
}

void ReportPage::heading(const std::string& text) {
  text_ += fmt::format("\n## {}\n", text);
}

void ReportPage::paragraph(const std::string& text) {
  text_ += fmt::format("\n{}\n", text);
}

void ReportPage::table(const std::string& name, const std::vector<std::string>& header,
                       const std::vector<std::vector<std::string>>& rows) {
  text_ += '\n';
  text_ += markdownTable(header, rows);
  csv(name, header, rows);
}

void ReportPage::csv(const std::string& name, const std::vector<std::string>& header,
                     const std::vector<std::vector<std::string>>& rows) {
  std::string text = csvRow(header);
  for (const auto& row : rows) {
    assert(row.size() == header.size());
    text += csvRow(row);
  }
  writeFileAtomically(folder_ + "/" + name + ".csv", text);
}

void ReportPage::picture(const std::string& name, const Pixels8& pixels, const std::string& caption) {
  writePng(folder_ + "/" + name + ".png", pixels);
  writeSmallPng(folder_ + "/small/" + name + ".png", pixels);
  text_ += fmt::format("\n![{0}]({1}.png)\n\n{0}\n", caption, name);
}

std::string ReportPage::finish() {
  const std::string file = folder_ + "/" + name_ + ".md";
  writeFileAtomically(file, text_);
  return file;
}

Pixels8 halved(const Pixels8& picture) {
  Pixels8 half{std::max(1, picture.width / 2), std::max(1, picture.height / 2), picture.channels, {}};
  const auto at = [&](int x, int y, int channel) -> int {
    const auto row = static_cast<size_t>(std::min(y, picture.height - 1)),
               column = static_cast<size_t>(std::min(x, picture.width - 1));
    return picture.bytes[(row * static_cast<size_t>(picture.width) + column) * static_cast<size_t>(picture.channels) +
                         static_cast<size_t>(channel)];
  };
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int c = 0; c < half.channels; ++c) {
        const int sum =
            at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) + at(2 * x, 2 * y + 1, c) + at(2 * x + 1, 2 * y + 1, c);
        half.bytes.push_back(static_cast<uint8_t>((sum + 2) / 4));
      }
  return half;
}

Pixels8 magnified(const Pixels8& picture, int n) {
  Pixels8 large{picture.width * n, picture.height * n, picture.channels, {}};
  for (int y = 0; y < large.height; ++y)
    for (int x = 0; x < large.width; ++x) {
      const size_t pixel = static_cast<size_t>(y / n) * static_cast<size_t>(picture.width) + static_cast<size_t>(x / n);
      const auto channels = static_cast<size_t>(picture.channels);
      const uint8_t* from = &picture.bytes[pixel * channels];
      large.bytes.insert(large.bytes.end(), from, from + channels);
    }
  return large;
}

Pixels8 sideBySide(const std::vector<Pixels8>& pictures) {
  int width = -kGap, height = 0;
  for (const Pixels8& picture : pictures) {
    width += picture.width + kGap;
    height = std::max(height, picture.height);
  }
  Pixels8 page = whitePage(width, height);
  int x = 0;
  for (const Pixels8& picture : pictures) {
    paste(picture, x, 0, page);
    x += picture.width + kGap;
  }
  return page;
}

Pixels8 stacked(const std::vector<Pixels8>& pictures) {
  int width = 0, height = -kGap;
  for (const Pixels8& picture : pictures) {
    width = std::max(width, picture.width);
    height += picture.height + kGap;
  }
  Pixels8 page = whitePage(width, height);
  int y = 0;
  for (const Pixels8& picture : pictures) {
    paste(picture, 0, y, page);
    y += picture.height + kGap;
  }
  return page;
}

}  // namespace loomlight
