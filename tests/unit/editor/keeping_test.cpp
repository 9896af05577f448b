#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "app/editor/model/autosave.h"
#include "app/editor/model/left_work.h"
#include "app/editor/model/sample_fabric.h"
#include "app/editor/model/settings.h"
#include "app/editor/presets/preset_folder.h"
#include "app/editor/services/fabric_stats.h"
#include "core/base/error.h"
#include "core/base/file_lock.h"
#include "core/fabric/json/fabric_json.h"
#include "core/fabric/model/validate.h"
#include "core/fabric/model/yarn_count.h"
#include "tests/support/full_disk.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/wakes.h"
#include "tests/support/write_protected.h"

namespace loomlight {
namespace {
namespace fs = std::filesystem;

/// An empty folder, removed at the end of the test.
class Folder {
 public:
  explicit Folder(const std::string& ending = "")
      : path(fs::path(testing::TempDir()) / ("loomlight-" + std::to_string(getpid()) + ending)) {
    fs::remove_all(path);
  }
  ~Folder() { fs::remove_all(path); }
  fs::path path;
};

/// What another thread does and nobody is woken of.
bool comesTrue(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + Wakes::kHangs;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

/// Lets it keep the sample; false if no copy came.
bool keepsSample(Autosave& autosave) {
  autosave.keep(std::make_shared<const Fabric>(sampleFabric()));
  return comesTrue([&] { return fs::exists(autosave.file()); });
}

TEST(Autosave, KeepsACopyAndRemovesItAtAGoodEnd) {
  const Folder folder;
  Autosave autosave(folder.path);
  ASSERT_TRUE(keepsSample(autosave));
  EXPECT_EQ(readFabric(autosave.file().string()), sampleFabric());
  EXPECT_FALSE(Autosave::leftBehind(folder.path).has_value()) << "its editor is still running";
  autosave.endWell();
  EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST(Autosave, LeavesTheCopyWhenTheEditorIsTornDown) {
  const Folder folder;
  fs::path file;
  {
    Autosave autosave(folder.path);
    ASSERT_TRUE(keepsSample(autosave));
    file = autosave.file();
  }
  EXPECT_EQ(readFabric(file.string()), sampleFabric());
  EXPECT_EQ(Autosave::leftBehind(folder.path), file) << "though a process of its number is running: this one";
  Autosave next(folder.path);
  next.throwAway(file);
  next.endWell();
  EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST(Autosave, NeverRemovesADesignersFile) {
  const Folder folder, other("-other");
  for (const Folder* in : {&folder, &other}) fs::create_directories(in->path);
  const fs::path named = folder.path / "cloth.json", elsewhere = other.path / "autosave-1-1.json";
  for (const fs::path& file : {named, elsewhere}) {
    writeFabric(sampleFabric(), file.string());
    Autosave autosave(folder.path);
    autosave.throwAway(file);
    EXPECT_TRUE(fs::exists(file)) << "thrown away: " << file;
    autosave.takeOver(file);
    ASSERT_TRUE(keepsSample(autosave));
    autosave.endWell();
    EXPECT_TRUE(fs::exists(file)) << "taken over: " << file;
  }
}

TEST(Autosave, SweepsLocksOfEditorsThatLeftNoCopy) {
  const Folder folder;
  fs::create_directories(folder.path);
  const fs::path old = folder.path / "autosave-1-1.lock", young = folder.path / "autosave-2-2.lock",
                 withCopy = folder.path / "autosave-3-3.lock", held = folder.path / "autosave-4-4.lock";
  std::ofstream(folder.path / "autosave-3-3.json") << "{}";
  for (const fs::path& lock : {old, young, withCopy, held}) std::ofstream(lock) << "";
  const auto running = FileLock::make(held);
  ASSERT_TRUE(running);
  for (const fs::path& lock : {old, withCopy, held})
    fs::last_write_time(lock, fs::file_time_type::clock::now() - std::chrono::hours(1));
  const Autosave autosave(folder.path);
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(young)) << "its editor may be about to lock it";
  EXPECT_TRUE(fs::exists(withCopy)) << "it goes with its copy";
  EXPECT_TRUE(fs::exists(held)) << "its editor is running, with nothing unsaved";
}

TEST(Autosave, EditorsNeverShareACopy) {
  const Folder folder;
  Autosave first(folder.path);
  ASSERT_TRUE(keepsSample(first));
  fs::path second;
  {
    Autosave other(folder.path);
    ASSERT_TRUE(keepsSample(other));
    second = other.file();
    EXPECT_NE(second, first.file());
    EXPECT_FALSE(Autosave::leftBehind(folder.path).has_value());
  }
  EXPECT_EQ(Autosave::leftBehind(folder.path), second);
}

TEST(Autosave, WhatIsTakenUpGoesOnceItIsKeptAgain) {
  const Folder folder;
  fs::create_directories(folder.path);
  const fs::path left = folder.path / "autosave-2000000000.json";
  writeFabric(sampleFabric(), left.string());
  Autosave autosave(folder.path);
  autosave.takeOver(left);
  EXPECT_TRUE(fs::exists(left));
  autosave.keep(std::make_shared<const Fabric>(sampleFabric()));
  EXPECT_TRUE(comesTrue([&] { return !fs::exists(left); }));
  EXPECT_TRUE(fs::exists(autosave.file())) << "at no time there is no copy";
}

TEST(Autosave, MakesItsFolderAgainThatWasRemoved) {
  const Folder folder;
  Autosave autosave(folder.path);
  ASSERT_TRUE(keepsSample(autosave));
  fs::remove_all(folder.path);
  ASSERT_TRUE(keepsSample(autosave));
  EXPECT_EQ(autosave.problem(), "");
  EXPECT_FALSE(Autosave::leftBehind(folder.path).has_value()) << "its editor is still running";
}

TEST(Autosave, SaysWhyWorkIsNotSafe) {
  const Folder folder;
  std::ofstream(folder.path) << "in the way of the folder";
  std::atomic<int> woken = 0;
  Autosave autosave(folder.path, [&] { ++woken; });
  EXPECT_EQ(autosave.problem(), "");
  autosave.keep(std::make_shared<const Fabric>(sampleFabric()));
  ASSERT_TRUE(comesTrue([&] { return woken > 0; }));
  EXPECT_NE(autosave.problem().find("the folder could not be made"), std::string::npos) << autosave.problem();
  fs::remove(folder.path);
  fs::create_directories(folder.path);
  autosave.forget();
  EXPECT_TRUE(comesTrue([&] { return autosave.problem().empty(); }));
}

TEST(Autosave, FindsWhatADeadEditorLeft) {
  const Folder folder;
  fs::create_directories(folder.path);
  const fs::path left = folder.path / "autosave-1-1.json";
  std::ofstream(left) << "{}";
  std::ofstream(folder.path / "autosave-1-1.lock") << "";
  std::ofstream(folder.path / "notes.json") << "{}";
  EXPECT_EQ(Autosave::leftBehind(folder.path), left);
}

TEST(LeftWork, IsNamedHoweverMuchOfItThereIs) {
  const Folder folder;
  fs::create_directories(folder.path);
  const fs::path left = folder.path / "autosave-1-1.json";
  Fabric fabric = sampleFabric();
  fabric.name = "Half \"blue\"";
  fabric.fibres.front().name = "another name";
  writeFabric(fabric, left.string());
  EXPECT_THAT(aboutLeftWork(left), testing::HasSubstr("Half \"blue\""));
  EXPECT_THAT(aboutLeftWork(left), testing::HasSubstr(" at "));
  fs::resize_file(left, 100);
  EXPECT_THAT(aboutLeftWork(left), testing::HasSubstr("Half \"blue\"")) << "though it breaks off";
  std::ofstream(left) << "{\"fibres\": [{\"name\": \"wool\"}], \"name\": 7}";
  EXPECT_THAT(aboutLeftWork(left), testing::StartsWith("A cloth was last edited")) << "nothing in it is a cloth's name";
}

TEST(PresetFolder, KeepsAndLoads) {
  const Folder folder;
  PresetFolder store(folder.path);
  EXPECT_TRUE(store.names().empty());
  Fabric fabric = sampleFabric();
  fabric.name = "../half/blue";
  const std::string name = store.keep(fabric);
  EXPECT_EQ(store.names(), std::vector<std::string>{name});
  EXPECT_EQ(store.load(name), fabric);
  EXPECT_TRUE(fs::exists(folder.path / (name + ".json"))) << "a name must not lead out of the folder";
  EXPECT_THROW(store.load("none"), InputError);
}

TEST(PresetFolder, DressingKeepsTheScene) {
  Fabric scene = sampleFabric(0);
  scene.light.kind = LightKind::dome;
  scene.camera.azimuth_deg = 17;
  const Fabric cloth = sampleFabric(1);
  const Fabric worn = dressed(scene, cloth);
  EXPECT_EQ(worn.weave, cloth.weave);
  EXPECT_EQ(worn.yarns, cloth.yarns);
  EXPECT_EQ(worn.light, scene.light);
  EXPECT_EQ(worn.camera, scene.camera);
  EXPECT_EQ(worn.drape, scene.drape);
}

TEST(Samples, AllOpen) {
  for (size_t i = 0; i < sampleNames().size(); ++i) EXPECT_EQ(sampleFabric(i).name, sampleNames()[i]);
}

/// A hand is 8 to 12 cm broad: there folds and weave are seen together.
TEST(Samples, TheFirstStartShowsAHandsBreadth) {
  const Fabric fabric = welcomeFabric();
  const double seen_mm = 2 * fabric.camera.distance_mm * std::tan(fabric.camera.fov_deg / 2 * kPi / 180);
  EXPECT_GT(seen_mm, 80);
  EXPECT_LT(seen_mm, 120);
  EXPECT_GT(std::min(fabric.drape.width_mm, fabric.drape.height_mm), seen_mm) << "cloth up to the edges";
  EXPECT_EQ(fabric.drape.kind, DrapeKind::folds);
}

TEST(Samples, ANewClothIsOfSpunYarns) {
  const Fabric fabric = newFabric();
  EXPECT_NO_THROW(validate(fabric, "a new cloth"));
  ASSERT_GT(fabric.yarns.size(), 1u);
  for (const Yarn& yarn : fabric.yarns) {
    EXPECT_GT(yarn.hairiness_per_mm, 0);
    EXPECT_GT(yarn.evennessCv_percent, 0);
  }
}

/// A new cloth is fitted into the window, and as large as a hand.
TEST(Samples, ANewClothIsAHandsBreadth) {
  const Drape drape = newFabric().drape;
  EXPECT_EQ(drape.kind, DrapeKind::flat);
  for (const double side_mm : {drape.width_mm, drape.height_mm}) {
    EXPECT_GT(side_mm, 80);
    EXPECT_LT(side_mm, 120);
  }
}

TEST(Settings, ComeBackAndSurviveNonsense) {
  const Folder folder;
  const fs::path file = folder.path / "editor.json";
  Settings settings;
  settings.windowWidth = 1777;
  settings.darkTheme = false;
  settings.dock.draftWidth = 401;
  settings.units.count = CountSystem::denier;
  settings.units.piece.width_cm = 90;
  settings.recent = {{"/a.json", false}, {"/b.json", false}};
  settings.hintsSeen = true;
  settings.view.denoised = settings.view.draftBack = true;
  settings.view.filmic = false;
  settings.snapshot.dpi = 150;
  settings.snapshot.caption = "for one client only";
  writeSettings(file, settings);
  EXPECT_EQ(readSettings(file).windowWidth, 1777);
  EXPECT_FALSE(readSettings(file).darkTheme);
  EXPECT_EQ(readSettings(file).dock.draftWidth, 401);
  EXPECT_EQ(readSettings(file).units.count, CountSystem::denier);
  EXPECT_EQ(readSettings(file).units.piece.width_cm, 90);
  ASSERT_EQ(readSettings(file).recent.size(), 2u);
  EXPECT_EQ(readSettings(file).recent[1].file, "/b.json");
  EXPECT_TRUE(readSettings(file).hintsSeen);
  EXPECT_TRUE(readSettings(file).view.denoised);
  EXPECT_TRUE(readSettings(file).view.draftBack);
  EXPECT_FALSE(readSettings(file).view.filmic);
  EXPECT_EQ(readSettings(file).snapshot.dpi, 150);
  EXPECT_EQ(readSettings(file).snapshot.caption, "");
  for (const char* text :
       {"", "[]", "{\"window_width\": \"wide\"}", "{\"window_width\": -5}", "{\"snapshot_dpi\": 0}", "\xff\xfe"}) {
    std::ofstream(file) << text;
    EXPECT_GE(readSettings(file).windowWidth, 960) << text;
    EXPECT_GE(readSettings(file).snapshot.dpi, kPrintResolution_dpi[0]) << text;
  }
}

TEST(Settings, AFullDiskKeepsTheOldOnesAndSaysSo) {
  const Folder folder;
  const std::string file = (folder.path / "editor.json").string();
  writeSettings(file, Settings());
  Settings settings;
  settings.windowWidth = 1777;
  {
    const test::FullDisk full(1000);
    EXPECT_THAT(test::messageOf<InputError>([&] { writeSettings(file, settings); }),
                testing::AllOf(testing::HasSubstr(file), testing::HasSubstr("File too large")));
  }
  EXPECT_EQ(readSettings(file).windowWidth, Settings().windowWidth);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path), {}), 1) << "something was left beside them";
}

TEST(Settings, ThatAreWriteProtectedStayAndThatIsSaid) {
  test::humbly([] {
    const Folder folder;
    const std::string file = (folder.path / "editor.json").string();
    writeSettings(file, Settings());
    const std::string before = test::bytesOf(file);
    for (const fs::path& place : {fs::path(file), folder.path}) {
      const test::WriteProtected kept(place);
      EXPECT_THAT(test::messageOf<InputError>([&] { writeSettings(file, Settings()); }),
                  testing::AllOf(testing::HasSubstr(file), testing::HasSubstr("Permission denied")));
      EXPECT_EQ(test::bytesOf(file), before);
    }
  });
}

TEST(Settings, OneThatMakesNoSenseCostsNoOther) {
  const Folder folder;
  const fs::path file = folder.path / "editor.json";
  writeSettings(file, Settings());  // makes the folder
  std::ofstream(file) << R"({"window_width": 1777, "window_height": 1e300, "dark_theme": "no", "count_unit": 7,
                             "recent": ["/a.json", 5, "/b.json"], "exposure_stops": [], "loom_shafts": 12})";
  const Settings read = readSettings(file);
  EXPECT_EQ(read.windowWidth, 1777);
  EXPECT_EQ(read.windowHeight, Settings().windowHeight);
  EXPECT_EQ(read.darkTheme, Settings().darkTheme);
  EXPECT_EQ(read.units.count, Settings().units.count);
  ASSERT_EQ(read.recent.size(), 2u);
  EXPECT_EQ(read.recent[1].file, "/b.json");
  EXPECT_EQ(read.draft.loom.shafts, 12);
}

TEST(Settings, AFolderWhoseNameIsNoTextCostsNoSetting) {
  const Folder folder;
  const fs::path file = folder.path / "editor.json";
  Settings settings;
  settings.windowWidth = 1777;
  settings.folder = "/home/caf\xe9";
  writeSettings(file, settings);
  EXPECT_EQ(readSettings(file).windowWidth, 1777);
}

}  // namespace
}  // namespace loomlight
