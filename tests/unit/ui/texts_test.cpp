#include <fmt/core.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/base/error.h"
#include "core/fabric/model/field_tables.h"
#include "core/fabric/weave/yarn_order.h"
#include "ui/inspector/count_text.h"
#include "ui/widgets/number_text.h"
#include "ui/words/booth_words.h"
#include "ui/words/cloth_words.h"
#include "ui/words/dialog_words.h"
#include "ui/words/stripe_words.h"

namespace loomlight {
namespace {

TEST(YarnOrder, ReadsBackWhatItWrites) {
  const std::vector<int> sequences[] = {{0}, {0, 0, 0, 1, 1}, {2, 0, 2, 2}, {25, 26, 26, 51, 0}};
  for (const std::vector<int>& sequence : sequences)
    EXPECT_EQ(yarnOrderFromText(yarnOrderText(sequence), 64, 100), sequence) << yarnOrderText(sequence);
}

TEST(YarnOrder, ReadsWhatWeaversWrite) {
  EXPECT_EQ(yarnOrderFromText(" 2a b,3C ", 3, 100), (std::vector<int>{0, 0, 1, 2, 2, 2}));
  EXPECT_EQ(yarnOrderFromText("4A2B", 2, 100), (std::vector<int>{0, 0, 0, 0, 1, 1}));
}

TEST(YarnOrder, GroupsRepeat) {
  EXPECT_EQ(yarnOrderFromText("2(A 2B) C", 3, 100), (std::vector<int>{0, 1, 1, 0, 1, 1, 2}));
  EXPECT_EQ(yarnOrderFromText("2 ( 2(A B)C )", 3, 100), (std::vector<int>{0, 1, 0, 1, 2, 0, 1, 0, 1, 2}));
  for (const char* text : {"2(A", "A)", "()", "3()", "99(2A)", "9999999(9999999(9999999A))", "((((((((((A))))))))))"})
    EXPECT_THROW(yarnOrderFromText(text, 2, 100), InputError) << text;
}

TEST(YarnOrder, RefusesWhatIsNone) {
  for (const char* text : {"", "   ", "4", "0A", "4C", "4A ?", "99999999999A", "AAAAAAAAAAAAAAAAAAAAAAAA", "101A"})
    EXPECT_THROW(yarnOrderFromText(text, 2, 100), InputError) << text;
}

void expectCount(const char* text, double tex, std::optional<int> plies, CountSystem usual = CountSystem::tex) {
  const auto entry = countFromText(text, usual);
  ASSERT_TRUE(entry.has_value()) << text;
  const int singles = entry->ofSingles ? entry->plies.value_or(1) * entry->cords.value_or(1) : 1;
  EXPECT_NEAR(entry->tex * singles, tex, 1e-9) << text;
  EXPECT_EQ(entry->plies, plies) << text;
}

TEST(CountText, KnowsTheSystemsOfSpinners) {
  expectCount("19.7 tex", 19.7, {});
  expectCount("19,7 tex", 19.7, {});
  expectCount("19.7", 19.7, {});
  expectCount("30", 590.5 / 30, {}, CountSystem::cotton);
  for (const char* text : {"30 Ne", "Ne 30", "30s", "30 cc"}) expectCount(text, 590.5 / 30, {});
  for (const char* text : {"150den", "150D", "150 denier"}) expectCount(text, 150 / 9.0, {});
  expectCount("167 DTEX", 16.7, {});
  for (const char* text : {"40 NeL", "40 lea"}) expectCount(text, 1653.5 / 40, {});
  expectCount("20/22 den", 21 / 9.0, {});  // raw silk is reeled to a range
}

TEST(CountText, KnowsPlies) {
  expectCount("30/2 Ne", 2 * 590.5 / 30, 2);
  expectCount("Ne 30/2", 2 * 590.5 / 30, 2);
  expectCount("2/60 Nm", 1000.0 / 30, 2);
  expectCount("2/30s", 2 * 590.5 / 30, 2);
  expectCount("30/1", 590.5 / 30, 1, CountSystem::cotton);
  expectCount("20 tex x 2", 40, 2);
  expectCount("20x3 tex", 60, 3);
  expectCount("20/22 den x 2", 42 / 9.0, 2);
  expectCount("R 40 tex/2", 40, 2);
}

TEST(CountText, IndirectCountsAreOfSingles) {
  EXPECT_TRUE(countFromText("30 Ne", CountSystem::tex)->ofSingles);
  EXPECT_FALSE(countFromText("R 15 Ne", CountSystem::tex)->ofSingles);
  EXPECT_FALSE(countFromText("40 tex", CountSystem::cotton)->ofSingles);
}

TEST(CountText, KnowsFilaments) {
  for (const char* text : {"167 dtex f48", "167f48 dtex", "dtex 167 f 48"}) {
    expectCount(text, 16.7, 1);
    EXPECT_EQ(countFromText(text, CountSystem::tex)->filaments, 48) << text;
  }
  expectCount("150D/48F", 150 / 9.0, 1);
  expectCount("78 dtex f34 x 2", 15.6, 2);
  EXPECT_EQ(countFromText("78 dtex f34 x 2", CountSystem::tex)->filaments, 34);
  EXPECT_EQ(countFromText("78 dtex", CountSystem::tex)->filaments, std::nullopt);
}

TEST(CountText, KnowsCables) {
  for (const char* text : {"20/2/3 Ne", "Ne 20/2/3", "20 Ne x 2 x 3"}) {
    expectCount(text, 6 * 590.5 / 20, 2);
    EXPECT_EQ(countFromText(text, CountSystem::tex)->cords, 3) << text;
  }
  expectCount("R 180 tex/2/3", 180, 2, CountSystem::cotton);
  EXPECT_EQ(countFromText("R 180 tex/2/3", CountSystem::cotton)->cords, 3);
  EXPECT_EQ(countFromText("30/2 Ne", CountSystem::tex)->cords, 1);
}

TEST(CountText, RefusesWhatIsNone) {
  for (const char* text : {"",
                           "Ne",
                           "30/2",
                           "50/72 den",  // and so many filaments: no range of raw silk is as wide
                           "100/144 den",
                           "30/0 Ne",
                           "-5 tex",
                           "30/2 tex",
                           "nan tex",
                           "20 stone",
                           "30 Ne x",
                           "30/2/7 Ne",
                           "30/2/2/2 Ne",
                           "30/2/2 tex",
                           "20 tex x 9",
                           "2.5/60 Nm",
                           "Ne 30 Nm",
                           "x 2 tex",
                           "20 tex x 2 /2",
                           "1,000 tex",
                           "19,7,3 tex",
                           "150/48 den",
                           "167 dtex f",
                           "167 dtex f4.5",
                           "167 dtex f48 f48",
                           "R 167 dtex f48/2",
                           "167 dtex f9999"})
    EXPECT_FALSE(countFromText(text, CountSystem::tex).has_value()) << text;
}

TEST(FinenessText, KnowsWhatFibresAreSoldBy) {
  EXPECT_NEAR(finenessFromText("1,7 dtex", 1.52).value(), 1.7, 1e-12);
  EXPECT_NEAR(finenessFromText("1.5 den", 1.39).value(), 15 / 9.0, 1e-12);
  // A wool of 18.5 um has 1.31 g/cm3 * pi * (9.25 um)^2 = 3.52 g on ten kilometres.
  for (const char* text : {"18.5 mic", "18.5um", "18.5 \xC2\xB5m"})
    EXPECT_NEAR(finenessFromText(text, 1.31).value(), 3.52, 0.005) << text;
  for (const char* text : {"", "18.5", "18.5 mic x", "40 Ne", "-1 den"})
    EXPECT_FALSE(finenessFromText(text, 1.31).has_value()) << text;
}

TEST(NumberText, TakesPointsAndCommas) {
  const auto expectNumber = [](const char* text, double value, size_t length) {
    const auto leading = leadingNumber(text);
    ASSERT_TRUE(leading.has_value()) << text;
    EXPECT_DOUBLE_EQ(leading->value, value) << text;
    EXPECT_EQ(leading->length, length) << text;
  };
  expectNumber("19.7 tex", 19.7, 4);
  expectNumber("-19,75mm", -19.75, 6);
  expectNumber("0,125", 0.125, 5);
  expectNumber("1,5e3x", 1500, 5);
  expectNumber("12.500", 12.5, 6);
  for (const char* text : {"", "x", ",", "1,", "1,000", "1,2,3", "1.2,3", "1,000.5", "1e999"})
    EXPECT_FALSE(leadingNumber(text).has_value()) << text;
  EXPECT_TRUE(hasDoubtfulComma(" 1,125 mm"));
  for (const char* text : {"0,125", "1,12", "1,1250", "1.125", "mm 1,125", ""})
    EXPECT_FALSE(hasDoubtfulComma(text)) << text;
}

/// Of all fields, from the tables that they are made of and from the words.
std::vector<std::string> unitsOfFields() {
  std::vector<std::string> units = {"px",
                                    "/in",
                                    "EV",
                                    "dpi",
                                    "GB",
                                    "TM",
                                    "dtex",
                                    "/2/3 Ne",
                                    words::mill::dentsPerInch,
                                    words::booth::toleranceUnit,
                                    words::tile::perPixel,
                                    words::handover::paths,
                                    words::preferences::sample,
                                    words::preferences::samples,
                                    words::stripe::end,
                                    words::stripe::ends,
                                    words::stripe::pick,
                                    words::stripe::picks};
  const auto add = [&](const auto& field) {
    if (*field.info.unit) units.emplace_back(field.info.unit);
  };
  forEachField<Fibre>(add);
  forEachField<Yarn>(add);
  forEachField<Drape>(add);
  forEachField<Light>(add);
  forEachField<Camera>(add);
  forEachField<RenderSettings>(add);
  forEachField<MillData>(add);
  forEachField<Fabric>(add);
  for (const CountSystem system : {CountSystem::tex, CountSystem::dtex, CountSystem::denier, CountSystem::metric,
                                   CountSystem::cotton, CountSystem::worsted, CountSystem::linen})
    units.emplace_back(countUnit(system));
  return units;
}

TEST(NumberText, TakesEveryUnitOfAFieldWithABlankAndWithout) {
  for (const std::string& unit : unitsOfFields())
    for (const std::string& text : {"8 " + unit, "8" + unit, " +8  " + unit + " ", std::string("8")})
      EXPECT_EQ(numberIn(unit, text), 8) << text << " in " << unit;
}

/// What a field shows behind a 1 is typed with an 8 in its place, and the other way round.
TEST(NumberText, TakesUnitsInTheSingularAndThePlural) {
  const std::pair<const char*, const char*> pairs[] = {
      {"end", "ends"},         {"pick", "picks"},   {"turn/m", "turns/m"}, {"dent/10 cm", "dents/10 cm"},
      {"dent/in", "dents/in"}, {"event", "events"}, {"path", "paths"},     {"sample", "samples"}};
  std::set<std::string> known;
  for (const auto& [one, several] : pairs) {
    known.insert(several);
    for (const char* const unit : {one, several}) {
      EXPECT_EQ(numberIn(unit, fmt::format("1 {}", one)), 1) << unit;
      EXPECT_EQ(numberIn(unit, fmt::format("8 {}", several)), 8) << unit;
      EXPECT_EQ(numberIn(unit, fmt::format("8{}", several)), 8) << unit;
    }
  }
  EXPECT_EQ(numberIn("dents/10 cm", "80 dent / 10cm"), 80);
  for (const std::string& unit : unitsOfFields()) {
    const std::string word = unit.substr(0, unit.find_first_of(" /"));
    if (word.size() < 4 || word.back() != 's') continue;
    EXPECT_EQ(known.count(unit), 1u) << unit << " has a singular, which is not tried here";
  }
}

TEST(NumberText, TakesNoOtherUnit) {
  for (const char* text : {"8 picks", "8 ends/cm", "8 en", "8 s", "ends", "", "8 8 ends", "8 ends x"})
    EXPECT_FALSE(numberIn("ends", text).has_value()) << text;
  EXPECT_FALSE(numberIn("m", "8 ms").has_value()) << "signs have no plural";
  EXPECT_FALSE(numberIn("mm", "8 m").has_value());
  EXPECT_FALSE(numberIn("", "8 mm").has_value());
}

TEST(SampleText, CountsAsPeopleDo) {
  EXPECT_EQ(sampleText(0), "preview");
  EXPECT_EQ(sampleText(1), "1 sample");
  EXPECT_EQ(sampleText(2), "2 samples");
}

TEST(TwistText, KnowsTurnsPerMetrePerInchAndMultipliers) {
  EXPECT_NEAR(twistFromText("780 t/m", 20).value(), 780, 1e-12);
  EXPECT_NEAR(twistFromText("20tpi", 20).value(), 20 / 0.0254, 1e-9);
  EXPECT_NEAR(twistFromText("4 TM", 590.5 / 25).value(), 20 / 0.0254, 1.5);
  for (const char* text : {"", "20", "20 turns", "-3 tpi", "4 TM x"})
    EXPECT_FALSE(twistFromText(text, 20).has_value()) << text;
}

}  // namespace
}  // namespace loomlight
