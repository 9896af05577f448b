#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace loomlight {

/// Whether it is the name of a fabric: both endings stand for the same JSON. ".json" is what other programs open as
/// well; ".loomlight" is ours alone, so that a desktop opens it with this program.
bool isFabricFile(const std::string& file);

/// Whether it is to be read as a weaving file: WIF, which PixeLoom calls .plm, .dtx or .twa; some come by mail as
/// texts, "draft.wif.txt".
bool isWeavingFile(const std::string& file);

/// The program whose own drafts end so, which are not read: "WeavePoint" for .wpo. They can be had as WIF from it.
std::optional<std::string> programOfForeignDraft(const std::string& file);

/// Makes a file's name of a name for people: without a folder in it, not hidden, of characters that all systems allow,
/// and so short that a number still fits behind it on any of them.
std::string fileNameOf(const std::string& name);

/// The same of letters and digits of ASCII, "-", "_" and what is not ASCII alone, for formats that allow less.
std::string portableFileName(const std::string& name);

/// Whether something is there, be it a link that leads nowhere.
bool isTaken(const std::filesystem::path& file);

/// That file, or where it is taken one beside it: "twill.png", "twill 2.png", "twill 3.png", ...
std::filesystem::path freeFile(const std::filesystem::path& wanted);

}  // namespace loomlight
