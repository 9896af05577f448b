#include "core/fabric/model/validate.h"

#include <fmt/format.h>

#include "core/fabric/model/check.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/model/yarn_count.h"

namespace loomlight {
namespace {

template <class Object>
void checkFields(const Object& object, const FieldPath& path) {
  forEachField<Object>([&](const auto& field) { check(field.info, object.*field.member, path.at(field.info.key)); });
}

void checkSize(size_t size, size_t most, const char* what, const FieldPath& path) {
  if (size < 1 || size > most) path.reject(fmt::format("from 1 to {} {}", most, what), fmt::format("{}", size));
}

void checkIndex(int index, size_t count, const char* what, const FieldPath& path) {
  if (index < 0 || static_cast<size_t>(index) >= count)
    path.reject(fmt::format("the number of a {} from 0 to {}", what, count - 1), fmt::format("{}", index));
}

void checkSequence(const std::vector<int>& sequence, size_t yarns, const FieldPath& path) {
  checkSize(sequence.size(), kMaxSequence, "yarn numbers", path);
  for (size_t i = 0; i < sequence.size(); ++i) checkIndex(sequence[i], yarns, "yarn", path.at(i));
}

void checkSpacing(const std::vector<double>& spacing, const FieldPath& path) {
  if (spacing.size() > static_cast<size_t>(kMostSpacing))
    path.reject(fmt::format("at most {} distances", kMostSpacing), fmt::format("{}", spacing.size()));
  for (size_t i = 0; i < spacing.size(); ++i) check(kSpacingRange, spacing[i], path.at(i));
}

void checkYarn(const Yarn& yarn, const std::vector<Fibre>& fibres, const FieldPath& path) {
  checkFields(yarn, path);
  checkIndex(yarn.fibre, fibres.size(), "fibre", path.at("fibre"));
  if (yarn.blendFibre) checkIndex(*yarn.blendFibre, fibres.size(), "fibre", path.at("blend_fibre"));
  const double inYarn = fibresInYarn(yarn, meanFibre(yarn, fibres));
  if (inYarn > kMaxFibresInYarn)
    path.at(yarn.fibresPerPly ? "fibres_per_ply" : "count_tex")
        .reject(fmt::format("a yarn of at most {} fibres", kMaxFibresInYarn), fmt::format("{:.0f}", inYarn));
}

void checkColourway(const Colourway& colourway, const FieldPath& path) {
  checkFields(colourway, path);
  const FieldPath colours = path.at("absorption_per_mm");
  if (colourway.absorption_per_mm.size() > kMaxKinds)
    colours.reject(fmt::format("at most {} colours", kMaxKinds), fmt::format("{}", colourway.absorption_per_mm.size()));
  for (size_t i = 0; i < colourway.absorption_per_mm.size(); ++i)
    check(fieldInfo(&Fibre::absorption_per_mm), colourway.absorption_per_mm[i], colours.at(i));
}

void checkMill(const MillData& mill, size_t yarns, const FieldPath& path) {
  checkFields(mill, path);
  const FieldPath denting = path.at("ends_per_dent");
  checkSize(mill.endsPerDent.size(), MillData::kMostDents, "dents", denting);
  int all = 0;
  for (size_t i = 0; i < mill.endsPerDent.size(); ++i) {
    check(FieldInfo{{}, "", "", "", 0, MillData::kMostInDent}, mill.endsPerDent[i], denting.at(i));
    all += mill.endsPerDent[i];
  }
  if (all == 0) denting.reject("a dent that is not empty", "none");
  if (mill.selvedgeYarn) checkIndex(*mill.selvedgeYarn, yarns, "yarn", path.at("selvedge_yarn"));
}

void checkDrape(const Drape& drape, const FieldPath& path) {
  checkFields(drape, path);
  if (drape.kind == DrapeKind::mesh && drape.file.empty())
    path.at("file").reject("the name of an OBJ, PLY or OFF file", "nothing");
}

void checkLight(const Light& light, const FieldPath& path) {
  checkFields(light, path);
  if (light.kind == LightKind::sky && light.elevation_deg <= 0)
    path.at("elevation_deg").reject("a number above 0 for a sky", fmt::format("{}", light.elevation_deg));
  if (light.kind == LightKind::environment && light.file.empty())
    path.at("file").reject("the name of a latitude-longitude EXR file", "nothing");
  if (light.illuminant == StandardIlluminant::file && light.illuminantFile.empty())
    path.at("illuminant_file").reject("the name of a text file of wavelengths and power", "nothing");
}

void checkRender(const RenderSettings& render, const FieldPath& path) {
  checkFields(render, path);
  const int r = render.resolution;
  if ((r & (r - 1)) != 0) path.at("resolution").reject("1, 2, 4, 8 or 16", fmt::format("{}", r));
}

/// A list of a draft: one entry an end, treadle or pick, each a list of shaft or treadle numbers, 0 for none.
void checkDraftList(const NumberLists& list, int kinds, const char* kind, int mostNumbers, const FieldPath& path) {
  if (list.size() > static_cast<size_t>(Weave::kMaxSide))
    path.reject(fmt::format("at most {} entries", Weave::kMaxSide), fmt::format("{}", list.size()));
  size_t numbers = 0;
  for (size_t i = 0; i < list.size(); ++i) {
    const FieldPath entry = path.at(i);
    if (list[i].size() > static_cast<size_t>(kinds) + 1)
      entry.reject(fmt::format("each {} at most once", kind), fmt::format("{} numbers", list[i].size()));
    for (const int number : list[i])
      if (number < 0 || number > kinds)
        entry.reject(fmt::format("a {} from 0 to {}", kind, kinds), fmt::format("{}", number));
    numbers += list[i].size();
  }
  if (numbers > static_cast<size_t>(mostNumbers))
    path.reject(fmt::format("at most {} numbers in all", mostNumbers), fmt::format("{}", numbers));
}

void checkOrigin(const WifOrigin& origin, const FieldPath& path) {
  checkFields(origin, path);
  const FieldPath yarns = path.at("yarns");
  if (origin.yarns.size() > kMaxKinds)
    yarns.reject(fmt::format("at most {} yarns", kMaxKinds), fmt::format("{}", origin.yarns.size()));
  for (size_t i = 0; i < origin.yarns.size(); ++i) {
    const FieldPath yarn = yarns.at(i);
    checkFields(origin.yarns[i], yarn);
  }
  const auto checkDiameters = [](const std::vector<double>& diameters_mm, const FieldInfo& info,
                                 const FieldPath& list) {
    if (diameters_mm.size() > static_cast<size_t>(kMaxSequence))
      list.reject(fmt::format("at most {} threads", kMaxSequence), fmt::format("{}", diameters_mm.size()));
    for (size_t i = 0; i < diameters_mm.size(); ++i) check(info, diameters_mm[i], list.at(i));
  };
  checkDiameters(origin.warpDiameters_mm, fieldInfo(&WifOrigin::warpDiameter_mm), path.at("warp_diameters_mm"));
  checkDiameters(origin.weftDiameters_mm, fieldInfo(&WifOrigin::weftDiameter_mm), path.at("weft_diameters_mm"));
  checkSpacing(origin.warpSpacing, path.at("warp_spacing"));
  checkSpacing(origin.weftSpacing, path.at("weft_spacing"));
}

}  // namespace

void validateDraft(const Draft& draft, const FieldPath& path) {
  checkFields(draft, path);
  const auto treadles = static_cast<size_t>(draft.treadles);
  if (draft.tieUp.size() > treadles)
    path.at("tie_up").reject(fmt::format("at most {} entries, one a treadle", treadles),
                             fmt::format("{}", draft.tieUp.size()));
  checkSize(draft.threading.size(), Weave::kMaxSide, "ends", path.at("threading"));
  const bool lifted = !draft.liftplan.empty();
  checkSize(lifted ? draft.liftplan.size() : draft.treadling.size(), Weave::kMaxSide, "picks",
            path.at(lifted ? "liftplan" : "treadling"));
  checkDraftList(draft.threading, draft.shafts, "shaft", kMaxThreadingEntries, path.at("threading"));
  checkDraftList(draft.tieUp, draft.shafts, "shaft", kMaxLiftEntries, path.at("tie_up"));
  checkDraftList(draft.treadling, draft.treadles, "treadle", kMaxThreadingEntries, path.at("treadling"));
  checkDraftList(draft.liftplan, draft.shafts, "shaft", kMaxLiftEntries, path.at("liftplan"));
}

void validate(const Fabric& fabric, const std::string& source) {
  const FieldPath path(source);
  checkFields(fabric, path);
  if (fabric.draft) {
    const FieldPath draftPath = path.at("draft");
    validateDraft(*fabric.draft, draftPath);
    if (!(drawdown(*fabric.draft) == fabric.weave)) draftPath.reject("a draft that makes the weave", "another weave");
  }
  const FieldPath fibres = path.at("fibres");
  checkSize(fabric.fibres.size(), kMaxKinds, "fibres", fibres);
  for (size_t i = 0; i < fabric.fibres.size(); ++i) {
    const FieldPath fibre = fibres.at(i);
    checkFields(fabric.fibres[i], fibre);
  }
  const FieldPath yarns = path.at("yarns");
  checkSize(fabric.yarns.size(), kMaxKinds, "yarns", yarns);
  for (size_t i = 0; i < fabric.yarns.size(); ++i) {
    const FieldPath yarn = yarns.at(i);
    checkYarn(fabric.yarns[i], fabric.fibres, yarn);
  }
  checkSequence(fabric.warpSequence, fabric.yarns.size(), path.at("warp_sequence"));
  checkSequence(fabric.weftSequence, fabric.yarns.size(), path.at("weft_sequence"));
  checkSpacing(fabric.warpSpacing, path.at("warp_spacing"));
  checkSpacing(fabric.weftSpacing, path.at("weft_spacing"));
  const FieldPath colourways = path.at("colourways");
  if (fabric.colourways.size() > kMaxKinds)
    colourways.reject(fmt::format("at most {} colourways", kMaxKinds), fmt::format("{}", fabric.colourways.size()));
  for (size_t i = 0; i < fabric.colourways.size(); ++i) checkColourway(fabric.colourways[i], colourways.at(i));
  checkMill(fabric.mill, fabric.yarns.size(), path.at("mill"));
  checkDrape(fabric.drape, path.at("drape"));
  checkLight(fabric.light, path.at("light"));
  checkFields(fabric.camera, path.at("camera"));
  checkRender(fabric.render, path.at("render"));
  if (fabric.wif) checkOrigin(*fabric.wif, path.at("wif"));
}

}  // namespace loomlight
