#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <tuple>

#include "core/base/file.h"
#include "core/base/rgb.h"
#include "core/base/utf8.h"
#include "core/fabric/model/check.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/yarn_count.h"
#include "core/fabric/wif/wif_fabric.h"
#include "core/fabric/wif/wif_reader.h"
#include "core/fabric/yarn/derived.h"
#include "core/fabric/yarn/presets.h"

namespace loomlight {
namespace {

using Warnings = std::vector<WifWarning>;

/// As many digits as files of such figures have.
double tidy(double value) {
  return std::strtod(fmt::format("{:.5g}", value).c_str(), nullptr);
}

/// What most threads have.
template <class Value>
Value mostCommon(const std::vector<Value>& values) {
  std::map<Value, int> counts;
  for (const Value& value : values) ++counts[value];
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

std::optional<double> usualThickness_mm(const WifSizes& sizes, int threads) {
  std::vector<double> known;
  for (int thread = 1; thread <= threads; ++thread)
    if (const auto thickness = sizes.thickness_mm(thread)) known.push_back(*thickness);
  return known.empty() ? std::nullopt : std::optional(mostCommon(known));
}

/// The yarn with `factor` times its mass per length, as far as a yarn can have it; `held` tells that it cannot.
Yarn heavier(Yarn yarn, const Fibre& fibre, double factor, bool& held) {
  const double inYarn = fibresInYarn(yarn, fibre);
  const double most = std::min(factor, 0.999 * kMaxFibresInYarn / inYarn);
  if (yarn.fibresPerPly) {
    const FieldInfo range = fieldInfo(&Yarn::fibresPerPly);
    const double wanted = std::floor(*yarn.fibresPerPly * most + 0.5);
    yarn.fibresPerPly = static_cast<int>(std::clamp(wanted, range.min, range.max));
    held = held || most < factor || wanted < range.min || wanted > range.max;
  } else {
    const FieldInfo range = fieldInfo(&Yarn::count_tex);
    const double wanted = yarn.count_tex * most;
    yarn.count_tex = tidy(std::clamp(wanted, range.min, range.max));
    held = held || most < factor || wanted < range.min || wanted > range.max;
  }
  return yarn;
}

void noteHeldYarns(Warnings& warnings) {
  warnings.push_back(
      {"The file has yarns thicker or thinner than a yarn can be here; they are held to what it can.", {}});
}

/// A yarn of the fabric to be: one of mine, dyed in a colour of the palette, and perhaps thicker.
struct Kind {
  int base = 0;         ///< in mine.yarns
  int system = 0;       ///< 1 for the weft where its yarn is not that of the warp
  int colour = 0;       ///< 0: mine
  int permille = 1000;  ///< of the usual diameter
  auto key() const { return std::tie(base, system, colour, permille); }
  friend bool operator<(const Kind& a, const Kind& b) { return a.key() < b.key(); }
};

std::vector<Kind> kindsOfThreads(const std::vector<int>& colours, const WifSizes& sizes, int base, int system) {
  const auto threads = static_cast<int>(colours.size());
  const std::optional<double> usual = usualThickness_mm(sizes, threads);
  std::vector<Kind> kinds;
  for (int thread = 1; thread <= threads; ++thread) {
    const double ratio = usual ? sizes.thickness_mm(thread).value_or(*usual) / *usual : 1.0;
    constexpr double kMostRatio = 1000.0;
    const double held = std::clamp(ratio, 1.0 / kMostRatio, kMostRatio);
    kinds.push_back({base, system, colours[thread - 1], static_cast<int>(std::lround(1000.0 * held))});
  }
  return kinds;
}

/// Leaves at most kMaxKinds kinds of yarn: first all of one thickness, then rare colours as their nearest.
void reduceKinds(std::vector<Kind>& warp, std::vector<Kind>& weft, const WifPalette& palette, Warnings& warnings) {
  const auto counted = [&] {
    std::map<Kind, int> counts;
    for (const auto* kinds : {&warp, &weft})
      for (const Kind& kind : *kinds) ++counts[kind];
    return counts;
  };
  std::map<Kind, int> counts = counted();
  if (counts.size() <= static_cast<size_t>(kMaxKinds)) return;
  warnings.push_back(
      {fmt::format("The threads have {} combinations of colour and thickness, a fabric has at most {} yarns; all "
                   "threads of a colour get the usual thickness, rare colours the nearest.",
                   counts.size(), kMaxKinds),
       {}});
  for (auto* kinds : {&warp, &weft})
    for (Kind& kind : *kinds) kind.permille = 1000;
  counts = counted();
  std::vector<std::pair<Kind, int>> byUse(counts.begin(), counts.end());
  std::stable_sort(byUse.begin(), byUse.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  const auto colourOf = [&palette](const Kind& kind) {
    return kind.colour > 0 ? palette.srgb(palette.colours.at(kind.colour)) : Rgb(1.0f);
  };
  std::map<Kind, Kind> instead;
  for (size_t i = kMaxKinds; i < byUse.size(); ++i) {
    const Kind& rare = byUse[i].first;
    const auto distance = [&](const Kind& kind) {
      const Rgb d = colourOf(kind) - colourOf(rare);
      return glm::dot(d, d);
    };
    instead[rare] = std::min_element(byUse.begin(), byUse.begin() + kMaxKinds, [&](const auto& a, const auto& b) {
                      return distance(a.first) < distance(b.first);
                    })->first;
  }
  for (auto* kinds : {&warp, &weft})
    for (Kind& kind : *kinds)
      if (const auto found = instead.find(kind); found != instead.end()) kind = found->second;
}

/// The shortest sequence that goes on in the same way for ever and fits the repeat.
std::vector<int> shortest(std::vector<int> sequence) {
  const size_t n = sequence.size();
  for (size_t period = 1; period <= n / 2; ++period) {
    if (n % period != 0) continue;
    if (std::equal(sequence.begin() + static_cast<long>(period), sequence.end(), sequence.begin())) {
      sequence.resize(period);
      return sequence;
    }
  }
  return sequence;
}

/// Gives the fabric, which is a copy of mine, the yarns of these threads.
void dressThreads(Fabric& fabric, const std::vector<Kind>& warp, const std::vector<Kind>& weft,
                  const WifPalette& palette, Warnings& warnings) {
  const std::vector<Yarn> myYarns = fabric.yarns;
  const std::vector<Fibre> myFibres = fabric.fibres;
  std::map<Kind, int> yarnOf;
  for (const auto* kinds : {&warp, &weft})
    for (const Kind& kind : *kinds) yarnOf.emplace(kind, 0);
  std::map<std::pair<int, int>, int> fibreOf;  // of mine, and colour
  fabric.yarns.clear();
  fabric.fibres.clear();
  bool held = false;
  for (auto& [kind, index] : yarnOf) {
    index = static_cast<int>(fabric.yarns.size());
    Yarn yarn = myYarns[kind.base];
    Fibre fibre = myFibres[yarn.fibre];
    const double diameters = kind.permille / 1000.0;
    if (kind.permille != 1000) yarn = heavier(yarn, fibre, diameters * diameters, held);
    const auto [known, isNew] = fibreOf.emplace(std::pair(yarn.fibre, kind.colour), fabric.fibres.size());
    yarn.fibre = known->second;
    if (kind.colour > 0) fibre = dyed(fibre, linearFromSrgb(palette.srgb(palette.colours.at(kind.colour))));
    // What I called my yarn says nothing of one of another colour or thickness: it goes by these.
    if (kind.colour > 0 || kind.permille != 1000) yarn.name.clear();
    if (isNew) fabric.fibres.push_back(fibre);
    fabric.yarns.push_back(yarn);
  }
  if (held) noteHeldYarns(warnings);
  const auto sequence = [&yarnOf](const std::vector<Kind>& kinds) {
    std::vector<int> yarns;
    for (const Kind& kind : kinds) yarns.push_back(yarnOf.at(kind));
    return shortest(std::move(yarns));
  };
  fabric.warpSequence = sequence(warp);
  fabric.weftSequence = sequence(weft);
}

/// As much of a text as a fabric takes, in whole characters.
std::string fitting(std::string text, const char* what, Warnings& warnings) {
  if (text.size() <= kMaxText) return text;
  warnings.push_back({fmt::format("The {} of the file is too long; its end is cut off.", what), {}});
  text.resize(wholeCharacters(text, kMaxText).size());
  return text;
}

/// Origin of a fabric that has just been given its sizes.
std::shared_ptr<const WifOrigin> withSizesOf(WifOrigin origin, const Fabric& fabric) {
  origin.ends_per_cm = fabric.ends_per_cm;
  origin.picks_per_cm = fabric.picks_per_cm;
  origin.warpDiameter_mm = meanDiameter_mm(fabric, System::warp);
  origin.weftDiameter_mm = meanDiameter_mm(fabric, System::weft);
  return std::make_shared<const WifOrigin>(std::move(origin));
}

bool varies(const std::map<int, double>& lengths) {
  return std::adjacent_find(lengths.begin(), lengths.end(),
                            [](const auto& a, const auto& b) { return a.second != b.second; }) != lengths.end();
}

/// Scales the yarns of a system so that the one that most threads have gets this diameter. Yarns that are done already,
/// because the other system uses them too, stay.
void scaleYarns(Fabric& fabric, System system, std::optional<double> diameter_mm, std::vector<bool>& done, bool& held) {
  if (!diameter_mm) return;
  const std::vector<int>& sequence = system == System::warp ? fabric.warpSequence : fabric.weftSequence;
  const Yarn& usual = fabric.yarns[mostCommon(sequence)];
  const double ratio = *diameter_mm / yarnDiameter_mm(usual, meanFibre(usual, fabric.fibres));
  for (const int index : sequence) {
    if (done[index]) continue;
    done[index] = true;
    Yarn& yarn = fabric.yarns[index];
    yarn = heavier(yarn, meanFibre(yarn, fabric.fibres), ratio * ratio, held);
  }
}

}  // namespace

WifSett wifSett(const Fabric& fabric) {
  WifSett sett;
  if (!fabric.wif) return sett;
  const WifOrigin& origin = *fabric.wif;
  const auto threads_per_cm = [](const WifSizes& sizes, int threads) -> std::optional<double> {
    const std::optional<double> pitch_mm = sizes.meanSpacing_mm(threads);
    return pitch_mm ? std::optional(tidy(10.0 / *pitch_mm)) : std::nullopt;
  };
  sett.ends_per_cm = threads_per_cm(origin.rest.warp, origin.ends);
  sett.picks_per_cm = threads_per_cm(origin.rest.weft, origin.picks);
  sett.warpDiameter_mm = usualThickness_mm(origin.rest.warp, origin.ends);
  sett.weftDiameter_mm = usualThickness_mm(origin.rest.weft, origin.picks);
  return sett;
}

std::vector<WifWarning> otherWifSizes(const Fabric& fabric) {
  const WifSett sett = wifSett(fabric);
  Warnings warnings;
  const auto note = [&](const char* threads, std::optional<double> file, double mine) {
    if (file && std::abs(*file - mine) > 1e-4 * mine)
      warnings.push_back(
          {fmt::format("The file has {:.4g} {} per cm; the cloth keeps {:g}.", *file, threads, mine), {}});
  };
  note("ends", sett.ends_per_cm, fabric.ends_per_cm);
  note("picks", sett.picks_per_cm, fabric.picks_per_cm);
  return warnings;
}

Fabric withWifSizes(Fabric fabric, std::vector<WifWarning>& warnings) {
  if (!fabric.wif) return fabric;
  const WifSett sett = wifSett(fabric);
  const FieldInfo range = fieldInfo(&Fabric::ends_per_cm);
  const auto set = [&](const char* threads, std::optional<double> file, double& mine) {
    if (!file) {
      warnings.push_back(
          {fmt::format("The file does not say how close its {} lie; it stays at {:g} per cm.", threads, mine), {}});
      return;
    }
    mine = std::clamp(*file, range.min, range.max);
    if (mine != *file)
      warnings.push_back({fmt::format("{:g} {} per cm are out of range; there are {:g}.", *file, threads, mine), {}});
  };
  set("ends", sett.ends_per_cm, fabric.ends_per_cm);
  set("picks", sett.picks_per_cm, fabric.picks_per_cm);
  if (varies(fabric.wif->rest.warp.spacings) || varies(fabric.wif->rest.weft.spacings))
    warnings.push_back({"The file spaces its threads unevenly; here they lie evenly, at the mean.", {}});

  std::vector<bool> done(fabric.yarns.size(), false);
  bool held = false;
  scaleYarns(fabric, System::warp, sett.warpDiameter_mm, done, held);
  scaleYarns(fabric, System::weft, sett.weftDiameter_mm, done, held);
  if (held) noteHeldYarns(warnings);
  fabric.wif = withSizesOf(*fabric.wif, fabric);
  return fabric;
}

WifImport fabricFromWif(std::string_view bytes, const std::string& source, const Fabric& mine, WifSizeChoice sizes) {
  WifWarnings wifWarnings;
  WifDocument document = readWif(bytes, source, wifWarnings);
  WifImport import{mine, wifWarnings.list()};
  Fabric& fabric = import.fabric;
  fabric.name = document.title.empty() ? std::filesystem::path(source).stem().string()
                                       : fitting(document.title, "title", import.warnings);
  fabric.description = fitting(fmt::format("{}", fmt::join(document.notes, "\n")), "text of notes", import.warnings);
  fabric.weave = drawdown(document.draft);

  const int warpBase = mine.warpYarn(0), weftBase = mine.weftYarn(0);
  const bool apart = warpBase == weftBase && usualThickness_mm(document.rest.warp, document.ends()) !=
                                                 usualThickness_mm(document.rest.weft, document.picks());
  std::vector<Kind> warp = kindsOfThreads(document.warpColours, document.rest.warp, warpBase, 0);
  std::vector<Kind> weft = kindsOfThreads(document.weftColours, document.rest.weft, weftBase, apart ? 1 : 0);
  reduceKinds(warp, weft, document.rest.palette, import.warnings);
  dressThreads(fabric, warp, weft, document.rest.palette, import.warnings);

  WifOrigin origin;
  origin.program = fitting(document.program, "name of the program", import.warnings);
  origin.ends = document.ends();
  origin.picks = document.picks();
  origin.rest = std::move(document.rest);
  fabric.draft = std::move(document.draft);
  fabric.wif = withSizesOf(std::move(origin), fabric);
  if (sizes == WifSizeChoice::file) fabric = withWifSizes(std::move(fabric), import.warnings);
  validate(fabric, source);
  return import;
}

WifImport readWifFabric(const std::string& file, const Fabric& mine, WifSizeChoice sizes) {
  return fabricFromWif(readFile(file, kMaxWifBytes), file, mine, sizes);
}

}  // namespace loomlight
