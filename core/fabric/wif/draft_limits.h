#pragma once

#include <initializer_list>
#include <string>

#include "core/fabric/model/weave.h"
#include "core/fabric/wif/wif_warnings.h"

/// The lists of a draft, and what the two readers of its files do where there are more shafts or treadles than a loom
/// has.
namespace loomlight {

/// How a kind of file calls the sections of a draft, for messages.
struct DraftSections {
  const char *threading, *tieUp, *treadling, *liftplan;  ///< as WifWarnings::add() takes them
  const char* threadingHeading;                          ///< as it stands in the file
};

/// So many shafts a draft has at most, and so many treadles.
int mostShafts();

/// Sorts each list, with each number once and none of them 0.
void sortLists(NumberLists& lists);
/// The largest number in lists that are sorted; 0 where there is none.
int largestOf(std::initializer_list<const NumberLists*> all);

/// Lifts of shafts that no end hangs on move nothing, and are dropped; where ends do hang on more shafts than there can
/// be, those that always go together become one. The lists are sorted; threading, tie-up, treadling or liftplan and the
/// way the shed opens are there. Leaves the number of shafts to the caller. Throws InputError, naming `source` and its
/// threading, where the cloth needs more.
void fewerShafts(Draft& draft, const std::string& source, const DraftSections& sections, WifWarnings& warnings);

/// Where there are more treadles than there can be, the draft has a liftplan instead.
void fewerTreadles(Draft& draft, const DraftSections& sections, WifWarnings& warnings);

}  // namespace loomlight
