#include "app/editor/services/file_service.h"

#include <gtest/gtest.h>

#include <future>
#include <thread>

#include "core/fabric/json/fabric_json.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/wakes.h"

namespace loomlight {
namespace {

class FileServiceTest : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return folder_.file(name); }
  static std::shared_ptr<const Fabric> named(const std::string& name) {
    Fabric fabric;
    fabric.name = name;
    return std::make_shared<const Fabric>(std::move(fabric));
  }
  std::optional<FileService::Result> result() {
    std::optional<FileService::Result> come;
    wakes_.until([&] { return (come = service_.take()).has_value(); });
    return come;
  }

  test::ScratchFolder folder_;
  Wakes wakes_;
  FileService service_{wakes_.callback()};
};

TEST_F(FileServiceTest, SavesAndOpens) {
  service_.save(at("a.json"), named("Tweed"), 7);
  ASSERT_TRUE(service_.busy());
  EXPECT_EQ(service_.busy()->work, FileService::Work::save);
  const auto saved = result();
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->problem, "");
  EXPECT_EQ(saved->state, 7u);
  EXPECT_FALSE(service_.busy());
  service_.open(FileService::Work::open, at("a.json"), named("mine"), 9);
  const auto opened = result();
  ASSERT_TRUE(opened && opened->fabric);
  EXPECT_EQ(opened->state, 9u) << "what is edited meanwhile must be told from what was there";
  EXPECT_EQ(opened->fabric->name, "Tweed");
  EXPECT_EQ(opened->file, at("a.json"));
}

TEST_F(FileServiceTest, SaysWhatWentWrong) {
  service_.open(FileService::Work::open, at("none.json"), named("mine"), 0);
  const auto opened = result();
  ASSERT_TRUE(opened);
  EXPECT_FALSE(opened->fabric);
  EXPECT_NE(opened->problem.find("none.json"), std::string::npos) << opened->problem;
  service_.save(at("no folder/a.json"), named("Tweed"), 1);
  const auto saved = result();
  ASSERT_TRUE(saved);
  EXPECT_NE(saved->problem.find("no folder"), std::string::npos) << saved->problem;
}

TEST_F(FileServiceTest, WhatIsCancelledDoesNotCome) {
  writeFabric(*named("Tweed"), at("a.json"));
  writeFabric(*named("Twill"), at("b.json"));
  for (const auto work : {FileService::Work::open, FileService::Work::takeUp, FileService::Work::usePreset}) {
    service_.open(work, at("a.json"), named("mine"), 0);
    EXPECT_TRUE(service_.isReading() && service_.canCancel());
    service_.cancel();
    EXPECT_FALSE(service_.busy() || service_.isReading());
  }
  service_.open(FileService::Work::open, at("b.json"), named("mine"), 0);
  const auto opened = result();
  ASSERT_TRUE(opened && opened->fabric);
  EXPECT_EQ(opened->fabric->name, "Twill");
}

TEST_F(FileServiceTest, OnlyWhatCanBeStoppedOffersIt) {
  EXPECT_FALSE(service_.canCancel()) << "nothing is done";
  service_.exportTo(at("a.png"), [] { return std::vector<std::string>{}; });
  EXPECT_FALSE(service_.canCancel());
  service_.cancel();
  const auto exported = result();
  ASSERT_TRUE(exported);
  EXPECT_FALSE(service_.canCancel());
  service_.save(at("a.json"), named("Tweed"), 1);
  EXPECT_TRUE(service_.canCancel() && !service_.isReading());
  service_.cancel();
  EXPECT_FALSE(service_.canCancel()) << "once is enough";
  EXPECT_TRUE(result());
}

/// Nobody knows how far it is before it says so; the next begins anew.
TEST_F(FileServiceTest, TellsHowMuchIsRendered) {
  std::promise<void> looked, begun;
  service_.renderTo(at("a.pdf"), [&](const Task& task) {
    task.report(0.25);
    begun.set_value();
    looked.get_future().wait();
    return true;
  });
  begun.get_future().wait();
  EXPECT_EQ(service_.fraction(), 0.25);
  looked.set_value();
  EXPECT_TRUE(result());
  EXPECT_FALSE(service_.fraction()) << "it is over";
  service_.renderTo(at("b.pdf"), [](const Task& task) {
    while (!task.stopped()) std::this_thread::yield();
    return false;
  });
  EXPECT_FALSE(service_.fraction()) << "that of the one before";
  service_.cancel();
  const auto cancelled = result();
  EXPECT_TRUE(cancelled && cancelled->cancelled);
}

TEST_F(FileServiceTest, ASaveThatIsCancelledSaysWhetherItCameTooLate) {
  writeFabric(*named("old"), at("a.json"));
  for (int i = 0; i < 20; ++i) {
    service_.save(at("a.json"), named("new"), 1);
    service_.cancel();
    EXPECT_TRUE(service_.busy()) << "until it is known what is in the file";
    const auto saved = result();
    ASSERT_TRUE(saved);
    EXPECT_EQ(readFabric(at("a.json")).name, saved->cancelled ? "old" : "new");
    writeFabric(*named("old"), at("a.json"));
  }
}

TEST_F(FileServiceTest, AReadThatHangsHoldsUpNeitherASaveNorTheEnd) {
  std::promise<void> letGo, begun;
  {
    FileService service([] {},
                        [gone = letGo.get_future().share(), &begun](const std::string&, const Fabric&) {
                          begun.set_value();
                          gone.wait();
                          return WifImport{};
                        });
    service.open(FileService::Work::open, at("a.json"), named("mine"), 0);
    begun.get_future().wait();
    service.cancel();
    service.save(at("b.json"), named("Tweed"), 1);
  }
  EXPECT_EQ(readFabric(at("b.json")).name, "Tweed");
  letGo.set_value();  // only now: the end has not waited for it
}

}  // namespace
}  // namespace loomlight
