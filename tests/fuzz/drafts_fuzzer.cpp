#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/wif/dtx_reader.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/wif/wif_reader.h"
#include "core/fabric/wif/wif_writer.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/fuzzers.h"

namespace loomlight::fuzz {
namespace {

/// A few bytes can ask for 16384 threads a side. Such drafts are read, but not written, so that a run stays short.
constexpr int kMostThreads = 1000;

void expectTold(const std::vector<WifWarning>& warnings) {
  constexpr size_t kMostWarnings = 400, kLongest = 600;
  expect(warnings.size() < kMostWarnings, fmt::format("{} warnings", warnings.size()));
  for (const WifWarning& warning : warnings)
    expect(inOneLine(warning).size() < kLongest, "a warning is too long: " + inOneLine(warning));
}

/// What is read is written strictly, and read again as the same. A draft that lifts nothing is warned of both times.
void writeDocument(std::string_view bytes) {
  WifWarnings warnings;
  WifDocument document = isDtx(bytes) ? readDtx(bytes, "a.wif", warnings) : readWif(bytes, "a.wif", warnings);
  expectTold(warnings.list());
  if (std::max(document.ends(), document.picks()) > kMostThreads) return;
  const std::string text = wifFromDocument(document);
  WifDocument again = readWif(text, "a.wif", warnings);
  again.program = document.program;
  again.named = document.named;
  expect(wifFromDocument(again) == text, "the same document is written otherwise");
  expect(again.draft == document.draft, "the draft is written as another");
  expect(again.warpColours == document.warpColours && again.weftColours == document.weftColours,
         "the colours are written as others");
  expect(again.rest.palette == document.rest.palette, "the palette is written as another");
  expect(again.title == document.title && again.notes == document.notes, "title or notes are written as others");
}

/// What is cut is a fabric, and has of the whole what it keeps. Threads that were cut off are named by no line, so that
/// they all are alike.
void cutFabric(const Fabric& whole, const WifNamed& named) {
  const Fabric cut = cutToNamed(whole, named);
  expect(isRead("a.wif", [&] { validate(cut, "a.wif"); }), "what is cut is no fabric");
  const int ends = cut.weave.ends(), picks = cut.weave.picks();
  expect(ends <= whole.weave.ends() && picks <= whole.weave.picks(), "what is cut has more threads");
  bool sameYarns = true, sameWeave = true, cutsNone = true;
  for (int end = 0; end < ends; ++end) sameYarns = sameYarns && cut.warpYarn(end) == whole.warpYarn(end);
  for (int pick = 0; pick < picks; ++pick) sameYarns = sameYarns && cut.weftYarn(pick) == whole.weftYarn(pick);
  for (int pick = 0; pick < whole.weave.picks(); ++pick)
    for (int end = 0; end < whole.weave.ends(); ++end) {
      const bool up = whole.weave.at(pick, end);
      if (pick < picks && end < ends) sameWeave = sameWeave && cut.weave.at(pick, end) == up;
      if (pick >= picks) cutsNone = cutsNone && whole.weave.at(picks, end) == up;
      if (end >= ends) cutsNone = cutsNone && whole.weave.at(pick, ends) == up;
    }
  expect(sameYarns, "what is cut has threads of other yarns");
  expect(sameWeave, "what is cut is woven otherwise");
  expect(cutsNone, "threads are cut off that the draft names");
}

void makeFabric(std::string_view bytes) {
  const WifImport import = fabricFromWif(bytes, "a.wif", Fabric{}, WifSizeChoice::file);
  expectTold(import.warnings);
  expectTold(otherWifSizes(import.fabric));
  if (std::max(import.fabric.weave.ends(), import.fabric.weave.picks()) > kMostThreads) return;
  cutFabric(import.fabric, import.named);
  expect(fabricFromJson(fabricToJson(import.fabric), "a.json") == import.fabric, "the fabric's file is of another");
  const Fabric again =
      fabricFromWif(wifFromFabric(import.fabric, "a.wif").text, "a.wif", Fabric{}, WifSizeChoice::file).fabric;
  expect(again.weave == import.fabric.weave, "the fabric is written as another weave");
}

}  // namespace

void fuzzDrafts(std::string_view bytes) {
  isRead("a.wif", [&] { writeDocument(bytes); });
  isRead("a.wif", [&] { makeFabric(bytes); });
}

}  // namespace loomlight::fuzz
