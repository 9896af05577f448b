#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fabric/model/field_path.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/wif/draft_limits.h"
#include "core/fabric/wif/wif_entries.h"
#include "core/fabric/wif/wif_numbered.h"
#include "core/fabric/wif/wif_reader.h"

// How it works. Threading, tie-up, treadling and liftplan are sections of lines N=list: what end, treadle or pick N
// has. How many ends and picks there are is what Threads= says, or as far as the lines go. Lists are sorted, every
// number once, counted from 1. Where a liftplan and a treadling stand side by side, the liftplan counts; if the two
// weave different cloths that is said. A file may name more shafts and treadles than a loom has (draft_limits). The
// draft is checked like any other at the end. Cost: linear in the numbers of the lists, and a drawdown of each where
// there are both.

namespace loomlight {
namespace {

constexpr DraftSections kWifSections{"THREADING", "TIEUP", "TREADLING", "LIFTPLAN", "[THREADING]"};

class DraftReader {
 public:
  DraftReader(const WifSections& sections, const WifCounting& counting, const std::string& source,
              WifWarnings& warnings)
      : sections_(sections), counting_(counting), source_(source), warnings_(warnings) {}

  Draft read() {
    const WifSection* threading = sections_.find("THREADING");
    const WifSection* treadling = sections_.find("TREADLING");
    const WifSection* liftplan = sections_.find("LIFTPLAN");
    const bool trodden = treadling && !treadling->entries.empty();
    // An empty liftplan lifts nothing; no treadles at all would raise everything in a sinking shed.
    const bool lifted = liftplan && (!liftplan->entries.empty() || !trodden);

    Draft draft;
    const int ends = threads("WARP", threading, "WARP COLORS", counting_.end);
    const int picks = threads("WEFT", lifted ? liftplan : treadling, "WEFT COLORS", counting_.pick);
    named_ = {lastNamed(threading, {counting_.end, ends}),
              lastNamed(lifted ? liftplan : treadling, {counting_.pick, picks})};
    draft.threading = lists(threading, {counting_.end, ends}, "end", shafts());
    if (lifted) draft.liftplan = lists(liftplan, {counting_.pick, picks}, "pick", shafts());
    if (trodden || !lifted)
      draft.treadling =
          lists(treadling, {counting_.pick, picks}, "pick", {"treadle", counting_.pressedTreadle, Weave::kMaxSide});
    readTieUp(draft);
    draft.risingShed = risingShed();
    fewerShafts(draft, source_, kWifSections, warnings_);
    draft.shafts = kinds("Shafts", largestOf({&draft.threading, &draft.tieUp, &draft.liftplan}));
    fewerTreadles(draft, kWifSections, warnings_);

    if (!threading)
      warnings_.add(0, "THREADING", "", "There is no threading: no end hangs on a shaft, and nothing is lifted.");
    if (!lifted) noteMissing(draft, trodden);
    validateDraft(draft, FieldPath(source_));
    if (lifted && !draft.treadling.empty()) noteDisagreement(draft);
    return draft;
  }

  WifNamed named() const { return named_; }

 private:
  struct Lines {
    int first = 1, count = 0;
  };
  /// What lists name, and how the first of it is called.
  struct Listed {
    const char* kind;
    int first = 1;
    int most = 0;
  };
  Listed shafts() const { return {"shaft", counting_.shaft, Weave::kMaxSide}; }

  const WifEntry* find(const char* section, const char* key) {
    const WifSection* const found = sections_.find(section);
    return found ? found->find(lowerCase(key)) : nullptr;
  }

  /// How many threads a system has: what Threads= says, or else as many as the lines of the draft name.
  int threads(const char* system, const WifSection* draft, const char* colours, int first) {
    const WifEntry* const entry = find(system, "Threads");
    const int number = entry ? wifWhole(entry->value).value_or(0) : 0;
    if (number >= 1 && number <= Weave::kMaxSide) return number;
    int listed = largestKey(draft);
    if (listed == 0) listed = largestKey(sections_.find(colours));
    if (listed > 0 || first == 0) listed = std::min(listed + 1 - first, Weave::kMaxSide);
    const bool tooMany = draft && draft->entries.size() > static_cast<size_t>(Weave::kMaxSide);
    if (listed == 0 || tooMany)
      throw InputError(fmt::format("{}: [{}] Threads: expected from 1 to {} threads, got {}", source_, system,
                                   Weave::kMaxSide, entry ? plainText(entry->value) : "none"));
    warnings_.add(entry ? entry->line : 0, system, entry ? entryText(*entry) : "Threads",
                  fmt::format("The number of threads should stand here, 1 to {}; there are {}, which is as far as the "
                              "lines of the draft go.",
                              Weave::kMaxSide, listed));
    return listed;
  }

  static int largestKey(const WifSection* section) {
    int largest = 0;
    if (!section) return largest;
    for (const WifEntry& entry : section->entries)
      if (const auto key = wifWhole(entry.key); key && *key <= Weave::kMaxSide) largest = std::max(largest, *key);
    return largest;
  }

  /// The last thread that has a line in the plan; 0 where that is the last of all, or none has.
  static int lastNamed(const WifSection* plan, const Lines& lines) {
    int last = 0;
    if (!plan) return last;
    for (const WifEntry& entry : plan->entries) {
      const std::optional<int> number = wifWhole(entry.key);
      if (number && *number >= lines.first && *number < lines.first + lines.count)
        last = std::max(last, *number - lines.first + 1);
    }
    return last < lines.count ? last : 0;
  }

  /// The lines of a section as lists of shafts or treadles, one for each of `count` threads or treadles.
  NumberLists lists(const WifSection* section, const Lines& lines, const char* what, const Listed& listed) {
    NumberLists all(static_cast<size_t>(lines.count));
    int named = 0;
    forEachNumbered(section, lines.first, lines.count, what, warnings_, [&](int number, const WifEntry& entry) {
      all[number - 1] = list(*section, entry, listed);
      ++named;
    });
    if (section && named < lines.count)
      warnings_.add(0, section->name, "",
                    fmt::format("Only {} of {} {}s are named; the others are left empty.", named, lines.count, what));
    return all;
  }

  std::vector<int> list(const WifSection& section, const WifEntry& entry, const Listed& listed) {
    std::vector<int> numbers;
    const WifNumbers parts = wifNumbers(entry.value);
    for (const std::string& remark : parts.remarks) warnings_.add(entry.line, section.name, entryText(entry), remark);
    for (const std::string& part : parts.parts) {
      const std::optional<int> number = wifWhole(part);
      if (!number || *number < 0 || *number > listed.most + listed.first - 1) {
        warnings_.add(
            entry.line, section.name, entryText(entry),
            fmt::format("There can be {}s 1 to {}, or 0 for none; others are passed over.", listed.kind, listed.most));
      } else if (*number >= listed.first) {
        numbers.push_back(*number - listed.first + 1);
      }
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
  }

  /// The tie-up, and how many treadles there are: those tied, and as many more as [WEAVING] says. A treadle that is
  /// pressed but neither of the two moves nothing.
  void readTieUp(Draft& draft) {
    const WifSection* const tieUp = sections_.find("TIEUP");
    draft.treadles = kinds("Treadles", largestKey(tieUp) + 1 - counting_.tiedTreadle);
    if (tieUp || !draft.treadling.empty()) draft.tieUp.resize(static_cast<size_t>(draft.treadles));
    forEachNumbered(
        tieUp, counting_.tiedTreadle, draft.treadles, "treadle", warnings_,
        [&](int treadle, const WifEntry& entry) { draft.tieUp[treadle - 1] = list(*tieUp, entry, shafts()); });
    for (size_t pick = 0; pick < draft.treadling.size(); ++pick) {
      std::vector<int>& pressed = draft.treadling[pick];
      const auto first = std::upper_bound(pressed.begin(), pressed.end(), draft.treadles);
      if (first == pressed.end()) continue;
      warnings_.add(
          0, "TREADLING", fmt::format("pick {}, treadle {}", pick + 1, *first),
          fmt::format("There are {} treadles; one beyond them is tied to nothing and passed over.", draft.treadles));
      pressed.erase(first, pressed.end());
    }
  }

  /// How many shafts or treadles: as stated in [WEAVING], but no fewer than `used`.
  int kinds(const char* key, int used) {
    const WifEntry* const entry = find("WEAVING", key);
    constexpr int kNone = -1;
    const int number = entry ? wifWhole(entry->value).value_or(kNone) : kNone;
    if (number >= used && number <= std::max(used, mostShafts())) return number;
    const std::string counted = lowerCase(key);
    std::string sentence = fmt::format("It is not said how many {} there are; the draft uses {}.", counted, used);
    if (entry) sentence = fmt::format("The number of {} should stand here; the draft uses {}.", counted, used);
    if (number != kNone) sentence = fmt::format("The draft uses another number of {}: {}.", counted, used);
    warnings_.add(entry ? entry->line : 0, "WEAVING", entry ? entryText(*entry) : key, sentence, WifConcern::file);
    return used;
  }

  bool risingShed() {
    const WifSection* const weaving = sections_.find("WEAVING");
    const WifEntry* const entry = weaving ? weaving->find("rising shed") : nullptr;
    const std::optional<bool> rising = entry ? wifBoolean(entry->value) : std::nullopt;
    if (entry && !rising)
      warnings_.add(entry->line, "WEAVING", entryText(*entry),
                    "True or false should stand here; the shed is taken as rising.");
    if (!entry)
      warnings_.add(0, "WEAVING", "Rising Shed", "It is not said whether the shed rises; it is taken as rising.");
    return rising.value_or(true);
  }

  void noteMissing(const Draft& draft, bool trodden) {
    if (!trodden) {
      warnings_.add(0, "TREADLING", "",
                    "Neither a treadling nor a liftplan says what is lifted; no pick lifts anything.");
    } else if (!draft.tieUp.empty() && draft.tieUp == NumberLists(draft.tieUp.size())) {
      warnings_.add(0, "TIEUP", "", "No shaft is tied to any treadle; no pick lifts anything.");
    }
  }

  void noteDisagreement(const Draft& draft) {
    Draft treadled = draft;
    treadled.liftplan.clear();
    if (!(drawdown(treadled) == drawdown(draft)))
      warnings_.add(0, "LIFTPLAN", "",
                    "The liftplan weaves another cloth than tie-up and treadling; the liftplan counts.");
  }

  const WifSections& sections_;
  const WifCounting& counting_;
  const std::string& source_;
  WifWarnings& warnings_;
  WifNamed named_;  ///< of threading, and of the liftplan or treadling that counts
};

}  // namespace

Draft readWifDraft(const WifSections& sections, const WifCounting& counting, const std::string& source,
                   WifWarnings& warnings, WifNamed& named) {
  DraftReader reader(sections, counting, source, warnings);
  Draft draft = reader.read();
  named = reader.named();
  return draft;
}

}  // namespace loomlight
