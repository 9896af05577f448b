#include "core/fabric/wif/draft_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/weave/draft_derivation.h"

namespace loomlight {

int mostShafts() {
  return static_cast<int>(fieldInfo(&Draft::shafts).max);
}

void sortLists(NumberLists& lists) {
  for (std::vector<int>& list : lists) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    if (!list.empty() && list.front() == 0) list.erase(list.begin());
  }
}

int largestOf(std::initializer_list<const NumberLists*> all) {
  int most = 0;
  for (const NumberLists* lists : all)
    for (const std::vector<int>& list : *lists)
      if (!list.empty()) most = std::max(most, list.back());
  return most;
}

void fewerShafts(Draft& draft, const std::string& source, const DraftSections& sections, WifWarnings& warnings) {
  if (largestOf({&draft.threading}) <= mostShafts()) {
    const int lifted = largestOf({&draft.tieUp, &draft.liftplan});
    if (lifted <= mostShafts()) return;
    warnings.add(0, draft.liftplan.empty() ? sections.tieUp : sections.liftplan, "",
                 fmt::format("Shafts up to {} are lifted, and there can be {}; no end hangs on those beyond, which are "
                             "left out. The cloth is the same.",
                             lifted, mostShafts()),
                 WifConcern::weave);
    for (NumberLists* lists : {&draft.tieUp, &draft.liftplan})
      for (std::vector<int>& list : *lists)
        list.erase(std::upper_bound(list.begin(), list.end(), mostShafts()), list.end());
    return;
  }
  draft.shafts = largestOf({&draft.threading, &draft.tieUp, &draft.liftplan});
  const std::optional<Draft> merged = smallestDraft(drawdown(draft), mostShafts());
  if (!merged)
    throw InputError(fmt::format("{}: {}: expected at most {} shafts that differ, got more among {}", source,
                                 sections.threadingHeading, mostShafts(), draft.shafts));
  warnings.add(0, sections.threading, "",
               fmt::format("The draft names {} shafts, and there can be {}; those that always go together are one, "
                           "which leaves {}. The cloth is the same.",
                           draft.shafts, mostShafts(), merged->shafts),
               WifConcern::weave);
  draft = withLiftplan(*merged);
}

void fewerTreadles(Draft& draft, const DraftSections& sections, WifWarnings& warnings) {
  if (draft.treadles <= mostShafts()) return;
  warnings.add(0, sections.treadling, "",
               fmt::format("The draft uses {} treadles, and there can be {}; what they lift is a liftplan instead. The "
                           "cloth is the same.",
                           draft.treadles, mostShafts()),
               WifConcern::weave);
  draft = withLiftplan(std::move(draft));
}

}  // namespace loomlight
