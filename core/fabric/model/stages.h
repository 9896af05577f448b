#pragma once

namespace loomlight {

/// What stands between a fabric and its picture. Every field of a fabric names the stages that are to be made again
/// when it changes (field_tables.h).
enum class Stage : unsigned {
  label,         ///< what something is called, or how long one looks: nothing is made again
  shape,         ///< how fibres lie: voxels of the yarns and crossings concerned
  grid,          ///< where threads and voxels lie: every voxel, and the extent of a flat piece
  thread,        ///< which yarn an end or a pick uses
  drape,         ///< the surface that the cloth lies on
  optics,        ///< what light does at a fibre, and by which law: scattering tables, media
  colour,        ///< how much fibres absorb: finished paths can be coloured anew
  brightness,    ///< how much light the lamps give, and of which tint: a factor
  light,         ///< where light comes from
  surroundings,  ///< the picture of what stands around the cloth, however bright and whichever way it is turned
  camera,        ///< what is looked at, from where
  sampling,      ///< which paths are taken
};

/// A set of stages.
class Stages {
 public:
  constexpr Stages() = default;
  constexpr Stages(Stage stage) : bits_(1u << static_cast<unsigned>(stage)) {}

  /// Whether they have one of these.
  constexpr bool any(Stages of) const { return (bits_ & of.bits_) != 0; }
  /// Whether they have none but these.
  constexpr bool within(Stages others) const { return (bits_ & ~others.bits_) == 0; }

  constexpr Stages& operator|=(Stages others) {
    bits_ |= others.bits_;
    return *this;
  }
  constexpr Stages& operator-=(Stages others) {
    bits_ &= ~others.bits_;
    return *this;
  }
  constexpr bool operator==(const Stages&) const = default;

 private:
  unsigned bits_ = 0;
};

constexpr Stages operator|(Stages a, Stages b) {
  return a |= b;
}
constexpr Stages operator|(Stage a, Stage b) {
  return Stages(a) | Stages(b);
}
constexpr Stages operator-(Stages a, Stages b) {
  return a -= b;
}

}  // namespace loomlight
