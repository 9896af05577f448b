#include "app/export/pdf_profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#define POINTERHOLDER_TRANSITION 4
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>

#include "app/export/paper.h"
#include "render/colour/icc_profile.h"

namespace loomlight {
namespace {

std::string sheet() {
  Paper paper(100, 80);
  paper.text(10, 10, "Charmeuse", {});
  paper.fill(10, 20, 30, 10, Rgb(0.8f, 0.1f, 0.1f));
  paper.picture(10, 40, 20, 20, {2, 1, 3, {255, 0, 0, 0, 255, 0}});
  return paper.bytes("sheet.pdf");
}

std::string bytesOf(QPDFObjectHandle stream) {
  const auto data = stream.getStreamData();
  return {reinterpret_cast<const char*>(data->getBuffer()), data->getSize()};
}

/// By a library of its own: what the page's red, green and blue mean, and what the file was made for.
TEST(PdfProfile, NamesTheColoursOfEveryPage) {
  const std::string bytes = sheet();
  QPDF pdf;
  pdf.processMemoryFile("sheet", bytes.data(), bytes.size());
  int pages = 0;
  for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(pdf).getAllPages()) {
    ++pages;
    QPDFObjectHandle space = page.getAttribute("/Resources", false).getKey("/ColorSpace").getKey("/DefaultRGB");
    ASSERT_TRUE(space.isArray());
    EXPECT_EQ(space.getArrayItem(0).getName(), "/ICCBased");
    const IccProfile profile = iccProfile(bytesOf(space.getArrayItem(1)), "the sheet's");
    EXPECT_THAT(profile.description, testing::HasSubstr("sRGB"));
  }
  EXPECT_EQ(pages, 1);
  QPDFObjectHandle intent = pdf.getRoot().getKey("/OutputIntents").getArrayItem(0);
  EXPECT_EQ(intent.getKey("/OutputConditionIdentifier").getUTF8Value(), "sRGB IEC61966-2.1");
  EXPECT_NO_THROW(iccProfile(bytesOf(intent.getKey("/DestOutputProfile")), "the intent's"));
}

TEST(PdfProfile, KeepsWhatThePageShows) {
  const std::string bytes = sheet();
  QPDF pdf;
  pdf.processMemoryFile("sheet", bytes.data(), bytes.size());
  QPDFPageObjectHelper page = QPDFPageDocumentHelper(pdf).getAllPages().front();
  EXPECT_FALSE(page.getImages().empty());
  EXPECT_FALSE(page.getAttribute("/Resources", false).getKey("/Font").getKeys().empty());
}

}  // namespace
}  // namespace loomlight
