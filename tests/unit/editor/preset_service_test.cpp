#include "app/editor/services/preset_service.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>

#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/support/memory_driver.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/wakes.h"

namespace loomlight {
namespace {
namespace fs = std::filesystem;

class PresetServiceTest : public testing::Test {
 protected:
  static Fabric cloth(const std::string& name) {
    Fabric fabric;
    fabric.name = name;
    return fabric;
  }
  static std::vector<std::string> own(const PresetFolder& store) { return store.names(); }

  MemoryDriver driver_;
  Wakes wakes_;
  test::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path() / "presets";  // not there yet
};

TEST(GivenPresets, FibresAreShownInYarnsAsTheyAreSpun) {
  for (const Preset& preset : givenPresets(PresetKind::fibres, 1)) {
    const bool isFilament =
        preset.name == "silk" || preset.name == "viscose" || preset.name == "polyester" || preset.name == "nylon";
    for (const auto& fabric : {preset.fabric, preset.portrait}) {
      EXPECT_EQ(fabric->yarns[0].hairiness_per_mm > 0, !isFilament) << preset.name;
      EXPECT_GT(fabric->yarns[0].fibreDisorder_deg, 0) << preset.name;
    }
  }
}

TEST_F(PresetServiceTest, StoresKeepNamesApart) {
  PresetFolder store(folder_);
  EXPECT_EQ(store.keep(cloth("Tweed")), "Tweed");
  EXPECT_EQ(store.keep(cloth("Tweed")), "Tweed 2");
  EXPECT_EQ(store.keep(cloth("Tweed")), "Tweed 3");
  EXPECT_EQ(store.load("Tweed 2").name, "Tweed 2");
}

TEST_F(PresetServiceTest, LongNamesAreCutBetweenCharactersAndStillKeptApart) {
  PresetFolder store(folder_);
  std::string name;
  for (int i = 0; i < 70; ++i) name += "\u00E9";
  const std::string first = store.keep(cloth(name));
  EXPECT_EQ(first, name.substr(0, 100));
  EXPECT_EQ(store.keep(cloth(name)), first + " 2");
  name = fmt::format("x{}", name);
  EXPECT_EQ(store.keep(cloth(name)), name.substr(0, 99)) << "a character is not halved";
}

TEST_F(PresetServiceTest, TagsLast) {
  PresetTags(folder_ / "tags").set("Tweed", "winter, client A");
  PresetTags tags(folder_ / "tags");
  EXPECT_EQ(tags.of("Tweed"), "winter, client A");
  EXPECT_EQ(tags.of("Denim"), "");
  tags.set("Tweed", "");
  EXPECT_EQ(PresetTags(folder_ / "tags").of("Tweed"), "");
  EXPECT_EQ(PresetFolder(folder_).names().size(), 0u) << "tags are no preset";
}

TEST_F(PresetServiceTest, TagsThatCannotBeReadAreSaidAndPutAside) {
  fs::create_directories(folder_);
  EXPECT_EQ(PresetTags(folder_ / "tags").problem(), "") << "a file that is not there is no problem";
  int readings = 0;
  for (const char* text : {"", "[1]", "{\"Tweed\": 7}", "\xff"}) {
    std::ofstream(folder_ / "tags") << text;
    PresetTags tags(folder_ / "tags");
    EXPECT_EQ(tags.of("Tweed"), "") << text;
    EXPECT_NE(tags.problem(), "") << text;
    tags.set("Tweed", "winter");
    EXPECT_EQ(tags.problem(), "") << text;
    EXPECT_EQ(PresetTags(folder_ / "tags").of("Tweed"), "winter");
    const fs::path aside =
        folder_ / (++readings == 1 ? "tags.unreadable" : fmt::format("tags {}.unreadable", readings));
    EXPECT_EQ(readFile(aside.string(), 100), text);
  }
}

TEST_F(PresetServiceTest, WhateverIsInTheWayOfTagsIsPutAside) {
  const fs::path file = folder_ / "tags", aside = folder_ / "tags.unreadable";
  const std::function<void()> ways[] = {[&] { fs::create_directories(file); },
                                        [&] { fs::create_symlink(file, file); },  // leads round in a circle
                                        [&] { fs::create_symlink(folder_ / "none", file); }};
  for (const auto& putInTheWay : ways) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    putInTheWay();
    PresetTags tags(file);
    EXPECT_NE(tags.problem(), "");
    tags.set("Tweed", "winter");
    EXPECT_EQ(tags.problem(), "");
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(file)));
    EXPECT_TRUE(fs::exists(fs::symlink_status(aside))) << "it is kept";
    EXPECT_EQ(PresetTags(file).of("Tweed"), "winter");
  }
}

TEST_F(PresetServiceTest, TagsThatCannotBeWrittenAreRefused) {
  std::ofstream(folder_) << "in the way of the folder";
  PresetTags tags(folder_ / "tags");
  EXPECT_THROW(tags.set("Tweed", "winter"), InputError);
  EXPECT_EQ(tags.of("Tweed"), "");
}

TEST_F(PresetServiceTest, RenamingNeverWritesOverAnother) {
  PresetFolder store(folder_);
  store.keep(cloth("A"));
  store.keep(cloth("B"));
  EXPECT_EQ(store.rename("A", "B"), "B 2");
  EXPECT_EQ(own(store), (std::vector<std::string>{"B", "B 2"}));
  EXPECT_EQ(store.rename("B 2", "A"), "A");
  EXPECT_EQ(own(store), (std::vector<std::string>{"A", "B"}));
  EXPECT_THROW(store.rename("C", "D"), InputError);
}

TEST_F(PresetServiceTest, WhatIsRemovedCanBePutBack) {
  PresetFolder store(folder_);
  Fabric first = cloth("A"), second = cloth("A");
  first.ends_per_cm = 11;
  second.ends_per_cm = 12;
  store.keep(first);
  const PresetFolder::Removed removedFirst = store.remove("A");
  EXPECT_TRUE(own(store).empty());
  store.keep(second);
  EXPECT_THROW(store.putBack(removedFirst), InputError) << "a new one has taken the name";
  const PresetFolder::Removed removedSecond = store.remove("A");
  store.putBack(removedFirst);
  EXPECT_EQ(store.load("A").ends_per_cm, 11) << "of two of one name, the one that was meant";
  store.remove("A");
  store.putBack(removedSecond);
  EXPECT_EQ(store.load("A").ends_per_cm, 12);
}

TEST_F(PresetServiceTest, WhatCouldNotBeTakenBackIsTriedAgain) {
  PresetLibrary cabinet(folder_);
  const auto kind = PresetKind::fabrics;
  cabinet.keep(kind, cloth("A"));
  cabinet.keep(kind, cloth("B"));
  cabinet.remove(kind, "A");
  const std::string removed = cabinet.lastChange();
  PresetFolder(folder_).keep(cloth("A"));  // by another editor
  EXPECT_THROW(cabinet.undo(), InputError);
  EXPECT_EQ(cabinet.lastChange(), removed);
  fs::remove(folder_ / "A.json");
  cabinet.undo();
  EXPECT_EQ(PresetFolder(folder_).names(), (std::vector<std::string>{"A", "B"}));
  EXPECT_NE(cabinet.lastChange(), removed);
}

TEST_F(PresetServiceTest, OnlyWhatHasChangedIsReadAgain) {
  PresetLibrary cabinet(folder_);
  const auto kind = PresetKind::fabrics;
  const auto readAll = [&] {
    int count = 0;
    cabinet.look(kind, 1);
    while (cabinet.readNext(kind)) ++count;
    return count;
  };
  cabinet.keep(kind, cloth("A"));
  cabinet.keep(kind, cloth("B"));
  std::ofstream(folder_ / "C.json") << "no cloth";
  EXPECT_EQ(readAll(), 3);
  EXPECT_EQ(readAll(), 0);
  std::ofstream(folder_ / "B.json") << "no longer one";
  EXPECT_EQ(readAll(), 1);
  std::vector<std::string> own;
  for (const Preset& preset : cabinet.presets(kind))
    if (preset.own) own.push_back(preset.name);
  EXPECT_EQ(own, std::vector<std::string>{"A"});
  EXPECT_EQ(cabinet.presets(kind).front().fabric->name, "A");
}

/// Takes what comes until it is so.
template <class Condition>
bool comes(Wakes& wakes, PresetService& service, const Condition& condition) {
  return wakes.until([&] {
    service.take();
    return condition();
  });
}

TEST_F(PresetServiceTest, CardsComeAndFollowWhatIsChanged) {
  PresetFolder(folder_).keep(cloth("A"));
  PresetService service(folder_, driver_, wakes_.callback());
  const auto kind = PresetKind::fabrics;
  const auto isFirst = [&](const std::string& name) {
    const auto cards = service.cards(kind, 1);
    return !cards.empty() && cards[0].name == name;
  };
  ASSERT_TRUE(comes(wakes_, service, [&] { return isFirst("A"); }));
  Fabric now;
  now.light.kind = LightKind::dome;
  EXPECT_EQ(service.used(0, now, 0, 0).name, "A");
  EXPECT_EQ(service.used(0, now, 0, 0).light, now.light);
  service.rename(0, "Z");
  ASSERT_TRUE(comes(wakes_, service, [&] { return isFirst("Z"); }));
  service.remove(0);
  EXPECT_FALSE(isFirst("Z")) << "it is not there to be removed again";
  service.undo();
  EXPECT_TRUE(comes(wakes_, service, [&] { return isFirst("Z"); }));
  for (int change = 0; change < 3; ++change) EXPECT_EQ(service.takeOutcome().value().problem, "");
  EXPECT_FALSE(service.takeOutcome());
}

TEST_F(PresetServiceTest, WhatCannotBeKeptIsSaid) {
  std::ofstream(folder_) << "in the way of the folder";
  PresetService service(folder_, driver_, wakes_.callback());
  service.keep(PresetKind::fabrics, cloth("A"), 0, 0);
  std::optional<PresetService::Outcome> outcome;
  ASSERT_TRUE(comes(wakes_, service, [&] { return (outcome = service.takeOutcome()).has_value(); }));
  EXPECT_NE(outcome->problem.find("could not be made"), std::string::npos) << outcome->problem;
  EXPECT_EQ(outcome->kept, "");
  EXPECT_EQ(service.lastChange(), "");
}

TEST_F(PresetServiceTest, WhatWasToBeKeptIsKeptBeforeTheEnd) {
  for (const char* name : {"A", "B", "C"}) PresetFolder(folder_).keep(cloth(name));
  {
    PresetService service(folder_, driver_, wakes_.callback());
    service.cards(PresetKind::fabrics, 1);
    for (int i = 0; i < 3; ++i) service.keep(PresetKind::yarns, cloth("mine"), 0, 0);
  }
  EXPECT_EQ(PresetFolder(folder_ / "yarns").names().size(), 3u);
}

TEST(PresetSearch, FindsBeginningsOfWordsInAnyOrder) {
  EXPECT_TRUE(matchesSearch("Blue twill cotton", "cot tw"));
  EXPECT_TRUE(matchesSearch("Blue twill", ""));
  EXPECT_TRUE(matchesSearch("Blue twill", "  BLUE "));
  EXPECT_FALSE(matchesSearch("Blue twill", "ill"));
  EXPECT_FALSE(matchesSearch("Blue twill", "blue wool"));
}

}  // namespace
}  // namespace loomlight
