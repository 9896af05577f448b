#include "app/export/picture_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/export/merge_parts.h"
#include "app/export/picture.h"
#include "core/base/error.h"
#include "tests/support/scratch_folder.h"

namespace loomlight {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class PictureParts : public testing::Test {
 protected:
  static constexpr int kSide = 16;

  /// Writes a part that is to hold one sample of every pixel, of a kind of processor; returns the file.
  std::string part(const std::string& name, int sample, const std::string& processor) {
    PartInfo info;
    info.fabric.render.width = info.fabric.render.height = kSide;
    info.origin.program = "a program";
    info.origin.processor = processor;
    info.boxes = {SampleBox::of({0, 0, kSide, kSide}, sample, 1)};
    const std::string file = folder_.file(name);
    writePart(file, Film(kSide, kSide), info);
    return file;
  }
  std::string part(int sample, const std::string& processor) {
    return part(std::to_string(sample) + ".exr", sample, processor);
  }
  static std::string refusal(const std::vector<std::string>& files) {
    return test::messageOf<InputError>([&] { planMerge(files); });
  }

  test::ScratchFolder folder_;
};

TEST_F(PictureParts, OfTwoKindsOfProcessorsAreRefused) {
  const std::string a = part(0, "1234"), b = part(1, "5678");
  EXPECT_EQ(refusal({a, b}), b + ": expected samples of the same kind of processor as " + a +
                                 ", but here they are of 5678 and there of 1234");
}

TEST_F(PictureParts, WithoutAKindGoWithThoseOfAny) {
  const std::string any = part(0, ""), a = part(1, "1234"), another = part(2, "1234");
  EXPECT_EQ(planMerge(std::vector{any, a, another}).info.origin.processor, "1234");
  EXPECT_EQ(planMerge(std::vector{a, any, another}).info.origin.processor, "1234");
  EXPECT_EQ(planMerge(std::vector{any, part(3, "")}).info.origin.processor, "");
}

TEST_F(PictureParts, AreRefusedByTheNamesOfThoseThatShowAKind) {
  const std::string any = part(0, ""), a = part(1, "1234"), b = part(2, "5678");
  EXPECT_THAT(refusal({any, a, b}), AllOf(HasSubstr(a), HasSubstr(b), Not(HasSubstr(any))));
  EXPECT_THAT(refusal({a, any, b}), AllOf(HasSubstr(a), HasSubstr(b), Not(HasSubstr(any))));
}

TEST_F(PictureParts, OfSeveralKindsAreRefusedEvenByThemselves) {
  EXPECT_EQ(withKind("", "1234"), "1234");
  EXPECT_EQ(withKind("1234", "1234"), "1234");
  EXPECT_EQ(withKind("1234", ""), "1234");
  const std::string several = part(0, withKind("1234", "5678"));
  const std::string others[] = {part(1, ""), part(2, "1234"), part(3, withKind(withKind("1234", "5678"), "1234"))};
  EXPECT_THAT(refusal({several}), HasSubstr(several + ": expected samples of one kind of processor"));
  for (const std::string& other : others) EXPECT_THAT(refusal({other, several}), HasSubstr("one kind of processor"));
}

TEST_F(PictureParts, SayTheirKindAgainWhenTheyAreRead) {
  EXPECT_EQ(readPartInfo(part(0, "1234")).origin.processor, "1234");
  EXPECT_EQ(readPartInfo(part(0, "")).origin.processor, "");
  EXPECT_THAT(test::bytesOf(part(0, "")), Not(HasSubstr("\"processor\"")));
}

TEST_F(PictureParts, WithAnotherThingForATextAreDamaged) {
  const std::string file = part(0, "1234");
  const std::string bytes = test::bytesOf(file), said = "\"processor\":\"1234\"";
  const size_t at = bytes.find(said);
  ASSERT_NE(at, std::string::npos);
  for (const char* other : {"\"processor\":123456", "\"processor\":[1,23]", "\"processor\":null  ",
                            "\"processor\":\"1\\n2\"", "\"processor\":\"12345", "\"processor\":{\"\":0}"}) {
    std::string changed = bytes;
    test::putBytes(file, changed.replace(at, said.size(), other));
    EXPECT_EQ(test::messageOf<InputError>([&] { readPartInfo(file); }),
              file + ": expected the metadata 'loomlight.part' as Loomlight writes it, got something else")
        << other;
  }
}

TEST(FabricInAPicture, ThatIsMistakenIsToldByItsPlaceInTheFile) {
  const std::map<std::string, std::string> texts{{"loomlight.fabric", R"({"loomlight_version": 1, "press": "flat"})"}};
  EXPECT_THAT(test::messageOf<InputError>([&] { fabricInTexts(texts, "a.exr"); }),
              testing::StartsWith("a.exr: loomlight.fabric: press: expected a number"));
}

}  // namespace
}  // namespace loomlight
