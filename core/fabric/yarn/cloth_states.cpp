#include "core/fabric/yarn/cloth_states.h"

#include <fmt/format.h>

#include <charconv>
#include <numeric>

// How it works. A cloth has four setts, in ends and picks per cm: in the reed, on the loom, washed, and finished,
// which is what is drawn. What the mill has counted is taken as it is. The reed says its own ends: dents per cm
// times ends in a dent. What is not known is reckoned back from the finished cloth where that can be done: a yarn
// that is crimped by c now lay straight in the reed, so the sett across it was smaller by 1 + c. The rest stays
// unknown, the washed sett among it: that a cloth is drawn unpressed does not say by how much it has still to shrink.
// Cost: none to speak of.

namespace loomlight {
namespace {

KnownSett counted(double per_cm, SettSource source) {
  return per_cm > 0 ? KnownSett{per_cm, source} : KnownSett{};
}

/// Of yarns across others that were straight once and are crimped now, as the cloth is narrower by their crimp.
KnownSett beforeCrimp(double finished_per_cm, double crimp) {
  return {finished_per_cm / (1 + crimp), SettSource::crimp};
}

}  // namespace

double meanEndsPerDent(const MillData& mill) {
  return static_cast<double>(std::accumulate(mill.endsPerDent.begin(), mill.endsPerDent.end(), 0)) /
         static_cast<double>(mill.endsPerDent.size());
}

ClothStates clothStates(const Fabric& fabric, const std::optional<Crimps>& crimps) {
  const MillData& mill = fabric.mill;
  ClothStates states;
  states.finished = {{fabric.ends_per_cm, SettSource::cloth}, {fabric.picks_per_cm, SettSource::cloth}};
  states.reed.ends = counted(0.1 * mill.reed_per_10cm * meanEndsPerDent(mill), SettSource::reed);
  if (crimps) {
    if (states.reed.ends.per_cm == 0) states.reed.ends = beforeCrimp(fabric.ends_per_cm, crimps->weft);
    states.reed.picks = beforeCrimp(fabric.picks_per_cm, crimps->warp);
  }
  states.loom = {counted(mill.loomEnds_per_cm, SettSource::mill), counted(mill.loomPicks_per_cm, SettSource::mill)};
  states.washed = {counted(mill.washedEnds_per_cm, SettSource::mill),
                   counted(mill.washedPicks_per_cm, SettSource::mill)};
  return states;
}

std::optional<double> shrinkage_percent(const KnownSett& before, const KnownSett& after) {
  if (before.per_cm == 0 || after.per_cm == 0) return std::nullopt;
  return 100 * (1 - before.per_cm / after.per_cm);
}

std::optional<double> reedWidth_cm(const Fabric& fabric, const ClothStates& states, double finishedWidth_cm) {
  const double inReed_per_cm = states.reed.ends.per_cm;
  if (inReed_per_cm == 0) return std::nullopt;
  const double cloth_cm = finishedWidth_cm * fabric.ends_per_cm / inReed_per_cm;
  const double dents_per_cm = inReed_per_cm / meanEndsPerDent(fabric.mill);
  return cloth_cm + 2.0 * fabric.mill.selvedgeEnds / fabric.mill.selvedgeEndsPerDent / dents_per_cm;
}

std::string settText(const KnownSett& sett, const char* unknown) {
  if (sett.per_cm == 0) return unknown;
  return fmt::format("{}{:.1f}", sett.source == SettSource::crimp ? "~" : "", sett.per_cm);
}

const char* sourceText(SettSource source) {
  switch (source) {
    case SettSource::cloth:
      return "as drawn";
    case SettSource::mill:
      return "counted by the mill";
    case SettSource::reed:
      return "reed and denting";
    case SettSource::crimp:
      return "from crimp";
    case SettSource::unknown:
      break;
  }
  return "not known";
}

std::string dentingText(const std::vector<int>& endsPerDent) {
  return fmt::format("{}", fmt::join(endsPerDent, " "));
}

std::optional<std::vector<int>> dentingFromText(const std::string& text) {
  std::vector<int> dents;
  bool isFilled = false;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    if (*at == ' ' || *at == ',') {
      ++at;
      continue;
    }
    int ends = 0;
    const auto [next, error] = std::from_chars(at, end, ends);
    if (error != std::errc() || ends < 0 || ends > MillData::kMostInDent) return std::nullopt;
    if (dents.size() == MillData::kMostDents) return std::nullopt;
    dents.push_back(ends);
    isFilled |= ends > 0;
    at = next;
  }
  if (!isFilled) return std::nullopt;
  return dents;
}

std::string selvedgeText(const MillData& mill, const std::string& yarn) {
  if (mill.selvedgeEnds == 0) return {};
  std::string text = fmt::format("{} each side, {} per dent", mill.selvedgeEnds, mill.selvedgeEndsPerDent);
  for (const std::string& more : {yarn, mill.selvedgeWeave})
    if (!more.empty()) text += ", " + more;
  return text;
}

}  // namespace loomlight
