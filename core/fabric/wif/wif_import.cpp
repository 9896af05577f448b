#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "core/base/file.h"
#include "core/base/utf8.h"
#include "core/fabric/model/check.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/wif/draft_archive.h"
#include "core/fabric/wif/dtx_reader.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/wif/wif_reader.h"
#include "core/fabric/wif/wif_thickness.h"
#include "core/fabric/wif/wif_yarns.h"

namespace loomlight {
namespace {

using Warnings = std::vector<WifWarning>;

/// As much of a text as a fabric takes, in whole characters.
std::string fitting(std::string text, const char* what, Warnings& warnings) {
  if (text.size() <= kMaxText) return text;
  warnings.push_back({fmt::format("The {} of the file is too long; its end is cut off.", what), {}, WifConcern::file});
  text.resize(wholeCharacters(text, kMaxText).size());
  return text;
}

}  // namespace

WifImport fabricFromWif(std::string_view bytes, const std::string& source, const Fabric& mine, WifSizeChoice sizes) {
  std::string unpacked;
  if (isDraftArchive(bytes)) bytes = unpacked = draftOfArchive(bytes, source);
  WifWarnings wifWarnings;
  WifDocument document = isDtx(bytes) ? readDtx(bytes, source, wifWarnings) : readWif(bytes, source, wifWarnings);
  WifImport import{mine, wifWarnings.list(), document.named};
  Fabric& fabric = import.fabric;
  fabric.name = document.title.empty() ? std::filesystem::path(source).stem().string()
                                       : fitting(document.title, "title", import.warnings);
  fabric.description = fitting(fmt::format("{}", fmt::join(document.notes, "\n")), "text of notes", import.warnings);
  fabric.weave = drawdown(document.draft);

  WifOrigin origin;
  origin.yarns = dressThreads(fabric, document, import.warnings);
  const int ends = sizedThreads(document.rest.warp, document.ends(), document.named.ends);
  const int picks = sizedThreads(document.rest.weft, document.picks(), document.named.picks);
  fabric.warpSpacing = spacingOf(document.rest.warp, document.ends());
  fabric.weftSpacing = spacingOf(document.rest.weft, document.picks());
  for (const auto& uneven : {unevenSpacing(document.rest.warp, ends, "Ends", !fabric.warpSpacing.empty()),
                             unevenSpacing(document.rest.weft, picks, "Picks", !fabric.weftSpacing.empty())})
    if (uneven) import.warnings.push_back(*uneven);

  origin.program = fitting(document.program, "name of the program", import.warnings);
  origin.ends = document.ends();
  origin.picks = document.picks();
  origin.rest = std::move(document.rest);
  fabric.draft = std::move(document.draft);
  fabric.wif = withSizesOf(std::move(origin), fabric);
  if (sizes == WifSizeChoice::file) fabric = withWifSizes(std::move(fabric), import.warnings);
  validate(fabric, source);
  sortByConcern(import.warnings);
  return import;
}

WifImport readWifFabric(const std::string& file, const Fabric& mine, WifSizeChoice sizes) {
  return fabricFromWif(readFile(file, kMaxWifBytes), file, mine, sizes);
}

}  // namespace loomlight
