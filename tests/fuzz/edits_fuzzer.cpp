#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/changes.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/weave/draft_derivation.h"
#include "core/fabric/weave/structure_edit.h"
#include "core/fabric/wif/wif_fabric.h"
#include "tests/fuzz/choices.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/fuzzers.h"
#include "tests/fuzz/material_edits.h"

namespace loomlight::fuzz {
namespace {

constexpr int kMostSteps = 40, kMostYarnsASide = 24;

CellRect rectIn(const Weave& weave, Choices& choices) {
  return {choices.from(0, weave.picks() - 1), choices.from(0, weave.ends() - 1), choices.from(1, 8),
          choices.from(1, 8)};
}

int linesOf(const Draft& draft, DraftPart part) {
  switch (part) {
    case DraftPart::threading:
      return static_cast<int>(draft.threading.size());
    case DraftPart::tieUp:
      return static_cast<int>(draft.tieUp.size());
    case DraftPart::treadling:
      return static_cast<int>(draft.treadling.size());
    default:
      return static_cast<int>(draft.liftplan.size());
  }
}

/// One number of one part; where the part has none, nothing.
Draft numbered(Draft draft, Choices& choices) {
  const auto part = static_cast<DraftPart>(choices.below(4));
  const int lines = linesOf(draft, part), numbers = part == DraftPart::treadling ? draft.treadles : draft.shafts;
  if (lines == 0 || numbers == 0) return draft;
  const int line = choices.from(0, lines - 1), number = choices.from(1, numbers);
  if (choices.below(2)) return withOnlyNumber(std::move(draft), part, line, number);
  const bool on = !hasNumber(draft, part, line, number);
  Draft changed = withNumber(std::move(draft), part, line, number, on);
  expect(hasNumber(changed, part, line, number) == on, "a number of the draft is not set");
  return changed;
}

Draft withOtherDraft(const Draft& draft, Choices& choices) {
  const auto sameCloth = [&draft](Draft other) {
    expect(drawdown(other) == drawdown(draft), "other means weave another cloth");
    return other;
  };
  switch (choices.below(7)) {
    case 0:
      return withShaftCount(draft, choices.from(1, 12));
    case 1:
      return withTreadleCount(draft, choices.from(1, 12));
    case 2: {
      const int ends = choices.from(1, kMostYarnsASide), picks = choices.from(1, kMostYarnsASide);
      Draft other = resized(draft, ends, picks);
      expect(drawdown(other) == drawdown(draft).resized(ends, picks), "a draft of another size weaves another cloth");
      return other;
    }
    case 3:
      return sameCloth(withLiftplan(draft));
    case 4:
      return sameCloth(withTreadles(draft));
    case 5:
      return sameCloth(withShed(draft, choices.below(2) == 0));
    default:
      return numbered(draft, choices);
  }
}

Weave withOtherWeave(const Weave& weave, Choices& choices) {
  switch (choices.below(8)) {
    case 0:
      return weave.resized(choices.from(1, kMostYarnsASide), choices.from(1, kMostYarnsASide));
    case 1:
      return mirroredEnds(weave);
    case 2:
      return mirroredPicks(weave);
    case 3:
      return quarterTurned(weave);
    case 4:
      return inverted(weave);
    case 5:
      return shifted(weave, choices.from(-30, 30), choices.from(-30, 30));
    case 6: {
      const Weave part = partOf(weave, rectIn(weave, choices));
      expect(weaveFromText(weaveText(part)) == part, "point paper is read as another weave");
      const CellRect at = rectIn(weave, choices);
      return choices.below(2) ? withPart(weave, at.pick, at.end, part) : withPattern(weave, at, part);
    }
    default: {
      const int pick = choices.from(0, weave.picks() - 1), end = choices.from(0, weave.ends() - 1);
      return weave.with(pick, end, !weave.at(pick, end));
    }
  }
}

/// A structure from the library, by numbers within their ranges; nothing where they make none, or a large one.
Fabric withLibrary(const Fabric& fabric, Choices& choices, const LoomLimits& loom) {
  const std::vector<StructureKind>& library = structureLibrary();
  const StructureKind& kind = library[choices.below(static_cast<uint32_t>(library.size()))];
  std::vector<int> values;
  for (const StructureParameter& parameter : kind.parameters)
    values.push_back(choices.from(parameter.min, std::min(parameter.max, parameter.min + 255)));
  const MadeStructure structure = kind.make(values);
  if (!structure.problem.empty() || std::max(structure.weave.ends(), structure.weave.picks()) > 64) return fabric;
  std::optional<CellRect> selection;
  if (choices.below(2)) selection = rectIn(fabric.weave, choices);
  return withStructure(fabric, selection, structure, loom).fabric;
}

Fabric withOtherCrossings(const Fabric& before, Choices& choices) {
  const LoomLimits loom{choices.from(1, 16), choices.from(1, 16)};
  switch (choices.below(4)) {
    case 0:
      return before.draft ? withDraft(before, withOtherDraft(*before.draft, choices)) : before;
    case 1:
      return rewoven(before, withOtherWeave(before.weave, choices), loom).fabric;
    case 2:
      return withLibrary(before, choices, loom);
    default: {
      const DerivedDraft derived = deriveDraft(before.weave, loom, before.draft.value_or(Draft{}));
      if (!derived.draft) {
        expect(!derived.remark.empty(), "there is no draft, and nobody says why");
        return before;
      }
      expect(derived.draft->shafts <= std::max(loom.shafts, before.draft ? before.draft->shafts : 0),
             "a derived draft has more shafts than the loom");
      return withDraft(before, *derived.draft);
    }
  }
}

Edited edited(const Fabric& before, Choices& choices) {
  switch (choices.below(8)) {
    case 0:
      return withOtherYarns(before, choices);
    case 1:
      return withOtherFibres(before, choices);
    case 2:
      return withOtherColours(before, choices);
    case 3:
      return withOtherScene(before, choices);
    default:
      return {withOtherCrossings(before, choices)};
  }
}

/// Whether the editor takes the edit, as every one should be that it does not expect to refuse.
bool isTaken(const Edited& edit, int step) {
  try {
    validate(edit.fabric, "an edit");  // knows that the draft weaves the weave
    return true;
  } catch (const InputError& error) {
    expect(edit.mayBeRefused, fmt::format("step {} leaves no fabric: {}", step, error.what()));
    return false;
  }
}

}  // namespace

void fuzzEdits(std::string_view bytes) {
  Choices choices(bytes);
  Fabric fabric;
  for (int step = 0; step < kMostSteps && !choices.isOver(); ++step) {
    Edited edit = edited(fabric, choices);
    const Fabric& next = edit.fabric;
    if (std::max(next.weave.ends(), next.weave.picks()) > 4 * kMostYarnsASide) break;  // a structure's repeat
    if (!isTaken(edit, step)) continue;
    expect(changes(next, next).stages == Stages{}, "a fabric differs from itself");
    expect(!edit.stages || changes(fabric, next).stages.within(*edit.stages),
           fmt::format("step {} puts more out of date than what it edits", step));
    fabric = std::move(edit.fabric);
  }
  expect(fabricFromJson(fabricToJson(fabric), "a.json") == fabric, "the fabric is written as another");
  // A draft has one repeat of weave and colours together.
  const Weave written =
      fabricFromWif(wifFromFabric(fabric, "a.wif").text, "a.wif", Fabric{}, WifSizeChoice::keep).fabric.weave;
  expect(written == fabric.weave.resized(written.ends(), written.picks()), "the draft is written as another");
}

}  // namespace loomlight::fuzz
