#include <algorithm>
#include <cctype>

#include "core/base/error.h"
#include "core/fabric/field_tables.h"
#include "core/fabric/place.h"
#include "core/fabric/validate.h"
#include "core/fabric/wif_numbered.h"
#include "core/fabric/wif_reader.h"

namespace loomlight {
namespace {

using Lists = std::vector<std::vector<int>>;

int mostShafts() {
  return static_cast<int>(fieldInfo(&Draft::shafts).max);
}

class DraftReader {
 public:
  DraftReader(const WifSections& sections, const std::string& source, WifWarnings& warnings)
      : sections_(sections), source_(source), warnings_(warnings) {}

  Draft read() {
    const WifSection* threading = sections_.find("THREADING");
    const WifSection* treadling = sections_.find("TREADLING");
    const WifSection* liftplan = sections_.find("LIFTPLAN");
    const bool trodden = treadling && !treadling->entries.empty();
    // An empty liftplan lifts nothing; no treadles at all would raise everything in a sinking shed.
    const bool lifted = liftplan && (!liftplan->entries.empty() || !trodden);

    Draft draft;
    const int ends = threads("WARP", threading, "WARP COLORS");
    const int picks = threads("WEFT", lifted ? liftplan : treadling, "WEFT COLORS");
    draft.threading = lists(threading, ends, "end", "shaft");
    if (lifted) draft.liftplan = lists(liftplan, picks, "pick", "shaft");
    if (trodden || !lifted) draft.treadling = lists(treadling, picks, "pick", "treadle");
    readTieUp(draft);
    draft.shafts = kinds("Shafts", largest(draft.threading, draft.tieUp, draft.liftplan));
    draft.risingShed = risingShed();

    if (!threading) warnings_.add("THREADING", "is missing; no end hangs on a shaft, nothing is lifted");
    if (!lifted) noteMissing(draft, trodden);
    validateDraft(draft, Place(source_));
    if (lifted && trodden) noteDisagreement(draft);
    return draft;
  }

 private:
  /// A whole number of a section's key, if there is one.
  std::optional<int> stated(const char* section, const char* key) {
    const WifSection* const found = sections_.find(section);
    const WifEntry* const entry = found ? found->find(lowerCase(key)) : nullptr;
    if (!entry) return std::nullopt;
    const std::optional<int> number = wifWhole(entry->value);
    if (!number) warnings_.add(entry->line, section, said(*entry), "a whole number", "it is passed over");
    return number;
  }

  static std::string said(const WifEntry& entry) { return fmt::format("{}={}", entry.key, entry.value.substr(0, 40)); }

  /// How many threads a system has: what Threads= says, or else as many as the lines of the draft name.
  int threads(const char* system, const WifSection* draft, const char* colours) {
    const std::optional<int> number = stated(system, "Threads");
    if (number && *number >= 1 && *number <= Weave::kMaxSide) return *number;
    int listed = largestKey(draft);
    if (listed == 0) listed = largestKey(sections_.find(colours));
    const bool tooMany = draft && draft->entries.size() > static_cast<size_t>(Weave::kMaxSide);
    if (listed == 0 || tooMany)
      throw InputError(fmt::format("{}: [{}] Threads: expected from 1 to {} threads, got {}", source_, system,
                                   Weave::kMaxSide, number ? fmt::format("{}", *number) : "none"));
    warnings_.add(system, fmt::format("Threads={}: expected from 1 to {}; it is taken as {}, which is as far as the "
                                      "lines of the draft go",
                                      number ? fmt::format("{}", *number) : "", Weave::kMaxSide, listed));
    return listed;
  }

  static int largestKey(const WifSection* section) {
    int largest = 0;
    if (!section) return largest;
    for (const WifEntry& entry : section->entries)
      if (const auto key = wifWhole(entry.key); key && *key <= Weave::kMaxSide) largest = std::max(largest, *key);
    return largest;
  }

  /// The lines of a section as lists of shafts or treadles, one for each of `count` threads or treadles.
  Lists lists(const WifSection* section, int count, const char* what, const char* kind) {
    Lists all(static_cast<size_t>(count));
    int named = 0;
    forEachNumbered(section, count, what, warnings_, [&](int number, const WifEntry& entry) {
      all[number - 1] = list(*section, entry, kind);
      ++named;
    });
    if (section && named < count)
      warnings_.add(section->name, fmt::format("names {} of {} {}s; the others are taken as 0", named, count, what));
    return all;
  }

  std::vector<int> list(const WifSection& section, const WifEntry& entry, const char* kind) {
    std::vector<int> numbers;
    // "2;3" may have been meant as a list.
    const size_t comment = entry.value.find(';');
    if (comment != std::string::npos && comment + 1 < entry.value.size() &&
        std::isdigit(static_cast<unsigned char>(entry.value[comment + 1])))
      warnings_.add(entry.line, section.name, said(entry), "commas in a list", "what is behind the ; is a comment");
    for (const std::string_view part : wifList(entry.value)) {
      const std::optional<int> number = wifWhole(part);
      if (!number || *number < 0 || *number > mostShafts()) {
        warnings_.add(entry.line, section.name, said(entry), fmt::format("{}s from 0 to {}", kind, mostShafts()),
                      "others are passed over");
      } else if (*number > 0) {
        numbers.push_back(*number);
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
    draft.treadles = kinds("Treadles", std::min(largestKey(tieUp), mostShafts()));
    if (tieUp || !draft.treadling.empty()) draft.tieUp.resize(static_cast<size_t>(draft.treadles));
    forEachNumbered(tieUp, draft.treadles, "treadle", warnings_, [&](int treadle, const WifEntry& entry) {
      draft.tieUp[treadle - 1] = list(*tieUp, entry, "shaft");
    });
    for (size_t pick = 0; pick < draft.treadling.size(); ++pick) {
      std::vector<int>& pressed = draft.treadling[pick];
      const auto first = std::upper_bound(pressed.begin(), pressed.end(), draft.treadles);
      if (first == pressed.end()) continue;
      warnings_.add(0, "TREADLING", fmt::format("pick {}, treadle {}", pick + 1, *first),
                    fmt::format("at most {}", draft.treadles), "that treadle is tied to nothing and passed over");
      pressed.erase(first, pressed.end());
    }
  }

  static int largest(const Lists& a, const Lists& b, const Lists& c) {
    int most = 0;
    for (const Lists* lists : {&a, &b, &c})
      for (const std::vector<int>& list : *lists)
        if (!list.empty()) most = std::max(most, list.back());
    return most;
  }

  /// How many shafts or treadles: as stated in [WEAVING], but no fewer than `used`.
  int kinds(const char* key, int used) {
    const std::optional<int> number = stated("WEAVING", key);
    if (number && *number >= used && *number <= mostShafts()) return *number;
    warnings_.add("WEAVING", fmt::format("{}={}: expected from {} to {}; it is taken as {}, which the draft uses", key,
                                         number ? fmt::format("{}", *number) : "", used, mostShafts(), used));
    return used;
  }

  bool risingShed() {
    const WifSection* const weaving = sections_.find("WEAVING");
    const WifEntry* const entry = weaving ? weaving->find("rising shed") : nullptr;
    const std::optional<bool> rising = entry ? wifBoolean(entry->value) : std::nullopt;
    if (entry && !rising) warnings_.add(entry->line, "WEAVING", said(*entry), "true or false", "the shed rises");
    if (!entry) warnings_.add("WEAVING", "does not say whether the shed rises; it is taken as rising");
    return rising.value_or(true);
  }

  void noteMissing(const Draft& draft, bool trodden) {
    if (!trodden) {
      warnings_.add("", "neither TREADLING nor LIFTPLAN says what is lifted; no pick lifts anything");
    } else if (!draft.tieUp.empty() && draft.tieUp == Lists(draft.tieUp.size())) {
      warnings_.add("TIEUP", "ties no shaft to any treadle; no pick lifts anything");
    }
  }

  void noteDisagreement(const Draft& draft) {
    Draft treadled = draft;
    treadled.liftplan.clear();
    if (!(drawdown(treadled) == drawdown(draft)))
      warnings_.add("LIFTPLAN", "weaves another cloth than TIEUP and TREADLING do; the liftplan counts");
  }

  const WifSections& sections_;
  const std::string& source_;
  WifWarnings& warnings_;
};

}  // namespace

Draft readWifDraft(const WifSections& sections, const std::string& source, WifWarnings& warnings) {
  return DraftReader(sections, source, warnings).read();
}

}  // namespace loomlight
