#include "core/fabric/wif/wif_reader.h"

#include <fmt/format.h>

#include <map>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/text_encoding.h"
#include "core/fabric/wif/wif_numbered.h"
#include "core/fabric/wif/wif_thickness.h"
#include "core/fabric/wif/wif_values.h"

// How it works. A weaving file (WIF 1.1 of 1997) is read in steps, each of which puts up with what can be understood
// and notes it as a warning: bytes become text (text_encoding), text sections (wif_sections); then it is found from
// which number the file counts (wif_counting); with that, the draft is read, then colours, sizes and whatever is
// only kept for the way back. Where no sense can be made of it, an InputError says what was expected. Cost: linear
// in the text.

namespace loomlight {
namespace {

/// The text of a key; empty where there is none.
std::string textOf(const WifSections& sections, std::string_view section, std::string_view key) {
  const WifSection* const found = sections.find(section);
  const WifEntry* const entry = found ? found->find(key) : nullptr;
  return entry ? std::string(unquoted(entry->value)) : std::string();
}

/// A file of another kind has none of these.
void expectWeavingFile(const WifSections& sections, const std::string& source) {
  for (const char* name : {"WIF", "WEAVING", "THREADING", "TREADLING", "LIFTPLAN", "WARP", "WEFT"})
    if (sections.find(name)) return;
  throw InputError(
      fmt::format("{}: expected a WIF draft with sections such as [WIF], [WARP] and [THREADING], got none of "
                  "them",
                  source));
}

void expectDraft(const WifSections& sections, const std::string& source) {
  for (const char* name : {"WARP", "WEFT", "THREADING", "TREADLING", "LIFTPLAN"})
    if (sections.find(name)) return;
  throw InputError(fmt::format("{}: expected a draft, got a WIF draft with no [WARP], [WEFT] or [THREADING]", source));
}

/// [CONTENTS] should list what there is. Whatever it says, what is there is read.
void checkContents(const WifSections& sections, WifWarnings& warnings) {
  const WifSection* const contents = sections.find("CONTENTS");
  if (!contents) return;
  std::map<std::string, bool> there;
  for (const WifSection& section : sections.sections)
    there[wifName(section.name)] = !section.entries.empty() || !section.lines.empty();
  std::map<std::string, bool> listed;
  for (const WifEntry& entry : contents->entries) {
    const std::optional<bool> yes = wifBoolean(entry.value);
    if (!yes)
      warnings.add(entry.line, "CONTENTS", entry.key,
                   "In the table of contents, true or false should stand here; the line is passed over.");
    const std::string name = wifName(entry.key);
    if (yes.value_or(false) && there.count(name) == 0)
      warnings.add(entry.line, "CONTENTS", entry.key, "The table of contents names what is not there.");
    if (yes) listed[name] = *yes;
  }
  for (const auto& [name, filled] : there) {
    if (name == "WIF" || name == "CONTENTS") continue;
    const auto found = listed.find(name);
    if (found != listed.end() && !found->second && filled)
      warnings.add(0, "CONTENTS", name,
                   "The table of contents says that this part is not there; it is read all the same.");
  }
}

std::vector<std::string> readNotes(const WifSections& sections, int first, WifWarnings& warnings) {
  std::map<int, std::string> lines;
  forEachNumbered(sections.find("NOTES"), first, kMaxWifNumber, "line", warnings,
                  [&](int number, const WifEntry& entry) { lines[number] = entry.value; });
  std::vector<std::string> notes;
  for (auto& [number, line] : lines) notes.push_back(std::move(line));
  return notes;
}

/// Lengths of threads that the draft does not have.
void cutSizes(std::map<int, double>& lengths, const char* section, int threads, WifWarnings& warnings) {
  const auto beyond = lengths.upper_bound(threads);
  if (beyond == lengths.end()) return;
  warnings.add(0, section, fmt::format("{}", beyond->first),
               fmt::format("There are threads 1 to {} only; what is said of others is passed over.", threads));
  lengths.erase(beyond, lengths.end());
}

}  // namespace

WifDocument readWif(std::string_view bytes, const std::string& source, WifWarnings& warnings) {
  const DecodedText decoded = decodeText(bytes, source);
  if (decoded.encoding == TextEncoding::windows1252)
    warnings.add(0, "", "", "The text is not UTF-8; accents and the like are read as Windows-1252.");
  const WifSections sections = parseWifSections(decoded.text, source, warnings);
  expectWeavingFile(sections, source);
  // Version, date and developers are those of the specification in every file, and nothing hangs on them.
  if (!sections.find("WIF"))
    warnings.add(0, "WIF", "", "The part that names the format is missing; the file is read as WIF 1.1.");
  checkContents(sections, warnings);
  expectDraft(sections, source);

  const WifCounting counting = wifCounting(sections, warnings);
  WifDocument document;
  document.title = textOf(sections, "TEXT", "title");
  document.notes = readNotes(sections, counting.note, warnings);
  const std::string program = textOf(sections, "WIF", "source program");
  document.program = trimmed(program + " " + textOf(sections, "WIF", "source version"));
  document.draft = readWifDraft(sections, counting, source, warnings, document.named);
  document.rest = readWifRest(sections, counting, warnings);
  const Draft& draft = document.draft;
  const auto ends = static_cast<int>(draft.threading.size());
  const auto picks = static_cast<int>(draft.liftplan.empty() ? draft.treadling.size() : draft.liftplan.size());
  WifRest& rest = document.rest;
  cutSizes(rest.warp.spacings, "WARP SPACING", ends, warnings);
  cutSizes(rest.warp.thicknesses, "WARP THICKNESS", ends, warnings);
  cutSizes(rest.weft.spacings, "WEFT SPACING", picks, warnings);
  cutSizes(rest.weft.thicknesses, "WEFT THICKNESS", picks, warnings);
  document.warpColours = readWifColours(sections, counting, System::warp, ends, rest.palette, warnings);
  document.weftColours = readWifColours(sections, counting, System::weft, picks, rest.palette, warnings);
  noteGaps(rest.warp, System::warp, sizedThreads(rest.warp, ends, document.named.ends), warnings);
  noteGaps(rest.weft, System::weft, sizedThreads(rest.weft, picks, document.named.picks), warnings);
  return document;
}

}  // namespace loomlight
