#include "core/fabric/model/validate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/base/error.h"
#include "core/fabric/model/field_tables.h"

namespace loomlight {
namespace {

std::string complaint(const Fabric& fabric) {
  try {
    validate(fabric, "cloth.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string complaintAfter(const std::function<void(Fabric&)>& edit) {
  Fabric fabric;
  edit(fabric);
  return complaint(fabric);
}

TEST(Validate, DefaultFabricIsValid) {
  EXPECT_EQ(complaint(Fabric{}), "");
}

TEST(Validate, BlendsAndColourwaysNameFibresAndColoursThatCanBe) {
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.yarns[0].blendFibre = 1; }),
            "cloth.json: yarns[0].blend_fibre: expected the number of a fibre from 0 to 0, got 1");
  EXPECT_EQ(complaintAfter([](Fabric& f) {
              f.colourways.resize(1);
              f.colourways[0].absorption_per_mm = {Rgb(1.0f), Rgb(-1.0f)};
            }),
            "cloth.json: colourways[0].absorption_per_mm[1][0]: expected a number from 0 to 10000, got -1");
  EXPECT_NE(complaintAfter([](Fabric& f) { f.colourways.resize(65); }), "");
}

TEST(Validate, NamesSourcePlaceAndRange) {
  EXPECT_EQ(complaintAfter([](Fabric& f) {
              f.yarns.resize(2);
              f.yarns[1].plyTwist_per_m = -3;
            }),
            "cloth.json: yarns[1].ply_twist_per_m: expected a number from 0 to 5000, got -3");
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.yarns[0].plies = 9; }),
            "cloth.json: yarns[0].plies: expected a whole number from 1 to 8, got 9");
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.fibres[0].absorption_per_mm.primaries.y = -1; }),
            "cloth.json: fibres[0].absorption_per_mm[1]: expected a number from 0 to 10000, got -1");
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.ends_per_cm = std::nan(""); }),
            "cloth.json: ends_per_cm: expected a number from 0.2 to 500, got nan");
}

/// Every number of every table: just outside its range and not finite is refused, both ends are accepted.
template <class Object>
void probeRanges(const std::function<Object&(Fabric&)>& part) {
  forEachField<Object>([&](const auto& field) {
    using Value = std::decay_t<decltype(std::declval<Object>().*field.member)>;
    const auto with = [&](auto value) {
      return complaintAfter([&](Fabric& f) { part(f).*field.member = static_cast<Value>(value); });
    };
    if constexpr (std::is_same_v<Value, double>) {
      const double infinity = std::numeric_limits<double>::infinity();
      for (const double bad : {std::nextafter(field.info.min, -infinity), std::nextafter(field.info.max, infinity),
                               infinity, -infinity, std::nan("")})
        EXPECT_NE(with(bad).find(field.info.key), std::string::npos) << field.info.key << " " << bad;
      EXPECT_EQ(with(field.info.max), "") << field.info.key;
      const bool isSunHeight = std::is_same_v<Object, Light> && std::string(field.info.key) == "elevation_deg";
      EXPECT_EQ(with(field.info.min) == "", !isSunHeight) << field.info.key;
    } else if constexpr (std::is_same_v<Value, int>) {
      EXPECT_NE(with(field.info.min - 1).find(field.info.key), std::string::npos) << field.info.key;
      EXPECT_NE(with(field.info.max + 1).find(field.info.key), std::string::npos) << field.info.key;
      EXPECT_EQ(with(field.info.min), "") << field.info.key;
    }
  });
}

TEST(Validate, HoldsEveryNumberToItsRange) {
  probeRanges<Fabric>([](Fabric& f) -> Fabric& { return f; });
  probeRanges<Drape>([](Fabric& f) -> Drape& { return f.drape; });
  probeRanges<MillData>([](Fabric& f) -> MillData& { return f.mill; });
  probeRanges<Light>([](Fabric& f) -> Light& { return f.light; });
  probeRanges<Camera>([](Fabric& f) -> Camera& { return f.camera; });
  probeRanges<RenderSettings>([](Fabric& f) -> RenderSettings& { return f.render; });
  probeRanges<Fibre>([](Fabric& f) -> Fibre& { return f.fibres[0]; });
  probeRanges<Yarn>([](Fabric& f) -> Yarn& {
    f.fibres[0].radius_um = 20;  // 5000 tex of cotton at 6 um would be too many fibres
    return f.yarns[0];
  });
}

TEST(Validate, IndicesNameSomething) {
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.warpSequence = {0, 1}; }),
            "cloth.json: warp_sequence[1]: expected the number of a yarn from 0 to 0, got 1");
  EXPECT_NE(complaintAfter([](Fabric& f) { f.weftSequence = {-1}; }), "");
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.yarns[0].fibre = 1; }),
            "cloth.json: yarns[0].fibre: expected the number of a fibre from 0 to 0, got 1");
}

TEST(Validate, DentsHoldEndsAndSelvedgesAYarnThatIsThere) {
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.mill.endsPerDent = {3, 3, 0}; }), "");
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.mill.endsPerDent = {0, 0}; }),
            "cloth.json: mill.ends_per_dent: expected a dent that is not empty, got none");
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.mill.endsPerDent = {2, 65}; }),
            "cloth.json: mill.ends_per_dent[1]: expected a whole number from 0 to 64, got 65");
  EXPECT_NE(complaintAfter([](Fabric& f) { f.mill.endsPerDent.clear(); }), "");
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.mill.selvedgeYarn = 0; }), "");
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.mill.selvedgeYarn = 1; }),
            "cloth.json: mill.selvedge_yarn: expected the number of a yarn from 0 to 0, got 1");
}

TEST(Validate, SizesAreBounded) {
  EXPECT_NE(complaintAfter([](Fabric& f) { f.warpSequence.clear(); }), "");
  EXPECT_NE(complaintAfter([](Fabric& f) { f.weftSequence.assign(16385, 0); }), "");
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.weftSequence.assign(16384, 0); }), "");
  EXPECT_NE(complaintAfter([](Fabric& f) { f.yarns.clear(); }), "");
  EXPECT_NE(complaintAfter([](Fabric& f) { f.yarns.resize(65); }), "");
  EXPECT_NE(complaintAfter([](Fabric& f) { f.fibres.clear(); }), "");
  EXPECT_NE(complaintAfter([](Fabric& f) { f.fibres.resize(65); }), "");
}

TEST(Validate, YarnOfTooManyFibresIsRefused) {
  const std::string said = complaintAfter([](Fabric& f) {
    f.fibres[0].radius_um = 1;
    f.yarns[0].count_tex = 5000;
  });
  EXPECT_NE(said.find("yarns[0].count_tex: expected a yarn of at most 20000 fibres"), std::string::npos) << said;
}

TEST(Validate, ResolutionIsAPowerOfTwo) {
  for (const int good : {1, 2, 4, 8, 16}) EXPECT_EQ(complaintAfter([&](Fabric& f) { f.render.resolution = good; }), "");
  for (const int bad : {3, 5, 6, 7, 9, 12, 15})
    EXPECT_NE(complaintAfter([&](Fabric& f) { f.render.resolution = bad; }), "") << bad;
}

TEST(Validate, WhatNeedsAFileNamesOne) {
  EXPECT_NE(complaintAfter([](Fabric& f) { f.drape.kind = DrapeKind::mesh; }), "");
  EXPECT_NE(complaintAfter([](Fabric& f) { f.light.kind = LightKind::environment; }), "");
  EXPECT_NE(complaintAfter([](Fabric& f) { f.light.elevation_deg = 0; }), "") << "a sky needs the sun up";
}

Draft plainDraft() {
  Draft draft;
  draft.shafts = 2;
  draft.treadles = 2;
  draft.threading = {{1}, {2}};
  draft.tieUp = {{1}, {2}};
  draft.treadling = {{1}, {2}};
  return draft;
}

TEST(Validate, WeaveAgreesWithTheDraft) {
  EXPECT_EQ(complaintAfter([](Fabric& f) { f.draft = plainDraft(); }), "");
  EXPECT_NE(complaintAfter([](Fabric& f) {
              f.draft = plainDraft();
              f.weave = f.weave.with(0, 0, false);
            }),
            "");
}

TEST(Validate, DraftStaysWithinItsLoom) {
  const auto with = [](const std::function<void(Draft&)>& edit) {
    return complaintAfter([&](Fabric& f) {
      f.draft = plainDraft();
      edit(*f.draft);
    });
  };
  EXPECT_EQ(with([](Draft& d) { d.threading[1] = {3}; }),
            "cloth.json: draft.threading[1]: expected a shaft from 0 to 2, got 3");
  EXPECT_NE(with([](Draft& d) { d.tieUp[0] = {-1}; }), "");
  EXPECT_NE(with([](Draft& d) { d.treadling[0] = {5}; }), "");
  EXPECT_NE(with([](Draft& d) { d.liftplan = {{9}}; }), "");
  EXPECT_NE(with([](Draft& d) { d.tieUp.resize(5); }), "");
  EXPECT_NE(with([](Draft& d) { d.threading.clear(); }), "");
  EXPECT_NE(with([](Draft& d) { d.treadling.clear(); }), "");
  EXPECT_NE(with([](Draft& d) { d.treadling.assign(16385, {1}); }), "");
  EXPECT_NE(with([](Draft& d) { d.threading[0].assign(100, 1); }), "") << "every shaft at most once";
}

}  // namespace
}  // namespace loomlight
