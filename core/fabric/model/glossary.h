#pragma once

/// The words of the trade, as weavers, spinners and dyers use them (WIF 1.1 for drafts, ISO 2 and ISO 8159 for twist
/// and plies, ISO 3572 and ISO 8388 for weaves and fabrics). Labels come from here, so that a thing is called one name
/// everywhere; another language needs this file, and those of ui/words. The help explains the physics where the trade
/// has no word for it.
namespace loomlight {

struct Word {
  const char* label;
  const char* help = "";
};

namespace words {

// Fibre
inline constexpr Word fibreName{"Fibre", "What this fibre is called."};
inline constexpr Word fibreRadius{"Radius", "Half the thickness of one fibre, as if it were round."};
inline constexpr Word fibreDensity{"Density", "Mass of the fibre's substance."};
inline constexpr Word fibreFineness{"Fineness",
                                    "Mass of ten kilometres of one fibre. May be typed as 1.5 den too, or by its "
                                    "thickness, as wool is sold: 18.5 mic."};
inline constexpr Word refractiveIndex{
    "Refractive index", "How strongly the fibre bends and mirrors light; textile fibres lie between 1.46 and 1.6."};
inline constexpr Word depthOfShade{
    "Depth of shade",
    "How deep the dyeing is: light that the dye absorbs on its way inside the fibre (absorption, 1/mm), for red, green "
    "and blue."};
inline constexpr Word depthRed{"Depth, red", depthOfShade.help};
inline constexpr Word depthGreen{"Depth, green", depthOfShade.help};
inline constexpr Word depthBlue{"Depth, blue", depthOfShade.help};
inline constexpr Word dullnessAlong{
    "Dullness along",
    "How far highlights spread along the fibre: low is bright and lustrous, high is dull (longitudinal roughness, "
    "beta_m)."};
inline constexpr Word dullnessAround{
    "Dullness around",
    "How far light spreads around the fibre: low glitters, high is even; what an irregular section adds comes on top "
    "(azimuthal roughness, beta_n)."};
inline constexpr Word scaleTilt{"Scale tilt", "Tilt of the surface scales; wool has 2 to 3 degrees."};
inline constexpr Word fibreSection{"Section", "Shape of the fibre, cut across."};
inline constexpr Word looseStock{"Loose stock",
                                 "The colour of a thick mass of this fibre, as dyers match loose stock; sRGB with the "
                                 "white of daylight (D65). Cloth "
                                 "that light goes through is darker over black."};
inline constexpr Word dyedAs{"Dyed",
                             "What takes the dye: this fibre in every yarn that is spun of it, this yarn alone, or the "
                             "piece, all of whose fibres are dyed alike after it was woven."};
inline constexpr Word takeNearest{"Take nearest", "The colour that the cloth has reached is the wanted one then."};
inline constexpr Word dyeAgain{"Dye again", "Finds the dye for the wanted colour in the cloth as it is now."};
inline constexpr Word difference{"Difference",
                                 "Between wanted and reached (CIEDE2000): 1 is about the least that an eye sees "
                                 "between two patches side by side."};
inline constexpr Word colourCode{"Code",
                                 "The wanted colour as six hexadecimal digits, as CIELAB in daylight (D65, 2 degree "
                                 "observer), or by its name in the "
                                 "colour book. Enter dyes."};
inline constexpr Word colourBook{
    "Colour book",
    "Colours of a file of your own, dropped on the window: a palette (.ase, .aco, .gpl, .csv) or measured colours "
    "(.cxf, .csv). Those that were used stay here to be chosen."};
inline constexpr Word findColour{"Find", "A part of a name finds the colours that have it; a click on one dyes."};
inline constexpr Word absorptionKnown{
    "Known by",
    "What says how the fibre absorbs: a depth for each of red, green and blue; or bands of a spectrum, or a recipe of "
    "dyes, to which the depths are added. A picked colour takes the place of all."};
inline constexpr Word inThisCloth{
    "In this cloth",
    "On the left the colour that the cloth should have where this lies on top, on the right the one it reaches, seen "
    "from straight above in white light from the sky over black. A click picks. The dye is found by walking light "
    "through this very construction."};

// Yarn
inline constexpr Word yarnName{"Yarn", "What this yarn is called; where it has no name, its colour and its count."};
inline constexpr Word yarnFibre{"Fibre", "The fibre it is spun of: a number in the list, from 0."};
inline constexpr Word blendedWith{"Blended with",
                                  "A second fibre that is spun together with the first: a number in the list, from 0."};
inline constexpr Word blendShare{"Share", "How much of the yarn's mass is the second fibre."};
inline constexpr Word count{"Count", "How thick the yarn is: grams of one kilometre."};
inline constexpr Word fibresInSingle{"Fibres/single",
                                     "Number of fibres in one single; where it is given, the count follows from it."};
inline constexpr Word plies{"Plies", "How many singles are twisted together; 1 is a single yarn."};
inline constexpr Word twist{"Twist", "Turns of the fibres about the axis of the yarn."};
inline constexpr Word singlesTwist{"Singles twist", "Turns of the fibres about the axis of their single."};
inline constexpr Word singlesWay{"Singles way", "Fibres on the near side slant like this letter."};
inline constexpr Word twistWay{"Twist way", "Fibres on the near side slant like this letter."};
inline constexpr Word plyTwist{"Ply twist", "Turns of the singles about each other (folding twist)."};
inline constexpr Word plyWay{"Ply way", "Singles on the near side slant like this letter."};
inline constexpr Word cabledFrom{"Cabled from",
                                 "How many plied yarns are twisted together once more; 1 is a plied yarn, no cable."};
inline constexpr Word cableTwist{"Cable twist", "Turns of the plied yarns of a cable about each other."};
inline constexpr Word cableWay{"Cable way", "Plied yarns on the near side slant like this letter."};
inline constexpr Word compactness{
    "Compactness",
    "Share of a single's section that is fibre, the rest is air (packing density): soft yarns 0.3, ring-spun 0.55, "
    "filament 0.7."};
inline constexpr Word diameter{"Diameter",
                               "Of the yarn as if it were round and lay free. It follows from count and compactness; "
                               "set it where it was measured, "
                               "and the compactness follows."};
inline constexpr Word flattening{
    "Flattening", "How readily the yarn's section flattens in the cloth: 1.2 as most do, more for a wider one."};
inline constexpr Word hairiness{"Hairs", "Loose fibre ends and loops on one millimetre of yarn."};
inline constexpr Word hairLength{"Hair length", "How far the longest loose fibres reach; most are a quarter as long."};
inline constexpr Word hairinessH{
    "Hairiness H",
    "Millimetres of loose fibre on one millimetre of yarn (Uster H): compact yarns 3 to 4, "
    "ring-spun ones 4 to 7. Set it where it was measured, and the number of hairs "
    "follows."};
inline constexpr Word meanHairLength{"Mean hair", "From root to tip, of all ends and loops."};
inline constexpr Word wrappers{"Wrapper fibres",
                               "Fibres wound tightly around the yarn, on one centimetre: rotor (open-end) yarns have 2 "
                               "to 6, ring-spun ones none."};
inline constexpr Word shadeVariation{"Shade variation",
                                     "By how much the depth of the dye differs from thread to thread (coefficient of "
                                     "variation). 3 is hardly seen; 15 to "
                                     "25 streaks denim, whose indigo is dyed in ropes; piece-dyed cloth has 0."};
inline constexpr Word fibreInterchange{
    "Interchange",
    "How far fibres wander between the core and the surface of the yarn, which holds it together (fibre migration)."};
inline constexpr Word parallelism{"Fibre straying",
                                  "How far fibres stray from lying side by side: filaments 1, compact and worsted "
                                  "yarns 4 to 5, ring-spun cotton 6 to "
                                  "9, rotor and woollen yarns 11 to 15."};
inline constexpr Word evenness{
    "Unevenness",
    "How unevenly the yarn is spun: by how much the mass of 8 mm of it varies (Uster CVm). "
    "Filament 0 to 2, combed cotton and worsted 11 to 15, carded, rotor and woollen yarns 14 "
    "to 18, flax 20 and more."};
inline constexpr Word slubs{"Slubs", "Thick places that are spun in on purpose, on a metre of yarn."};
inline constexpr Word slubLength{"Slub length",
                                 "Of a slub, on average; single ones are up to a third shorter or longer."};
inline constexpr Word slubRatio{"Slub thickness", "How heavy a slub is, as a multiple of the yarn between slubs."};
inline constexpr Word fibreLayout{
    "Fibre layout", "How fibres lie in the section: at random, overlaps allowed, or side by side without overlap."};

// Draft and loom
inline constexpr Word liftplan{"Liftplan"};
inline constexpr Word shafts{"Shafts", "Frames that lift the ends threaded on them. Fewer leave ends on none."};
inline constexpr Word treadles{"Treadles", "Pedals that move the shafts tied to them."};
inline constexpr Word loomShafts{"Loom shafts", "What your loom has: a weave that takes more of them is a jacquard."};
inline constexpr Word loomTreadles{"Loom treadles",
                                   "What your loom has: a weave that takes more of them gets a liftplan."};
inline constexpr Word risingShed{"Rising shed", "Tied shafts are raised; in a sinking shed they are pulled down."};
inline constexpr Word wifDraft{"WIF draft", "A draft as weaving programs exchange it (Weaving Information File)."};
inline constexpr Word rotate{"Rotate 90\xC2\xB0 right"};
inline constexpr Word mirrorWarp{"Mirror horizontally"};
inline constexpr Word mirrorWeft{"Mirror vertically"};
inline constexpr Word checkFloats{"Check floats", "Marks threads that float too far, and lists them."};
inline constexpr Word backOfCloth{"Back of the cloth", "The cloth and its draft from behind, turned over like a page."};

// Colour orders
inline constexpr Word warpOrder{"Warp order"};
inline constexpr Word weftOrder{"Weft order"};
inline constexpr Word yarnOrder{
    "Order",
    "Which yarns the threads are of, repeating: 4A 2B is four of the first yarn, then two of the second; 3(4A "
    "2B) is that three times. Enter takes it."};
inline constexpr Word mirrorOrder{"Mirror", "There and back again, turning on the outermost threads."};
inline constexpr Word reverseOrder{"Reverse", "The other way round."};
inline constexpr Word repeatOrder{"Repeat", "All stripes once more, to be varied."};
inline constexpr Word doubleThreads{"Double", "Every thread twice: stripes become twice as wide."};
inline constexpr Word copyWeft{"Copy weft", "Takes the other order: the same both ways, as in a tartan."};
inline constexpr Word copyWarp{"Copy warp", copyWeft.help};
inline constexpr Word stripes{"Stripes", "The stripes of one repeat, from the first thread on."};
inline constexpr Word stripeBar{"", "Drag an edge between two stripes; the last edge makes the last one wider."};
inline constexpr Word stripeColour{"Colour", "Which yarn this stripe is of."};
inline constexpr Word addStripe{"+", "Another stripe after this one."};
inline constexpr Word removeStripe{"\xE2\x88\x92", "Takes this stripe away."};
inline constexpr Word balance{"Balance", "Makes the last stripe longer, so that the order repeats with the weave."};
inline constexpr Word randomStripes{
    "Random stripes",
    "Another order each time, with as much of each yarn as the present one; undo brings back the last."};

// Cloth
inline constexpr Word clothName{"Name", "What this cloth is called."};
inline constexpr Word description{"Description", "Anything worth saying about it."};
inline constexpr Word ends{"Ends", "Warp yarns, side by side on one centimetre."};
inline constexpr Word picks{"Picks", "Weft yarns, side by side on one centimetre."};
inline constexpr Word settCv{
    "Unevenness of sett",
    "How much neighbouring threads differ in their distance, as a coefficient of variation: they wander by some "
    "hundredths of a millimetre, over centimetres. Of finished cloth a few percent; 0 is as even as point paper."};
inline constexpr Word warpSpacing{
    "Ends apart",
    "How far each end lies from the next one, over the other distances: a few numbers that repeat, as 1 2 for ends in "
    "pairs. Nothing: all alike. The sett stays. Where yarns have no room for it, all distances differ less."};
inline constexpr Word weftSpacing{"Picks apart",
                                  "How far each pick lies from the next one, over the other distances: a few numbers "
                                  "that repeat. Nothing: all alike."};
inline constexpr Word crowding{
    "Crowding",
    "How far threads that float side by side draw together, away from the neighbour that a crossing thread parts them "
    "from. It closes up the pairs of an oxford or a hopsack, makes twill lines plainer, and does nothing to plain "
    "weave. With it ribs crimp more nearly as relaxed yarns do. 0 evenly apart; 1 as far as relaxed yarns go, where "
    "there is room. A large pattern takes much longer to prepare with it."};
inline constexpr Word press{"Pressing",
                            "How the cloth was finished: 0 washed and relaxed, 0.5 pressed, 1 calendered, thin and "
                            "flat, no hair standing."};
inline constexpr Word singed{"Singed",
                             "Loose fibres are burnt off, as poplin and suiting are: few are left, and short."};
inline constexpr Word brushed{"Brushed",
                              "Loose fibres are drawn out and raised on the face, all one way along the warp, as on "
                              "flannel. It takes yarns that have hairs."};
inline constexpr Word milling{
    "Milling",
    "How far cloth of wool is milled (fulled): its fibres work into one another, yarns swell until they close the gaps "
    "between them, and their surface mats until the weave hardly shows. 0 clear, as worsted suits are; 0.6 to 0.8 "
    "flannel, tweed and blankets; 1 loden. It acts on all yarns of staple fibre. The setts are those after it."};
inline constexpr Word mercerised{
    "Mercerised",
    "Cotton is swollen in lye: its fibres become round and smooth, and lustrous. It acts on "
    "all fibres whose section is a kidney, so on acrylic too, which lye leaves as it is: give "
    "acrylic another section where both are woven."};
inline constexpr Word crimpBalance{
    "Crimp balance", "Above 1 the warp takes more of the crimp, below 1 the weft; at 1 stiffness and sett decide."};

// Reed, selvedges and the states of the cloth
inline constexpr Word reed{
    "Reed",
    "Dents on 10 cm of the reed; 0 where it is not said. With the ends per dent it says how far "
    "apart the warp is set in the loom. The picture does not change by it: it shows the finished "
    "cloth at its own sett."};
inline constexpr Word endsPerDent{
    "Ends per dent",
    "Ends in one dent after the other, repeating: 2, or 3 3 0, where 0 is an empty dent. The picture groups no "
    "ends: reed marks and the gaps of empty dents are not modelled."};
inline constexpr Word reedState{
    "In the reed",
    "Ends as reed and denting set them. A figure with ~ is reckoned back from the crimp: the weft is laid in straight, "
    "and the warp is stretched straight, if the yarn itself does not shrink in finishing."};
inline constexpr Word loomState{
    "Loom state",
    "Grey cloth, off the loom and before finishing. It lies between the sett in the reed and the finished one and "
    "cannot be reckoned: how it was stretched and shrunk in finishing is not known. Enter what the mill has counted."};
inline constexpr Word finishedState{"Finished", "The cloth of the picture, at the sett above."};
inline constexpr Word washedState{
    "Washed",
    "After washing and drying. How cloth shrinks is not modelled: enter what the mill or its laboratory has counted "
    "(ISO 5077). Pressing at 0 gives yarns the shape of washed cloth, at the sett above."};
inline constexpr Word loomEnds{"Loom-state ends", "Ends on 1 cm of grey cloth, as the mill counts them; 0: not said."};
inline constexpr Word loomPicks{"Loom-state picks",
                                "Picks on 1 cm of grey cloth, as the mill counts them; 0: not said."};
inline constexpr Word washedEnds{"Washed ends", "Ends on 1 cm after washing and drying, as counted; 0: not said."};
inline constexpr Word washedPicks{"Washed picks", "Picks on 1 cm after washing and drying, as counted; 0: not said."};
inline constexpr Word selvedgeEnds{"Selvedge ends",
                                   "Ends of the selvedge on each side, beside those of the cloth. The picture is of "
                                   "cloth without selvedges."};
inline constexpr Word selvedgeYarn{"Selvedge yarn",
                                   "What the selvedges are warped with: a number in the list of yarns, from 0."};
inline constexpr Word selvedgeDenting{"Selvedge per dent", "Ends of the selvedge in one dent."};
inline constexpr Word selvedgeWeave{"Selvedge weave",
                                    "What binds the selvedges, as the mill calls it: plain, 2/2 rib, tucked in."};

// What follows for the cloth
inline constexpr Word mass{"Mass", "What one square metre weighs, from counts, sett and crimp."};
inline constexpr Word thickness{
    "Thickness",
    "From the lowest to the highest place of its yarns, taken as even; nothing presses on them, and "
    "hair and nap are left out."};
inline constexpr Word weaveRepeat{"Weave repeat", "Threads and size of one repeat of the weave."};
inline constexpr Word weaveSize{"Weave size"};
inline constexpr Word patternSize{"Pattern size"};
inline constexpr Word patternRepeat{"Pattern repeat",
                                    "Threads and size until the weave and the orders of colours repeat together."};
inline constexpr Word warpCover{"Warp cover factor",
                                "Peirce's factor: ends per inch over the square root of the cotton count. At 28 round "
                                "yarns touch; most cloths lie near 12."};
inline constexpr Word weftCover{"Weft cover factor",
                                "Peirce's factor: picks per inch over the square root of the cotton count. At 28 round "
                                "yarns touch; most cloths lie near 12."};
inline constexpr Word clothCover{
    "Cloth cover factor",
    "Both together, less what lies over each other: K1 + K2 - K1 K2 / 28. The cover of the status bar is another "
    "figure: the share of the area that yarns hide, seen from straight above, wider than round as they are pressed."};
inline constexpr Word longestWarpFloat{
    "Longest warp float", "The most picks that an end passes over or under without interlacing: long floats snag."};
inline constexpr Word longestWeftFloat{
    "Longest weft float", "The most ends that a pick passes over or under without interlacing: long floats snag."};

}  // namespace words
}  // namespace loomlight
