#include "app/export/sheet/pdf_profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <qpdf/qpdf-c.h>

#include <cstdlib>
#include <string>

#include "app/export/sheet/paper.h"
#include "core/base/file.h"
#include "render/colour/icc_profile.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

/// A sheet as it is written, read again.
class PdfProfile : public testing::Test {
 protected:
  void SetUp() override {
    Paper paper(100, 80);
    paper.text(10, 10, "Charmeuse", {});
    paper.fill(10, 20, 30, 10, Rgb(0.8f, 0.1f, 0.1f));
    paper.picture(10, 40, 20, 20, {2, 1, 3, {255, 0, 0, 0, 255, 0}});
    const test::ScratchFolder folder;
    paper.write(folder.file("sheet.pdf"));
    bytes = readFile(folder.file("sheet.pdf"), 10'000'000);
    ASSERT_EQ(qpdf_read_memory(pdf, "sheet", bytes.data(), bytes.size(), nullptr), QPDF_SUCCESS);
    ASSERT_EQ(qpdf_get_num_pages(pdf), 1);
    resources = at(qpdf_get_page_n(pdf, 0), "/Resources");
  }
  void TearDown() override { qpdf_cleanup(&pdf); }

  qpdf_oh at(qpdf_oh object, const char* key) const { return qpdf_oh_get_key(pdf, object, key); }
  std::string bytesOf(qpdf_oh stream) const {
    unsigned char* data = nullptr;
    size_t size = 0;
    qpdf_oh_get_stream_data(pdf, stream, qpdf_dl_generalized, nullptr, &data, &size);
    std::string read(reinterpret_cast<const char*>(data), size);
    std::free(data);
    return read;
  }

  qpdf_data pdf = qpdf_init();
  std::string bytes;
  qpdf_oh resources = 0;
};

TEST_F(PdfProfile, NamesTheColoursOfThePage) {
  const qpdf_oh space = at(at(resources, "/ColorSpace"), "/DefaultRGB");
  ASSERT_TRUE(qpdf_oh_is_array(pdf, space));
  EXPECT_STREQ(qpdf_oh_get_name(pdf, qpdf_oh_get_array_item(pdf, space, 0)), "/ICCBased");
  const IccProfile profile = iccProfile(bytesOf(qpdf_oh_get_array_item(pdf, space, 1)), "the sheet's");
  EXPECT_THAT(profile.description, testing::HasSubstr("sRGB"));
}

TEST_F(PdfProfile, SaysWhatTheFileWasMadeFor) {
  const qpdf_oh intent = qpdf_oh_get_array_item(pdf, at(qpdf_get_root(pdf), "/OutputIntents"), 0);
  EXPECT_STREQ(qpdf_oh_get_utf8_value(pdf, at(intent, "/OutputConditionIdentifier")), "sRGB IEC61966-2.1");
  EXPECT_NO_THROW(iccProfile(bytesOf(at(intent, "/DestOutputProfile")), "the intent's"));
}

TEST_F(PdfProfile, KeepsWhatThePageShows) {
  for (const char* kind : {"/Font", "/XObject"}) {
    qpdf_oh_begin_dict_key_iter(pdf, at(resources, kind));
    EXPECT_TRUE(qpdf_oh_dict_more_keys(pdf)) << kind;
  }
}

}  // namespace
}  // namespace loomlight
