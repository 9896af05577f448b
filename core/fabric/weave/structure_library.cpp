#include "core/fabric/weave/structure_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace loomlight {
namespace {

using Values = std::vector<int>;

constexpr const char* kSlants[] = {"Z", "S"};
constexpr const char* kFaces[] = {"Warp", "Weft"};

StructureParameter overParameter(int start) {
  return {"Over", "Picks that an end passes over.", 1, 32, start};
}
StructureParameter underParameter(int start) {
  return {"Under", "Picks that it passes under.", 1, 32, start};
}
StructureParameter slantParameter() {
  return {"Line", "Z climbs to the right, S to the left, with the first pick at the bottom.", 0, 1, 0, kSlants};
}

Slant slantOf(int value) {
  return value == 0 ? Slant::z : Slant::s;
}

MadeStructure named(std::string name, Weave weave) {
  MadeStructure made;
  made.name = std::move(name);
  made.weave = std::move(weave);
  return made;
}

MadeStructure impossible(std::string name, std::string problem) {
  MadeStructure made = named(std::move(name), plainWeave());
  made.problem = std::move(problem);
  return made;
}

MadeStructure makeTwill(const Values& v) {
  return named(fmt::format("Twill {}/{} {}", v[0], v[1], kSlants[v[2]]), twill(v[0], v[1], slantOf(v[2])));
}

MadeStructure makeFancyTwill(const Values& v) {
  const Values runs(v.begin(), v.begin() + 4);
  return named(fmt::format("Twill {}/{}/{}/{} {}, step {}", v[0], v[1], v[2], v[3], kSlants[v[5]], v[4]),
               twill(runs, v[4], slantOf(v[5])));
}

/// Says which moves there are.
std::string moveProblem(int ends) {
  const Values steps = satinSteps(ends);
  if (steps.empty()) return fmt::format("There is no satin of {} ends.", ends);
  return fmt::format("A satin of {} ends takes the move {}.", ends, fmt::join(steps, ", "));
}

bool isMove(int ends, int step) {
  const Values steps = satinSteps(ends);
  return std::find(steps.begin(), steps.end(), step) != steps.end();
}

MadeStructure makeSatin(const Values& v) {
  const Face face = v[2] == 0 ? Face::warp : Face::weft;
  std::string name = fmt::format("{} {}, move {}", v[2] == 0 ? "Satin" : "Sateen", v[0], v[1]);
  if (!isMove(v[0], v[1])) return impossible(std::move(name), moveProblem(v[0]));
  return named(std::move(name), satin(v[0], v[1], face));
}

MadeStructure makeShadedSatin(const Values& v) {
  std::string name = fmt::format("Shaded satin {}, move {}, {} raised", v[0], v[1], v[2]);
  if (!isMove(v[0], v[1])) return impossible(std::move(name), moveProblem(v[0]));
  if (v[2] >= v[0])
    return impossible(std::move(name), fmt::format("At most {} of {} ends can be raised.", v[0] - 1, v[0]));
  return named(std::move(name), shadedSatin(v[0], v[1], v[2]));
}

MadeStructure makePoint(const Values& v) {
  std::string name = fmt::format("Point twill {}/{}", v[0], v[1]);
  if (v[0] + v[1] < 3) return impossible(std::move(name), "A point takes three shafts: over and under of 3 together.");
  return named(std::move(name), pointTwill(v[0], v[1]));
}

MadeStructure makeDiamond(const Values& v) {
  std::string name = fmt::format("Diamond twill {}/{}", v[0], v[1]);
  if (v[0] + v[1] < 3)
    return impossible(std::move(name), "A diamond takes three shafts: over and under of 3 together.");
  return named(std::move(name), diamondTwill(v[0], v[1]));
}

/// `count` dark yarns, as many light ones.
Values striped(int count) {
  Values colours(static_cast<size_t>(2 * count), 0);
  std::fill(colours.begin() + count, colours.end(), 1);
  return colours;
}

MadeStructure coloured(std::string name, Weave weave, Values warp, Values weft) {
  MadeStructure made = named(std::move(name), std::move(weave));
  made.warpColours = std::move(warp);
  made.weftColours = std::move(weft);
  return made;
}

MadeStructure makeCheck(const Values& v) {
  const int count = v[0];
  const char* const name = count == 2 ? "Puppytooth" : count == 4 ? "Houndstooth" : "Shepherd's check";
  return coloured(fmt::format("{}, {} and {} on twill 2/2", name, count, count), twill(2, 2), striped(count),
                  striped(count));
}

MadeStructure makeLogCabin(const Values& v) {
  // Dark and light in turn; where a block begins, the turn is lost, and stripes change their direction.
  Values colours;
  for (int block = 0; block < 2; ++block)
    for (int i = 0; i < v[0]; ++i) colours.push_back((i + block) % 2);
  return coloured(fmt::format("Log cabin, blocks of {}", v[0]), plainWeave(), colours, colours);
}

MadeStructure makeHairline(const Values& v) {
  const Values along{0, 1}, across{1, 0};
  return coloured(v[0] == 0 ? "Hairline, lengthwise" : "Hairline, crosswise", plainWeave(), along,
                  v[0] == 0 ? across : along);
}

constexpr const char* kDirections[] = {"Lengthwise", "Crosswise"};

std::vector<StructureKind> makeLibrary() {
  return {
      {"Plain",
       "Every thread over one, under one: the tightest weave there is.",
       {},
       [](const Values&) { return named("Plain weave 1/1", plainWeave()); }},
      {"Warp rib",
       "Several picks in one shed: ribs across the cloth.",
       {{"Picks", "Picks laid into one shed.", 2, 16, 2}},
       [](const Values& v) { return named(fmt::format("Warp rib {}/{}", v[0], v[0]), basket(1, v[0])); }},
      {"Weft rib",
       "Several ends as one: ribs along the cloth.",
       {{"Ends", "Ends that go as one.", 2, 16, 2}},
       [](const Values& v) { return named(fmt::format("Weft rib {}/{}", v[0], v[0]), basket(v[0], 1)); }},
      {"Basket",
       "Plain weave of groups of threads; also hopsack, panama; oxford has two ends and one pick.",
       {{"Ends", "Ends that go as one.", 1, 16, 2}, {"Picks", "Picks laid into one shed.", 1, 16, 2}},
       [](const Values& v) { return named(fmt::format("Basket {}/{}", v[0], v[1]), basket(v[0], v[1])); }},
      {"Twill",
       "A line that climbs by one: 2/2 serge, 3/1 denim, 2/1 drill.",
       {overParameter(2), underParameter(2), slantParameter()},
       makeTwill},
      {"Fancy twill",
       "A line of several runs; a larger step makes it steep.",
       {overParameter(3),
        underParameter(1),
        {"Over again", "The second run over.", 1, 32, 1},
        {"Under again", "The second run under.", 1, 32, 2},
        {"Step", "Picks from end to end.", 1, 16, 1},
        slantParameter()},
       makeFancyTwill},
      {"Broken twill",
       "Four ends in the order 1 2 4 3, so that no line shows; also crowfoot, satin 4.",
       {{"Over", "Picks that an end passes over, of four.", 1, 3, 3}},
       [](const Values& v) { return named(fmt::format("Broken twill {}/{}", v[0], 4 - v[0]), brokenTwill(v[0])); }},
      {"Herringbone",
       "A twill that turns round, with a clean cut at the turn.",
       {{"Over and under", "Of the twill.", 1, 16, 2}, {"Width", "Ends until it turns.", 1, 128, 8}},
       [](const Values& v) {
         return named(fmt::format("Herringbone {}/{}, {} ends", v[0], v[0], v[1]), herringbone(v[0], v[1]));
       }},
      {"Point twill",
       "A twill that turns round in points; also goose-eye, wave.",
       {overParameter(2), underParameter(2)},
       makePoint},
      {"Diamond",
       "Points in both directions; with 1/3 and 3/1 bird's eye and rosepath.",
       {overParameter(2), underParameter(2)},
       makeDiamond},
      {"Satin",
       "One binding point an end, never side by side: smooth, all warp or all weft.",
       {{"Ends", "Ends until the satin repeats, as many as it has picks.", 5, 32, 8},
        {"Move", "Ends from pick to pick.", 2, 30, 3},
        {"Face", "The threads that are seen.", 0, 1, 0, kFaces}},
       makeSatin},
      {"Shaded satin",
       "A satin with more points: the steps between weft and warp in a damask.",
       {{"Ends", "Ends until the satin repeats, as many as it has picks.", 5, 32, 8},
        {"Move", "Ends from pick to pick.", 2, 30, 3},
        {"Raised", "Crossings a pick with the warp on top.", 1, 31, 4}},
       makeShadedSatin},
      {"Waffle",
       "Floats that grow towards ridges and shrink again; also honeycomb.",
       {{"Shafts", "More make larger cells. How they deepen as the cloth shrinks is not modelled.", 3, 16, 5}},
       [](const Values& v) { return named(fmt::format("Waffle on {} shafts", v[0]), waffle(v[0])); }},
      {"Crepe",
       "Plain weave roughened by the points of a sateen.",
       {},
       [](const Values&) { return named("Crepe, plain and sateen 8", crepe()); }},
      {"Overshot",
       "Pattern picks that float in blocks over a plain ground, on four shafts.",
       {{"Block", "Pairs of ends in a block.", 1, 16, 3}},
       [](const Values& v) { return named(fmt::format("Overshot, blocks of {}", 2 * v[0]), overshot(2 * v[0])); }},
      {"Double cloth",
       "Two cloths above each other, thread by thread in turn.",
       {overParameter(1), underParameter(1)},
       [](const Values& v) { return named(fmt::format("Double cloth {}/{}", v[0], v[1]), doubleCloth(v[0], v[1])); }},
      {"Houndstooth",
       "Equal stripes both ways on a 2/2 twill, yarns A and B: 2 puppytooth, 4 houndstooth, 6 and more "
       "shepherd's check.",
       {{"Threads", "Of one colour.", 2, 32, 4}},
       makeCheck},
      {"Log cabin",
       "Dark and light in turn on plain weave, yarns A and B; stripes change direction from block to block.",
       {{"Block", "Threads of a block.", 3, 128, 16}},
       makeLogCabin},
      {"Hairline",
       "One dark, one light on plain weave, yarns A and B: the finest stripe.",
       {{"Stripes", "Along the warp or across it.", 0, 1, 0, kDirections}},
       makeHairline},
  };
}

}  // namespace

std::vector<int> StructureKind::startValues() const {
  std::vector<int> values;
  for (const StructureParameter& parameter : parameters) values.push_back(parameter.start);
  return values;
}

const std::vector<StructureKind>& structureLibrary() {
  static const std::vector<StructureKind> library = makeLibrary();
  return library;
}

const char* unwovenStructures() {
  return "Not here: leno and gauze, whose ends change places, pile and velvet, knits and braids. One layer of "
         "crossings "
         "cannot say what they are.";
}

}  // namespace loomlight
