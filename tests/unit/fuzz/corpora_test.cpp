#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "tests/fuzz/fuzzers.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {
namespace fs = std::filesystem;

struct Corpus {
  const char* folder;
  void (*fuzz)(std::string_view);
};

/// Every fuzzer does without a finding what its corpus has, where inputs stay that once were one.
class Corpora : public testing::TestWithParam<Corpus> {};

TEST_P(Corpora, AreWithoutAFinding) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(LOOMLIGHT_CORPORA) / GetParam().folder))
    files.push_back(entry.path());
  ASSERT_FALSE(files.empty());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename().string());
    EXPECT_NO_THROW(GetParam().fuzz(test::bytesOf(file.string())));
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpora,
                         testing::Values(Corpus{"drafts", fuzz::fuzzDrafts}, Corpus{"fabrics", fuzz::fuzzFabrics},
                                         Corpus{"palettes", fuzz::fuzzPalettes}, Corpus{"swatches", fuzz::fuzzSwatches},
                                         Corpus{"spectra", fuzz::fuzzSpectra}, Corpus{"meshes", fuzz::fuzzMeshes},
                                         Corpus{"exr", fuzz::fuzzExr}, Corpus{"png", fuzz::fuzzPng},
                                         Corpus{"command_line", fuzz::fuzzCommandLine},
                                         Corpus{"edits", fuzz::fuzzEdits}, Corpus{"rebuilds", fuzz::fuzzRebuilds}),
                         [](const auto& corpus) { return std::string(corpus.param.folder); });

}  // namespace
}  // namespace loomlight
