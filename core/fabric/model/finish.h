#pragma once

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// How the loose fibres of a yarn lie on the finished cloth.
struct HairLie {
  double lyingShare = 0.8;  ///< of the ends that are no loops: the rest stand free
  bool isRaised = false;    ///< brushed: all ends are drawn up on the face, one way
  double heading = 0;       ///< raised: where to, from along the yarn towards its side u, radians
  bool operator==(const HairLie&) const = default;
};

/// The yarn as the finish leaves it. Singeing burns most of its hair off, short; brushing draws more and longer ends
/// out of it. Milling, of a felted yarn, draws out more and longer hair, opens the packing and adds to the fibres'
/// disorder. No other field of it changes.
Yarn withFinish(Yarn yarn, const Fabric& fabric);
/// How far milling has felted the yarn, 0..1: Fabric::milling of one of staple fibre (isSpun()), whatever the fibre; 0
/// of filaments.
double feltingOf(const Yarn& yarn, const Fabric& fabric);
/// Of the yarns of a system. Calendering, the upper half of Fabric::press, lays the last of what stands free, and
/// milling lays up to three quarters of it. Cloth is brushed along the warp, towards the higher picks.
HairLie hairLieOf(const Fabric& fabric, System system);
/// The fibre as the finish leaves it. Mercerising swells cotton, whose section is a kidney, until it is round and
/// smooth; it does nothing to a fibre of another section. Acrylic has that section too, and is swollen with it, which
/// lye would not do. Neither fineness nor dye change.
Fibre withFinishedSurface(Fibre fibre, const Fabric& fabric);

// Used both where loose fibres are laid (core/geometry/yarn/flyaways.cpp) and for their mean length below:
inline constexpr double kHairLoopShare = 0.4;    ///< of them, so many rise and come back
inline constexpr double kHairLoopReach = 0.4;    ///< how far a loop reaches, over the reach of an end
inline constexpr double kLyingHairLength = 2.5;  ///< of an end that lies, over one that stands
/// How long a loose fibre is, from its root to its tip, on average: loops, ends that stand, and ends that lie.
/// `hairLength_mm` is how far they reach at most, the diameter that of the round yarn. Hairs of more than a few pitches
/// of the cloth are laid shorter.
double meanHairLength_mm(double hairLength_mm, double diameter_mm, double lyingShare = 0.8);
/// Hairiness H as Uster testers give it: mm of loose fibre on 1 mm of yarn. That of the yarn as it is spun.
double hairinessH(const Yarn& yarn, const Fibre& fibre);
/// The yarn with as many hairs of its length as give it that H, within their range.
Yarn withHairinessH(Yarn yarn, const Fibre& fibre, double hairiness);

}  // namespace loomlight
