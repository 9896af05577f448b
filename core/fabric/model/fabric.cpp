#include "core/fabric/model/fabric.h"

#include <cassert>

#include "core/base/modulo.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/wif_origin.h"

namespace loomlight {
namespace {

int yarnAt(const std::vector<int>& sequence, int index) {
  assert(!sequence.empty());
  return sequence[wrap(index, static_cast<int>(sequence.size()))];
}

}  // namespace

int Fabric::warpYarn(int end) const {
  return yarnAt(warpSequence, end);
}

int Fabric::weftYarn(int pick) const {
  return yarnAt(weftSequence, pick);
}

bool operator==(const Fibre& a, const Fibre& b) {
  return equalFields(a, b);
}
bool operator==(const Yarn& a, const Yarn& b) {
  return equalFields(a, b);
}
bool operator==(const Colourway& a, const Colourway& b) {
  return equalFields(a, b) && a.absorption_per_mm == b.absorption_per_mm;
}
bool operator==(const MillData& a, const MillData& b) {
  return equalFields(a, b) && a.endsPerDent == b.endsPerDent;
}
bool operator==(const Drape& a, const Drape& b) {
  return equalFields(a, b);
}
bool operator==(const Light& a, const Light& b) {
  return equalFields(a, b);
}
bool operator==(const Camera& a, const Camera& b) {
  return equalFields(a, b);
}
bool operator==(const RenderSettings& a, const RenderSettings& b) {
  return equalFields(a, b);
}

bool operator==(const Draft& a, const Draft& b) {
  return equalFields(a, b) && a.threading == b.threading && a.tieUp == b.tieUp && a.treadling == b.treadling &&
         a.liftplan == b.liftplan;
}

bool operator==(const WifYarn& a, const WifYarn& b) {
  return equalFields(a, b);
}

bool operator==(const WifOrigin& a, const WifOrigin& b) {
  return equalFields(a, b) && a.warpDiameters_mm == b.warpDiameters_mm && a.weftDiameters_mm == b.weftDiameters_mm &&
         a.warpSpacing == b.warpSpacing && a.weftSpacing == b.weftSpacing && a.yarns == b.yarns && a.rest == b.rest;
}

bool operator==(const Fabric& a, const Fabric& b) {
  return equalFields(a, b) && a.weave == b.weave && a.draft == b.draft && a.warpSequence == b.warpSequence &&
         a.weftSequence == b.weftSequence && a.warpSpacing == b.warpSpacing && a.weftSpacing == b.weftSpacing &&
         a.yarns == b.yarns && a.fibres == b.fibres && a.colourways == b.colourways && a.mill == b.mill &&
         a.drape == b.drape && a.light == b.light && a.camera == b.camera && a.render == b.render &&
         (a.wif == b.wif || (a.wif && b.wif && *a.wif == *b.wif));
}

}  // namespace loomlight
