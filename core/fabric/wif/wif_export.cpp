#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/rgb.h"
#include "core/fabric/model/field_path.h"
#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/weave/draft_derivation.h"
#include "core/fabric/wif/draft_limits.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/wif/wif_thickness.h"
#include "core/fabric/wif/wif_writer.h"
#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/presets.h"
#include "core/fabric/yarn/yarn_reflectance.h"

namespace loomlight {
namespace {

/// Threads after which weave, colours and spacing repeat together; without the spacing, or the weave's own repeat,
/// where that is too many.
int commonRepeat(int weave, size_t sequence, const std::vector<double>& spacing, const char* threads,
                 std::vector<std::string>& remarks) {
  const int64_t both = std::lcm(static_cast<int64_t>(weave), static_cast<int64_t>(sequence));
  const int64_t all = std::lcm(both, int64_t{spacingRepeat(spacing)});
  if (all <= Weave::kMaxSide) return static_cast<int>(all);
  if (both <= Weave::kMaxSide) {
    remarks.push_back(
        fmt::format("The spacing repeats with the cloth only after {} {}; the file holds {} of them, after which it "
                    "begins anew.",
                    all, threads, both));
    return static_cast<int>(both);
  }
  const int fitting = Weave::kMaxSide / weave * weave;
  remarks.push_back(fmt::format("Weave and colours repeat together only after {} {}; the file holds {} of them.", both,
                                threads, fitting));
  return fitting;
}

void repeatTo(NumberLists& lists, int count) {
  const size_t period = lists.size();
  if (period == 0) return;
  lists.reserve(static_cast<size_t>(count));
  for (size_t i = period; i < static_cast<size_t>(count); ++i) lists.push_back(std::vector<int>(lists[i - period]));
}

Draft draftFor(const Fabric& fabric, int ends, int picks, const std::string& file, std::vector<std::string>& remarks) {
  Draft draft;
  if (fabric.draft) {
    draft = *fabric.draft;
  } else {
    draft = smallestDraft(fabric.weave);
    remarks.push_back(
        fmt::format("The cloth has no threading of its own; the smallest one has {} shafts and {} treadles.",
                    draft.shafts, draft.treadles));
  }
  for (NumberLists* lists : {&draft.threading, &draft.tieUp, &draft.treadling, &draft.liftplan}) sortLists(*lists);
  Draft treadled = draft;
  treadled.liftplan.clear();
  if (!draft.liftplan.empty() && !draft.treadling.empty() &&
      (draft.treadling.size() != draft.liftplan.size() || !(drawdown(treadled) == fabric.weave))) {
    draft.treadling.clear();
    remarks.push_back("The treadling weaves another cloth than the liftplan, and is not in the file.");
  }
  if (!draft.treadling.empty()) draft.tieUp.resize(static_cast<size_t>(draft.treadles));
  repeatTo(draft.threading, ends);
  repeatTo(draft.treadling, picks);
  repeatTo(draft.liftplan, picks);
  const FieldPath path(file);
  validateDraft(draft, path.at("draft"));
  return draft;
}

std::set<int> yarnsInUse(const Fabric& fabric) {
  std::set<int> used(fabric.warpSequence.begin(), fabric.warpSequence.end());
  used.insert(fabric.weftSequence.begin(), fabric.weftSequence.end());
  return used;
}

const Absorption& absorptionOf(const Fabric& fabric, int yarn) {
  return fabric.fibres[fabric.yarns[yarn].fibre].absorption_per_mm;
}

/// The number that a yarn came with, where it still has that colour.
std::optional<int> numberFromFile(const Fabric& fabric, int yarn, const WifPalette& palette) {
  if (!fabric.wif || static_cast<size_t>(yarn) >= fabric.wif->yarns.size()) return std::nullopt;
  const WifYarn& given = fabric.wif->yarns[yarn];
  const bool isThere = given.colour == 0 || palette.colours.count(given.colour) > 0;
  return isThere && given.absorption_per_mm == absorptionOf(fabric, yarn) ? std::optional(given.colour) : std::nullopt;
}

/// A number for the colour of a yarn: of the palette where it has one that dyes the fibre just as it is, else a free
/// one.
int numberInPalette(const Fabric& fabric, int yarn, WifPalette& palette, const std::string& file) {
  const Fibre& fibre = fabric.fibres[fabric.yarns[yarn].fibre];
  const auto there = std::find_if(palette.colours.begin(), palette.colours.end(), [&](const auto& entry) {
    return dyed(fibre, linearFromSrgb(palette.srgb(entry.second))).absorption_per_mm == fibre.absorption_per_mm;
  });
  if (there != palette.colours.end()) return there->first;
  std::set<int> taken;
  for (const auto& [number, colour] : palette.colours) taken.insert(number);
  const std::optional<int> free = freeWifNumber(taken);
  if (!free)
    throw InputError(fmt::format("{}: [COLOR TABLE]: expected a free number up to {} for another colour, got none",
                                 file, kMaxWifNumber));
  const Rgb shown = fibreReflectance(fibre);
  palette.colours[*free] = palette.nearest(srgbFromLinear(shown));
  return *free;
}

/// A number of the palette for every yarn in use; yarns of one colour share it. Yarns that came without a colour stay
/// so, unless another yarn has been dyed since: then they would take that yarn's colour in other programs.
std::vector<int> numbersOfYarns(const Fabric& fabric, WifPalette& palette, const std::string& file) {
  const std::set<int> used = yarnsInUse(fabric);
  const bool asInFile = std::all_of(used.begin(), used.end(),
                                    [&](int yarn) { return numberFromFile(fabric, yarn, palette).has_value(); });
  std::vector<int> numbers(fabric.yarns.size(), 0);
  for (const int yarn : used) {
    const std::optional<int> known = numberFromFile(fabric, yarn, palette);
    const auto like = std::find_if(used.begin(), used.end(), [&](int other) {
      return other < yarn && numbers[other] > 0 && absorptionOf(fabric, other) == absorptionOf(fabric, yarn);
    });
    if (known && (asInFile || *known > 0))
      numbers[yarn] = *known;
    else
      numbers[yarn] = like != used.end() ? numbers[*like] : numberInPalette(fabric, yarn, palette, file);
  }
  return numbers;
}

double tidyCentimetres(double mm) {
  return std::max(1e-6, std::round(mm * 1e5) / 1e6);
}

/// The sizes that the fabric has: its spacing, and the yarns' diameters.
WifSizes ownSizes(const Fabric& fabric, System system, int threads) {
  WifSizes sizes;
  const double pitch_mm = fabric.pitch_mm(system);
  sizes.spacing = tidyCentimetres(pitch_mm);
  if (const std::vector<double>& spacing = fabric.spacing(system); !displacements(spacing).empty()) {
    const auto count = static_cast<double>(spacing.size());
    const double unit_mm = pitch_mm * count / std::accumulate(spacing.begin(), spacing.end(), 0.0);
    for (int thread = 0; thread < threads; ++thread)
      sizes.spacings[thread + 1] = tidyCentimetres(unit_mm * spacing[static_cast<size_t>(thread) % spacing.size()]);
  }
  bool same = true;
  for (int thread = 0; thread < threads; ++thread) {
    const Yarn& yarn = fabric.yarns[system == System::warp ? fabric.warpYarn(thread) : fabric.weftYarn(thread)];
    const double thickness = tidyCentimetres(yarnDiameter_mm(yarn, meanFibre(yarn, fabric.fibres)));
    if (thread == 0) sizes.thickness = thickness;
    same = same && thickness == *sizes.thickness;
    sizes.thicknesses[thread + 1] = thickness;
  }
  if (same && sizes.spacings.empty()) sizes.thicknesses.clear();  // else they say that spacing means no thickness
  return sizes;
}

bool nearly(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::abs(b);
}

/// What a cloth had in one system when it was read.
struct AsRead {
  double threads_per_cm = 0;
  double diameter_mm = 0;
  int threads = 0;
  std::vector<double> diameters_mm, spacing;  ///< as WifOrigin has them
};

AsRead asRead(const Fabric& fabric, System system) {
  if (!fabric.wif) return {};
  const WifOrigin& origin = *fabric.wif;
  if (system == System::warp)
    return {origin.ends_per_cm, origin.warpDiameter_mm, origin.ends, origin.warpDiameters_mm, origin.warpSpacing};
  return {origin.picks_per_cm, origin.weftDiameter_mm, origin.picks, origin.weftDiameters_mm, origin.weftSpacing};
}

/// Whether the threads are as many as were read, and each as thick as it was.
bool hasItsThreads(const Fabric& fabric, System system, int threads, const AsRead& read) {
  if (threads != read.threads) return false;
  if (read.diameters_mm.empty()) return true;
  const std::vector<double> now = threadDiameters_mm(fabric, system);
  for (size_t thread = 0; thread < static_cast<size_t>(threads); ++thread)
    if (!nearly(now[thread % now.size()], read.diameters_mm[thread % read.diameters_mm.size()])) return false;
  return true;
}

/// What the file said of a system's sizes where the fabric has not been given others since, its own sizes where it has.
void setSizes(const Fabric& fabric, System system, int threads, WifSizes& sizes, std::vector<std::string>& remarks) {
  const AsRead read = asRead(fabric, system);
  const bool isWarp = system == System::warp;
  const bool isUntouched = nearly(isWarp ? fabric.ends_per_cm : fabric.picks_per_cm, read.threads_per_cm) &&
                           nearly(meanDiameter_mm(fabric, system), read.diameter_mm) &&
                           fabric.spacing(system) == read.spacing;
  if (!isUntouched || sizes == WifSizes{}) {
    if (unevenSpacing(sizes, read.threads, "", false) && fabric.spacing(system).empty())
      remarks.push_back(
          fmt::format("{} lay unevenly in the file that the cloth is from; sett or yarns are others "
                      "now, and all are written at one distance.",
                      isWarp ? "Ends" : "Picks"));
    else if (hasGaps(sizes, read.threads))
      remarks.push_back(
          fmt::format("Only some {} had a spacing or a thickness in the file that the cloth is from; sett or yarns are "
                      "others now, and are written as they are.",
                      isWarp ? "ends" : "picks"));
  } else if (sizes.hasSingle() && !hasItsThreads(fabric, system, threads, read)) {
    remarks.push_back(
        fmt::format("Spacing and thickness of single {} in the file that the cloth is from are those of other threads "
                    "than it has now; it is written with its own sett and yarns.",
                    isWarp ? "ends" : "picks"));
  } else {
    return;
  }
  sizes = ownSizes(fabric, system, threads);
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t start = 0; start < text.size();) {
    const size_t end = std::min(text.find('\n', start), text.size());
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
    if (start == text.size()) lines.emplace_back();  // the text ends in a line end: one more line, with nothing on it
  }
  return lines;
}

}  // namespace

WifExport wifFromFabric(const Fabric& fabric, const std::string& file) {
  WifExport exported;
  WifDocument document;
  document.title = fabric.name;
  document.notes = linesOf(fabric.description);
  if (fabric.wif) document.rest = fabric.wif->rest;
  const int ends =
      commonRepeat(fabric.weave.ends(), fabric.warpSequence.size(), fabric.warpSpacing, "ends", exported.remarks);
  const int picks =
      commonRepeat(fabric.weave.picks(), fabric.weftSequence.size(), fabric.weftSpacing, "picks", exported.remarks);
  document.draft = draftFor(fabric, ends, picks, file, exported.remarks);
  const std::vector<int> numbers = numbersOfYarns(fabric, document.rest.palette, file);
  for (int end = 0; end < ends; ++end) document.warpColours.push_back(numbers[fabric.warpYarn(end)]);
  for (int pick = 0; pick < picks; ++pick) document.weftColours.push_back(numbers[fabric.weftYarn(pick)]);
  setSizes(fabric, System::warp, ends, document.rest.warp, exported.remarks);
  setSizes(fabric, System::weft, picks, document.rest.weft, exported.remarks);
  exported.text = wifFromDocument(document);
  return exported;
}

std::vector<std::string> writeWifFabric(const Fabric& fabric, const std::string& file) {
  validate(fabric, file);
  WifExport exported = wifFromFabric(fabric, file);
  writeFileAtomically(file, exported.text);
  return std::move(exported.remarks);
}

}  // namespace loomlight
