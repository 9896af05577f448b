#include "core/fabric/wif/wif_counting.h"

#include <algorithm>
#include <initializer_list>

#include "core/fabric/wif/wif_values.h"

// How it works. A line 0 is no line of a file that counts from 1, so it tells how the others are meant. Where line N of
// N is there as well, line 0 is a slip, and is passed over. Lists of numbers tell less, because 0 stands for none in
// them: the treadling is taken as the tie-up is, unless it names a treadle that then would not be there, and shafts are
// taken from 0 only in a file that counts other things so, hangs ends on shaft 0 and lifts it too. Colours and sizes of
// single threads are counted as the threads are, unless their section has line N and no line 0.

namespace loomlight {
namespace {

/// The last of that number, which counts; null where there is none.
const WifEntry* findLine(const WifSection* section, int number) {
  if (!section) return nullptr;
  const auto found = std::find_if(section->entries.rbegin(), section->entries.rend(),
                                  [&](const WifEntry& entry) { return wifWhole(entry.key) == number; });
  return found == section->entries.rend() ? nullptr : &*found;
}

bool hasLine(const WifSection* section, int number) {
  return findLine(section, number) != nullptr;
}

int largestLine(const WifSection& section) {
  int largest = 0;
  for (const WifEntry& entry : section.entries) largest = std::max(largest, wifWhole(entry.key).value_or(0));
  return largest;
}

/// What the lists of a section name.
struct Named {
  bool zero = false;
  int largest = 0;
};

Named named(const WifSection* section) {
  Named all;
  if (!section) return all;
  for (const WifEntry& entry : section->entries)
    for (const std::string& part : wifNumbers(entry.value).parts) {
      const std::optional<int> number = wifWhole(part);
      all.zero = all.zero || number == 0;
      all.largest = std::max(all.largest, number.value_or(0));
    }
  return all;
}

class CountingReader {
 public:
  CountingReader(const WifSections& sections, WifWarnings& warnings) : sections_(sections), warnings_(warnings) {}

  WifCounting read() {
    WifCounting counting;
    counting.end = firstThread("WARP", {"THREADING"});
    counting.pick = firstThread("WEFT", {"TREADLING", "LIFTPLAN"});
    if (counting.end == 0) readSingles("WARP", {"THREADING"}, counting);
    if (counting.pick == 0) readSingles("WEFT", {"TREADLING", "LIFTPLAN"}, counting);
    readTreadles(counting);
    readShafts(counting);
    const WifSection* const table = sections_.find("COLOR TABLE");
    if (hasLine(table, 0) && !hasLastLine(table, statedNumber(sections_, "COLOR PALETTE", "entries")))
      counting.colour = fromZero("COLOR TABLE", "Colours");
    if (hasLine(sections_.find("NOTES"), 0)) counting.note = 0;
    return counting;
  }

 private:
  int fromZero(std::string_view section, std::string_view what) {
    warnings_.add(0, section, "", std::string(what) + " are counted from 0 here, not from 1; they are read so.");
    return 0;
  }

  static bool hasLastLine(const WifSection* section, int stated) { return stated > 0 && hasLine(section, stated); }

  /// The plans tell; where there are none, what is said of colours and sizes.
  int firstThread(const std::string& system, std::initializer_list<const char*> plans) {
    std::vector<std::string> names(plans.begin(), plans.end());
    const bool planned = std::any_of(names.begin(), names.end(), [this](const std::string& name) {
      const WifSection* const section = sections_.find(name);
      return section && !section->entries.empty();
    });
    if (!planned) names = {system + " COLORS", system + " SPACING", system + " THICKNESS"};
    const int stated = statedNumber(sections_, system, "threads");
    const std::string* zero = nullptr;
    for (const std::string& name : names) {
      const WifSection* const section = sections_.find(name);
      if (hasLastLine(section, stated)) return 1;
      if (hasLine(section, 0)) zero = &name;
    }
    return zero ? fromZero(*zero, system == "WARP" ? "Ends" : "Picks") : 1;
  }

  /// Whether what is said of single threads counts from 1, though the threads themselves are counted from 0.
  void readSingles(const std::string& system, std::initializer_list<const char*> plans, WifCounting& counting) {
    int threads = statedNumber(sections_, system, "threads");
    if (threads < 1 || threads > Weave::kMaxSide) {
      threads = 0;
      for (const char* plan : plans)
        if (const WifSection* const section = sections_.find(plan))
          threads = std::max(threads, std::min(largestLine(*section), Weave::kMaxSide) + 1);
    }
    for (const char* what : {" COLORS", " SPACING", " THICKNESS", " SYMBOLS", " SPACING ZOOM", " THICKNESS ZOOM"}) {
      const WifSection* const section = sections_.find(system + what);
      if (hasLine(section, 0) || !hasLastLine(section, threads)) continue;
      counting.fromOne.push_back(section->name);
      warnings_.add(0, section->name, "",
                    "Threads are counted from 1 here, though the draft counts them from 0; they are read so.");
    }
  }

  void readTreadles(WifCounting& counting) {
    const WifSection* const tieUp = sections_.find("TIEUP");
    const WifEntry* const first = findLine(tieUp, 0);
    if (!first) return;
    const std::vector<std::string_view> tied = wifList(first->value);
    const bool isEmpty = tied.empty() || (tied.size() == 1 && wifWhole(tied[0]) == 0);
    if (isEmpty && hasLastLine(tieUp, statedNumber(sections_, "WEAVING", "treadles"))) return;
    counting.tiedTreadle = fromZero("TIEUP", "Treadles");
    if (named(sections_.find("TREADLING")).largest <= largestLine(*tieUp)) counting.pressedTreadle = 0;
  }

  void readShafts(WifCounting& counting) {
    if (counting.end + counting.pick + counting.tiedTreadle == 3) return;
    const Named hung = named(sections_.find("THREADING")), tied = named(sections_.find("TIEUP")),
                lifted = named(sections_.find("LIFTPLAN"));
    const int stated = statedNumber(sections_, "WEAVING", "shafts");
    const bool inside = stated == 0 || std::max({hung.largest, tied.largest, lifted.largest}) < stated;
    if (inside && hung.zero && (tied.zero || lifted.zero)) counting.shaft = fromZero("THREADING", "Shafts");
  }

  const WifSections& sections_;
  WifWarnings& warnings_;
};

}  // namespace

int statedNumber(const WifSections& sections, std::string_view section, std::string_view key) {
  const WifSection* const found = sections.find(section);
  const WifEntry* const entry = found ? found->find(key) : nullptr;
  return entry ? std::max(0, wifWhole(entry->value).value_or(0)) : 0;
}

int WifCounting::firstLine(std::string_view section) const {
  if (std::find(fromOne.begin(), fromOne.end(), section) != fromOne.end()) return 1;
  return section.starts_with("WARP") ? end : pick;
}

WifCounting wifCounting(const WifSections& sections, WifWarnings& warnings) {
  return CountingReader(sections, warnings).read();
}

}  // namespace loomlight
