#include "core/fabric/model/validate.h"

#include <fmt/format.h>

#include "core/fabric/model/check.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/model/wif_origin.h"
#include "core/fabric/model/yarn_count.h"

namespace loomlight {
namespace {

template <class Object>
void checkFields(const Object& object, const Place& place) {
  forEachField<Object>([&](const auto& field) { check(field.info, object.*field.member, place.at(field.info.key)); });
}

void checkSize(size_t size, size_t most, const char* what, const Place& place) {
  if (size < 1 || size > most) place.reject(fmt::format("from 1 to {} {}", most, what), fmt::format("{}", size));
}

void checkIndex(int index, size_t count, const char* what, const Place& place) {
  if (index < 0 || static_cast<size_t>(index) >= count)
    place.reject(fmt::format("the number of a {} from 0 to {}", what, count - 1), fmt::format("{}", index));
}

void checkSequence(const std::vector<int>& sequence, size_t yarns, const Place& place) {
  checkSize(sequence.size(), kMaxSequence, "yarn numbers", place);
  for (size_t i = 0; i < sequence.size(); ++i) checkIndex(sequence[i], yarns, "yarn", place.at(i));
}

void checkYarn(const Yarn& yarn, const std::vector<Fibre>& fibres, const Place& place) {
  checkFields(yarn, place);
  checkIndex(yarn.fibre, fibres.size(), "fibre", place.at("fibre"));
  if (yarn.blendFibre) checkIndex(*yarn.blendFibre, fibres.size(), "fibre", place.at("blend_fibre"));
  const double inYarn = fibresInYarn(yarn, meanFibre(yarn, fibres));
  if (inYarn > kMaxFibresInYarn)
    place.at(yarn.fibresPerPly ? "fibres_per_ply" : "count_tex")
        .reject(fmt::format("a yarn of at most {} fibres", kMaxFibresInYarn), fmt::format("{:.0f}", inYarn));
}

void checkColourway(const Colourway& colourway, const Place& place) {
  checkFields(colourway, place);
  const Place colours = place.at("absorption_per_mm");
  if (colourway.absorption_per_mm.size() > kMaxKinds)
    colours.reject(fmt::format("at most {} colours", kMaxKinds), fmt::format("{}", colourway.absorption_per_mm.size()));
  for (size_t i = 0; i < colourway.absorption_per_mm.size(); ++i)
    check(fieldInfo(&Fibre::absorption_per_mm), colourway.absorption_per_mm[i], colours.at(i));
}

void checkMill(const MillData& mill, size_t yarns, const Place& place) {
  checkFields(mill, place);
  const Place denting = place.at("ends_per_dent");
  checkSize(mill.endsPerDent.size(), MillData::kMostDents, "dents", denting);
  int all = 0;
  for (size_t i = 0; i < mill.endsPerDent.size(); ++i) {
    check(FieldInfo{{}, "", "", "", 0, MillData::kMostInDent}, mill.endsPerDent[i], denting.at(i));
    all += mill.endsPerDent[i];
  }
  if (all == 0) denting.reject("a dent that is not empty", "none");
  if (mill.selvedgeYarn) checkIndex(*mill.selvedgeYarn, yarns, "yarn", place.at("selvedge_yarn"));
}

void checkDrape(const Drape& drape, const Place& place) {
  checkFields(drape, place);
  if (drape.kind == DrapeKind::mesh && drape.file.empty())
    place.at("file").reject("the name of an OBJ, PLY or OFF file", "nothing");
}

void checkLight(const Light& light, const Place& place) {
  checkFields(light, place);
  if (light.kind == LightKind::sky && light.elevation_deg <= 0)
    place.at("elevation_deg").reject("a number above 0 for a sky", fmt::format("{}", light.elevation_deg));
  if (light.kind == LightKind::environment && light.file.empty())
    place.at("file").reject("the name of a latitude-longitude EXR file", "nothing");
  if (light.illuminant == StandardIlluminant::file && light.illuminantFile.empty())
    place.at("illuminant_file").reject("the name of a text file of wavelengths and power", "nothing");
}

void checkRender(const RenderSettings& render, const Place& place) {
  checkFields(render, place);
  const int r = render.resolution;
  if ((r & (r - 1)) != 0) place.at("resolution").reject("1, 2, 4, 8 or 16", fmt::format("{}", r));
}

/// A list of a draft: one entry an end, treadle or pick, each a list of shaft or treadle numbers, 0 for none.
void checkDraftList(const std::vector<std::vector<int>>& list, int kinds, const char* kind, int mostNumbers,
                    const Place& place) {
  if (list.size() > static_cast<size_t>(Weave::kMaxSide))
    place.reject(fmt::format("at most {} entries", Weave::kMaxSide), fmt::format("{}", list.size()));
  size_t numbers = 0;
  for (size_t i = 0; i < list.size(); ++i) {
    const Place entry = place.at(i);
    if (list[i].size() > static_cast<size_t>(kinds) + 1)
      entry.reject(fmt::format("each {} at most once", kind), fmt::format("{} numbers", list[i].size()));
    for (const int number : list[i])
      if (number < 0 || number > kinds)
        entry.reject(fmt::format("a {} from 0 to {}", kind, kinds), fmt::format("{}", number));
    numbers += list[i].size();
  }
  if (numbers > static_cast<size_t>(mostNumbers))
    place.reject(fmt::format("at most {} numbers in all", mostNumbers), fmt::format("{}", numbers));
}

void checkOrigin(const WifOrigin& origin, const Place& place) {
  checkFields(origin, place);
  const Place yarns = place.at("yarns");
  if (origin.yarns.size() > kMaxKinds)
    yarns.reject(fmt::format("at most {} yarns", kMaxKinds), fmt::format("{}", origin.yarns.size()));
  for (size_t i = 0; i < origin.yarns.size(); ++i) {
    const Place yarn = yarns.at(i);
    checkFields(origin.yarns[i], yarn);
  }
}

}  // namespace

void validateDraft(const Draft& draft, const Place& place) {
  checkFields(draft, place);
  const auto treadles = static_cast<size_t>(draft.treadles);
  if (draft.tieUp.size() > treadles)
    place.at("tie_up").reject(fmt::format("at most {} entries, one a treadle", treadles),
                              fmt::format("{}", draft.tieUp.size()));
  checkSize(draft.threading.size(), Weave::kMaxSide, "ends", place.at("threading"));
  const bool lifted = !draft.liftplan.empty();
  checkSize(lifted ? draft.liftplan.size() : draft.treadling.size(), Weave::kMaxSide, "picks",
            place.at(lifted ? "liftplan" : "treadling"));
  checkDraftList(draft.threading, draft.shafts, "shaft", kMaxThreadingEntries, place.at("threading"));
  checkDraftList(draft.tieUp, draft.shafts, "shaft", kMaxLiftEntries, place.at("tie_up"));
  checkDraftList(draft.treadling, draft.treadles, "treadle", kMaxThreadingEntries, place.at("treadling"));
  checkDraftList(draft.liftplan, draft.shafts, "shaft", kMaxLiftEntries, place.at("liftplan"));
}

void validate(const Fabric& fabric, const std::string& source) {
  const Place place(source);
  checkFields(fabric, place);
  if (fabric.draft) {
    const Place draftPlace = place.at("draft");
    validateDraft(*fabric.draft, draftPlace);
    if (!(drawdown(*fabric.draft) == fabric.weave)) draftPlace.reject("a draft that makes the weave", "another weave");
  }
  const Place fibres = place.at("fibres");
  checkSize(fabric.fibres.size(), kMaxKinds, "fibres", fibres);
  for (size_t i = 0; i < fabric.fibres.size(); ++i) {
    const Place fibre = fibres.at(i);
    checkFields(fabric.fibres[i], fibre);
  }
  const Place yarns = place.at("yarns");
  checkSize(fabric.yarns.size(), kMaxKinds, "yarns", yarns);
  for (size_t i = 0; i < fabric.yarns.size(); ++i) {
    const Place yarn = yarns.at(i);
    checkYarn(fabric.yarns[i], fabric.fibres, yarn);
  }
  checkSequence(fabric.warpSequence, fabric.yarns.size(), place.at("warp_sequence"));
  checkSequence(fabric.weftSequence, fabric.yarns.size(), place.at("weft_sequence"));
  const Place colourways = place.at("colourways");
  if (fabric.colourways.size() > kMaxKinds)
    colourways.reject(fmt::format("at most {} colourways", kMaxKinds), fmt::format("{}", fabric.colourways.size()));
  for (size_t i = 0; i < fabric.colourways.size(); ++i) checkColourway(fabric.colourways[i], colourways.at(i));
  checkMill(fabric.mill, fabric.yarns.size(), place.at("mill"));
  checkDrape(fabric.drape, place.at("drape"));
  checkLight(fabric.light, place.at("light"));
  checkFields(fabric.camera, place.at("camera"));
  checkRender(fabric.render, place.at("render"));
  if (fabric.wif) checkOrigin(*fabric.wif, place.at("wif"));
}

}  // namespace loomlight
