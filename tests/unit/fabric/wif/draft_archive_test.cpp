#include "core/fabric/wif/draft_archive.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zip.h>

#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/wif/wif_sections.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/fabric/wif/wif_drafts.h"

namespace loomlight {
namespace {

using testing::HasSubstr;

using Entries = std::vector<std::pair<const char*, std::string>>;

/// A ZIP archive of these names and contents, deflated.
std::string archiveOf(const Entries& entries) {
  zip_source_t* const made = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  zip_source_keep(made);  // it outlives the archive, which takes one of the two
  zip_t* const archive = zip_open_from_source(made, ZIP_TRUNCATE, nullptr);
  for (const auto& [name, content] : entries)
    zip_file_add(archive, name, zip_source_buffer(archive, content.data(), content.size(), 0), 0);
  EXPECT_EQ(zip_close(archive), 0);
  zip_stat_t stat;
  EXPECT_EQ(zip_source_open(made), 0);
  EXPECT_EQ(zip_source_stat(made, &stat), 0);
  std::string bytes(stat.size, '\0');
  EXPECT_EQ(zip_source_read(made, bytes.data(), bytes.size()), static_cast<zip_int64_t>(bytes.size()));
  zip_source_close(made);
  zip_source_free(made);
  return bytes;
}

const char* const kDraft = "twamain.waf";

/// Of TempoWeave, by its own sections and by what else lies in the archive.
std::string tempoWeaveFile() {
  return archiveOf({{"writeup.html", "<p>A twill</p>"}, {kDraft, twillFile() + "\n[TW GENERAL]\nGauge=3\n"}});
}

std::string refusal(const std::string& bytes) {
  return test::messageOf<InputError>([&] { draftOfArchive(bytes, "x.twa"); });
}

TEST(DraftArchive, IsReadAsTheDraftInIt) {
  const std::string bytes = tempoWeaveFile();
  ASSERT_TRUE(isDraftArchive(bytes));
  EXPECT_FALSE(isDraftArchive(twillFile()));
  const WifImport import = fabricFromWif(bytes, "x.twa", Fabric{}, WifSizeChoice::keep);
  const WifImport plain = fabricFromWif(twillFile(), "x.twa", Fabric{}, WifSizeChoice::keep);
  EXPECT_EQ(import.fabric.weave, plain.fabric.weave);
  EXPECT_EQ(import.fabric.draft, plain.fabric.draft);
}

TEST(DraftArchive, WithoutADraftIsRefused) {
  EXPECT_THAT(refusal(archiveOf({{"other.wif", twillFile()}})), HasSubstr("x.twa: expected an archive of TempoWeave"));
  EXPECT_THAT(refusal(archiveOf({{"other.wif", twillFile()}})), HasSubstr("got one without twamain.waf"));
  EXPECT_EQ(draftOfArchive(archiveOf({{"TWAMAIN.WAF", twillFile()}}), "x.twa"), twillFile())
      << "a name as another system has written it";
  EXPECT_THAT(refusal("PK\x03\x04 and then nothing"), HasSubstr("x.twa: expected an archive of TempoWeave (.twa): "));
}

TEST(DraftArchive, ThatBecomesTooLargeIsRefusedBeforeItIs) {
  const std::string small = archiveOf({{kDraft, std::string(kMaxWifBytes + 1, ' ')}});
  EXPECT_LT(small.size(), kMaxWifBytes / 100);
  EXPECT_THAT(refusal(small), HasSubstr("twamain.waf: expected at most 32000000 bytes, got 32000001"));
}

/// Names that one table of the library holds in one place would take it minutes.
TEST(DraftArchive, OfManyFilesIsRefusedBeforeTheyAreLookedAt) {
  Entries entries{{kDraft, twillFile()}};
  std::vector<std::string> names(1000);
  for (size_t i = 0; i < names.size(); ++i) names[i] = "section" + std::to_string(i);
  for (size_t i = 1; i < names.size(); ++i) entries.emplace_back(names[i].c_str(), "");
  EXPECT_EQ(draftOfArchive(archiveOf(entries), "x.twa"), twillFile());
  entries.emplace_back(names[0].c_str(), "");
  EXPECT_THAT(refusal(archiveOf(entries)),
              HasSubstr("x.twa: expected an archive of TempoWeave (.twa): it has more than "
                        "1000 files"));
}

/// The list at its end says how long the draft is, in bytes 24 to 27 of its line.
TEST(DraftArchive, OfAnotherLengthThanItsListSaysIsRefused) {
  const std::string whole = archiveOf({{kDraft, twillFile()}});
  const size_t length = whole.find("PK\x01\x02") + 24;
  for (const auto& [change, got] : {std::pair(1, "fewer"), std::pair(-1, "more")}) {
    std::string bytes = whole;
    bytes[length] = static_cast<char>(bytes[length] + change);
    EXPECT_THAT(refusal(bytes), HasSubstr(fmt::format("bytes of twamain.waf, got {}", got)));
  }
}

TEST(DraftArchive, DamagedAnywhereIsRefusedOrTheSame) {
  const std::string whole = tempoWeaveFile(), draft = draftOfArchive(whole, "x.twa");
  int refused = 0;
  for (size_t at = 0; at < whole.size(); ++at)
    for (const int bit : {0, 3, 7}) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
      try {
        EXPECT_EQ(draftOfArchive(bytes, "x.twa"), draft) << "bit " << bit << " of byte " << at;
      } catch (const InputError&) {
        ++refused;
      }
      try {
        draftOfArchive(whole.substr(0, at), "x.twa");
        ADD_FAILURE() << "cut off behind " << at << " bytes";
      } catch (const InputError&) {
      }
    }
  EXPECT_GT(refused, static_cast<int>(draft.size()) / 4) << "hardly any damage is seen";
}

}  // namespace
}  // namespace loomlight
