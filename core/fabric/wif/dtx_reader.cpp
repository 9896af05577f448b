#include "core/fabric/wif/dtx_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/text_encoding.h"
#include "core/base/utf8.h"
#include "core/fabric/model/field_path.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/wif/draft_limits.h"
#include "core/fabric/wif/wif_sections.h"
#include "core/fabric/wif/wif_values.h"

// How it works. Sections begin with @@NAME; a line %%KEY VALUE in one is a property of it. Threading, treadling,
// colours and spacing are numbers between blanks, over any number of lines; treadles that are pressed together have
// commas between them. Tie-up and liftplan are rows of 0 and 1: a row of the tie-up is a shaft, the last row shaft 1,
// its columns are treadles; a row of the liftplan is a pick, its columns are shafts. Colours count from 0, all else
// from 1. Spacing is in steps of 0.053 cm. A file may name more shafts and treadles than a loom has (draft_limits), but
// no more than a cloth has threads.

namespace loomlight {
namespace {

constexpr double kStep_cm = 0.053;
constexpr DraftSections kDtxSections{"threading", "tieup", "treadling", "liftplan", "@@threading"};

struct Section {
  std::string name;  ///< lower case
  std::vector<std::string> properties;
  std::vector<std::string> lines;
};

class DtxReader {
 public:
  DtxReader(std::string_view text, const std::string& source, WifWarnings& warnings)
      : source_(source), warnings_(warnings) {
    for (int count = 1; !text.empty(); ++count) {
      if (static_cast<size_t>(count) > kMaxWifLines)
        throw InputError(fmt::format("{}: expected at most {} lines", source_, kMaxWifLines));
      const size_t end = std::min(text.find_first_of("\r\n"), text.size());
      addLine(trimmed(text.substr(0, end)));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  WifDocument read() {
    readDraft();
    document_.rest.palette = palette();
    document_.warpColours = colours("warp colors", ends_);
    document_.weftColours = colours("weft colors", picks_);
    document_.rest.warp = sizes("warp spacing", ends_);
    document_.rest.weft = sizes("weft spacing", picks_);
    if (const Section* title = find("description")) document_.title = fmt::format("{}", fmt::join(title->lines, " "));
    if (const Section* notes = find("notes")) document_.notes = notes->lines;
    if (const Section* imprint = find("imprint"); imprint && !imprint->lines.empty())
      document_.program = "Fiberworks " + imprint->lines.front();
    keepOthers();
    return std::move(document_);
  }

 private:
  void addLine(std::string_view line) {
    if (line.empty()) return;
    if (line.starts_with("@@")) {
      if (sections_.size() == kMaxWifSections)
        throw InputError(fmt::format("{}: expected at most {} sections", source_, kMaxWifSections));
      sections_.push_back({lowerCase(trimmed(line.substr(2))), {}, {}});
    } else if (!sections_.empty()) {
      std::vector<std::string>& lines = line.starts_with("%%") ? sections_.back().properties : sections_.back().lines;
      lines.emplace_back(line);
    }
  }

  const Section* find(std::string_view name) const {
    const auto found =
        std::find_if(sections_.begin(), sections_.end(), [&](const Section& s) { return s.name == name; });
    return found == sections_.end() ? nullptr : &*found;
  }

  void say(const char* section, std::string_view got, const std::string& sentence, WifConcern concern) {
    warnings_.add(0, section, wholeCharacters(got, 40), sentence, concern);
  }

  /// Numbers between blanks; those joined by commas together. Blanks may follow a comma.
  NumberLists groups(const char* name, int most) {
    NumberLists all;
    const Section* const section = find(name);
    if (!section) return all;
    bool joins = false;
    const auto take = [&](std::string_view text) {
      const std::optional<int> number = wifWhole(text);
      if (!joins) all.emplace_back();
      joins = false;
      if (number && *number >= 0 && *number <= most)
        all.back().push_back(*number);
      else
        say(name, text, fmt::format("Numbers from 0 to {} should stand here; this one is passed over.", most),
            WifConcern::weave);
    };
    for (const std::string& line : section->lines)
      for (size_t at = 0; at < line.size();) {
        const size_t end = std::min(line.find_first_of(", \t", at), line.size());
        if (end > at) take(std::string_view(line).substr(at, end - at));
        joins = joins || (end < line.size() && line[end] == ',' && !all.empty());
        at = end + 1;
        if (all.size() > static_cast<size_t>(Weave::kMaxSide)) return all;
      }
    return all;
  }

  /// What a property states; 0 where nothing sensible.
  int stated(const char* key) const {
    const Section* const info = find("info");
    if (!info) return 0;
    for (const std::string& line : info->properties)
      if (const std::string_view rest = std::string_view(line).substr(2); lowerCase(rest).starts_with(key))
        return std::max(0, wifWhole(trimmed(rest.substr(std::string_view(key).size()))).value_or(0));
    return 0;
  }

  /// How many threads there are: as stated, or as the draft has.
  int threads(const char* key, size_t listed, int& named) {
    const int number = stated(key);
    const bool isSensible = number >= 1 && number <= Weave::kMaxSide;
    const int all = isSensible ? number : static_cast<int>(listed);
    if (all < 1 || all > Weave::kMaxSide)
      throw InputError(fmt::format("{}: @@Info {}: expected from 1 to {}, got {}", source_, key, Weave::kMaxSide, all));
    if (static_cast<int>(listed) != all)
      say(key, "", fmt::format("There are {} {}, and {} of them are named.", all, key, listed), WifConcern::weave);
    if (listed > 0 && static_cast<int>(listed) < all) named = static_cast<int>(listed);
    return all;
  }

  static void tidy(NumberLists& lists, int count) {
    lists.resize(static_cast<size_t>(count));
    sortLists(lists);
  }

  /// The rows of a section, none of more columns than there can be threads.
  const std::vector<std::string>& rows(const char* name) const {
    static const std::vector<std::string> none;
    const Section* const section = find(name);
    if (!section) return none;
    for (const std::string& row : section->lines) expectAtMost(name, "columns", row.size());
    return section->lines;
  }

  void expectAtMost(const char* section, const char* what, size_t got) const {
    if (got > static_cast<size_t>(Weave::kMaxSide))
      throw InputError(
          fmt::format("{}: @@{}: expected at most {} {}, got {}", source_, section, Weave::kMaxSide, what, got));
  }

  /// The columns of a row that are 1, from 1.
  std::vector<int> marks(const char* name, const std::string& row) {
    std::vector<int> columns;
    for (size_t i = 0; i < row.size(); ++i)
      if (row[i] == '1') columns.push_back(static_cast<int>(i) + 1);
    if (row.find_first_not_of("01") != std::string::npos)
      say(name, row, "0 or 1 should stand here; other signs are taken as 0.", WifConcern::weave);
    return columns;
  }

  void readDraft() {
    Draft& draft = document_.draft;
    draft.threading = groups("threading", Weave::kMaxSide);
    draft.treadling = groups("treadling", Weave::kMaxSide);
    for (const std::string& row : rows("liftplan")) {
      if (draft.liftplan.size() > static_cast<size_t>(Weave::kMaxSide)) break;
      draft.liftplan.push_back(marks("liftplan", row));
    }
    if (draft.threading.empty() && draft.treadling.empty() && draft.liftplan.empty())
      throw InputError(
          fmt::format("{}: expected a draft, got a .dtx with no @@Threading, @@Treadling or @@Liftplan", source_));
    ends_ = threads("ends", draft.threading.size(), document_.named.ends);
    const bool lifted = !draft.liftplan.empty();
    picks_ = threads("picks", lifted ? draft.liftplan.size() : draft.treadling.size(), document_.named.picks);
    tidy(draft.threading, ends_);
    if (lifted) tidy(draft.liftplan, picks_);
    if (!lifted || !draft.treadling.empty()) tidy(draft.treadling, picks_);
    readTieUp(draft);
    for (const char* name : {"tieup", "liftplan"})
      if (const Section* section = find(name))
        for (const std::string& line : section->properties)
          if (lowerCase(line).ends_with("sinking")) draft.risingShed = false;
    fewerShafts(draft, source_, kDtxSections, warnings_);
    draft.shafts = kinds("shafts", largestOf({&draft.threading, &draft.tieUp, &draft.liftplan}));
    fewerTreadles(draft, kDtxSections, warnings_);
    validateDraft(draft, FieldPath(source_));
  }

  void readTieUp(Draft& draft) {
    const std::vector<std::string>& ofShafts = rows("tieup");
    expectAtMost("tieup", "rows", ofShafts.size());
    size_t columns = 0;
    for (const std::string& row : ofShafts) columns = std::max(columns, row.size());
    draft.treadles = kinds("treadles", std::max(largestOf({&draft.treadling}), static_cast<int>(columns)));
    if (!find("tieup") && draft.treadling.empty()) return;
    draft.tieUp.resize(static_cast<size_t>(draft.treadles));
    for (size_t shaft = 1; shaft <= ofShafts.size(); ++shaft)
      for (const int treadle : marks("tieup", ofShafts[ofShafts.size() - shaft]))
        draft.tieUp[static_cast<size_t>(treadle) - 1].push_back(static_cast<int>(shaft));
  }

  /// How many shafts or treadles: as stated, but no fewer than are used.
  int kinds(const char* key, int used) {
    const int number = stated(key);
    if (number <= std::max(used, mostShafts())) return std::max(number, used);
    say("info", fmt::format("{} {}", key, number),
        fmt::format("There can be {} {}; the draft uses {}.", mostShafts(), key, used), WifConcern::file);
    return used;
  }

  WifPalette palette() {
    WifPalette palette;
    const Section* table = find("color palet");
    if (!table) table = find("color palette");
    if (!table) return palette;
    for (size_t i = 0; i < table->lines.size() && i < static_cast<size_t>(kMaxWifNumber); ++i) {
      const std::vector<std::string_view> parts = wifList(table->lines[i]);
      glm::ivec3 colour(0);
      bool good = parts.size() == 3;
      for (int c = 0; c < 3 && good; ++c) {
        const std::optional<int> channel = wifWhole(parts[static_cast<size_t>(c)]);
        good = channel && *channel >= 0 && *channel <= 255;
        if (good) colour[c] = *channel;
      }
      if (good)
        palette.colours[static_cast<int>(i) + 1] = colour;
      else
        say("color palet", table->lines[i], "A colour should be three numbers from 0 to 255; this one is passed over.",
            WifConcern::look);
    }
    return palette;
  }

  std::vector<int> colours(const char* name, int threads) {
    std::vector<int> all(static_cast<size_t>(threads), 0);
    const NumberLists listed = groups(name, kMaxWifNumber - 1);
    for (size_t i = 0; i < listed.size() && i < all.size(); ++i) {
      const int number = listed[i].empty() ? 0 : listed[i][0] + 1;
      if (document_.rest.palette.colours.count(number) > 0)
        all[i] = number;
      else
        say(name, "", "There is no colour of some number; the thread takes the yarn's own.", WifConcern::look);
    }
    if (!listed.empty()) return all;
    // Where nothing is said the warp has the first colour, the weft the second.
    const int usual = std::string_view(name).starts_with("warp") ? 1 : 2;
    if (document_.rest.palette.colours.count(usual) > 0) std::fill(all.begin(), all.end(), usual);
    return all;
  }

  WifSizes sizes(const char* name, int threads) {
    WifSizes sizes;
    const NumberLists steps = groups(name, 1000);
    if (steps.empty()) return sizes;
    constexpr int kUsualSteps = 4;
    const auto length = [](int count) { return std::round(count * kStep_cm * 1e6) / 1e6; };
    sizes.spacing = length(kUsualSteps);
    for (size_t i = 0; i < steps.size() && i < static_cast<size_t>(threads); ++i)
      if (!steps[i].empty() && steps[i][0] > 0) sizes.spacings[static_cast<int>(i) + 1] = length(steps[i][0]);
    return sizes;
  }

  /// What no other section of a draft is: handed on as private.
  void keepOthers() {
    constexpr const char* kRead[] = {"startdtx",     "enddtx",        "description", "contents",    "imprint",
                                     "info",         "threading",     "treadling",   "tieup",       "liftplan",
                                     "color palet",  "color palette", "warp colors", "weft colors", "warp spacing",
                                     "weft spacing", "notes"};
    std::set<std::string> kept;
    for (const Section& section : sections_) {
      const bool isRead = std::find(std::begin(kRead), std::end(kRead), section.name) != std::end(kRead);
      if (isRead || section.lines.empty()) continue;
      const std::string name = fmt::format("PRIVATE DTX {}", wholeCharacters(section.name, 40));
      const bool isName = name.find(']') == std::string::npos && wifName(name) == wifName(trimmed(name));
      if (!isName || !kept.insert(wifName(name)).second) continue;
      std::vector<std::string> lines;
      for (const std::string& line : section.lines)
        if (!line.starts_with('[')) lines.push_back(line);
      document_.rest.kept.push_back({std::string(trimmed(name)), std::move(lines)});
    }
  }

  const std::string& source_;
  WifWarnings& warnings_;
  std::vector<Section> sections_;
  WifDocument document_;
  int ends_ = 0, picks_ = 0;
};

}  // namespace

bool isDtx(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  constexpr size_t kMark = 10;
  return lowerCase(trimmed(bytes.substr(0, 256)).substr(0, kMark)) == "@@startdtx";
}

WifDocument readDtx(std::string_view bytes, const std::string& source, WifWarnings& warnings) {
  return DtxReader(decodeText(bytes, source).text, source, warnings).read();
}

}  // namespace loomlight
