#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/fabric/model/colourways.h"
#include "tests/headless/editor/headless_editor.h"
#include "tests/headless/editor/small_cloth.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {

inline constexpr const char* kOld = "what was there";

/// All files below a folder, by their names in it.
inline std::map<std::string, std::string> filesIn(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    files[entry.path().lexically_relative(folder).string()] =
        entry.is_regular_file() ? test::bytesOf(entry.path().string()) : "(a folder)";
  return files;
}

/// An editor of a cloth that is soon rendered, and a folder for what is written beside the cloth.
struct EditorBesideAFolder {
  explicit EditorBesideAFolder(Fabric cloth = smallCloth("Blue")) {
    cloth.colourways = {colourwayOf(cloth, "Rust")};
    cloth.render.width = cloth.render.height = 24;
    cloth.render.samplesPerPixel = 1;
    editor.start(cloth);
    std::filesystem::create_directory(out);
  }
  /// In the folder that is looked at.
  std::string oldFile(const std::string& name) {
    const std::string file = (out / name).string();
    test::putBytes(file, kOld);
    return file;
  }
  void clickAll(const std::vector<std::string>& widgets) {
    for (const std::string& widget : widgets) editor.click(widget);
  }
  /// Over an old one, too.
  void writeBy(const std::vector<std::string>& way, const std::string& file) {
    clickAll(way);
    editor.nameFile(file);
    editor.click("browser.ok");
  }
  void untilSaid(const std::string& fact, const std::string& said) {
    editor.until(fact + " says: " + said, [&] { return editor.fact(fact).find(said) != std::string::npos; });
  }
  void close(const std::string& dialog) {
    editor.click(dialog + ".close");
    editor.untilNoDialogIsOpen();
  }

  HeadlessEditor editor{{1280, 1000, 1}};
  const std::filesystem::path out = editor.home() / "out";
};

}  // namespace loomlight
