#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/fabric/model/absorption.h"
#include "core/fabric/model/mill_data.h"
#include "core/fabric/model/unknown_keys.h"
#include "core/fabric/model/weave.h"

namespace loomlight {

enum class FibreSection { round, kidney, triangle, trilobal, serrated, polygon };

/// The optics and fineness of one kind of fibre.
struct Fibre {
  std::string name = "cotton";
  double radius_um = 6.0;         ///< 1..200; equivalent round radius
  double density_g_cm3 = 1.52;    ///< 0.2..20
  double refractiveIndex = 1.55;  ///< 1.01..3
  Absorption absorption_per_mm;
  double longitudinalRoughness = 0.3;  ///< beta_m, 0.05..1 (Chiang 2016)
  double azimuthalRoughness = 0.3;     ///< beta_n, 0.05..1
  double scaleTilt_deg = 0.0;          ///< -10..10; cuticle scales (wool 2-3)
  FibreSection section = FibreSection::round;
  UnknownKeys unknown;
  friend bool operator==(const Fibre&, const Fibre&);
};

enum class TwistDirection { s, z };

/// How the fibres of a ply lie in its section: at random, overlaps allowed (the report), or packed without overlap.
enum class FibreLayout { random, packed };

/// One kind of yarn. Its mass is given either by the count, or by the number of fibres in a ply.
struct Yarn {
  std::string name = "yarn";
  int fibre = 0;                  ///< index into Fabric::fibres
  std::optional<int> blendFibre;  ///< a second fibre, evenly mixed with the first (melange): index into Fabric::fibres
  std::optional<double> blendShare;  ///< of the mass that is the second fibre, 0..1; half where it is not given
  double count_tex = 30.0;           ///< g per km of finished yarn, 0.5..5000; not used with fibresPerPly
  std::optional<int> fibresPerPly;   ///< 1..2000; the count then follows
  int plies = 1;                     ///< singles in a cord, 1..8
  double plyTwist_per_m = 700.0;     ///< turns of the fibres about the axis of their ply, 0..5000
  TwistDirection plyTwistDirection = TwistDirection::z;
  double yarnTwist_per_m = 0.0;  ///< turns of the plies about the axis of their cord, 0..5000; plies > 1 only
  TwistDirection yarnTwistDirection = TwistDirection::s;
  int cords = 1;                  ///< plied yarns that are cabled together, 1..6; 1: the yarn is no cable
  double cableTwist_per_m = 0.0;  ///< turns of the cords about the axis of the yarn, 0..5000; cords > 1 only
  TwistDirection cableTwistDirection = TwistDirection::z;
  double packing = 0.55;            ///< fibre volume over ply volume, 0.05..0.85
  double flattening = 1.2;          ///< how readily it flattens, 1..4: goes with the width over height of its section
  double hairiness_per_mm = 0.0;    ///< loose fibre ends and loops per mm of yarn, 0..50
  double hairLength_mm = 0.6;       ///< how far they reach, 0.05..3
  double migration = 0.0;           ///< 0..1: how far fibres wander between core and surface
  double evennessCv_percent = 0.0;  ///< Uster's CVm: of the mass of 8 mm of yarn, between its slubs, 0..40
  double slubs_per_m = 0.0;         ///< thick places that are spun in on purpose, 0..50
  double slubLength_mm = 30.0;      ///< of a slub at half its height, on average, 5..500
  double slubRatio = 1.8;           ///< of a slub's mass to the yarn's between slubs, 1.1..4
  double wrappers_per_cm = 0.0;     ///< fibres that are wound tightly around the body (rotor yarns), 0..40
  double shadeVariation_percent = 0.0;  ///< of the depth of its dye, from thread to thread, 0..40
  double fibreDisorder_deg = 0.0;       ///< how far fibres stray from their helix: RMS angle, along either axis, 0..20
  FibreLayout layout = FibreLayout::packed;
  UnknownKeys unknown;
  friend bool operator==(const Yarn&, const Yarn&);
};

/// folds: hanging in folds along its length; cushion: its upper face; skirt: a full circle on a waist.
enum class DrapeKind { flat, cylinder, sphere, folds, cushion, skirt, mesh };

/// The surface the cloth lies on.
struct Drape {
  DrapeKind kind = DrapeKind::flat;
  double width_mm = 20.0;   ///< from side to side: along the weft where the grain is straight, 1..10000
  double height_mm = 20.0;  ///< from top to bottom; skirt: from waist to hem. A mesh has its own size
  double radius_mm = 6.0;   ///< cylinder, sphere, tightest bend of folds, height of a cushion, waist: 0.5..10000
  /// How far the warp is turned to the left of the drape's length, seen from the face, -90..90; flat cloth is not
  /// turned. The length of a mesh is where the second of its texture coordinates rises.
  double grain_deg = 0.0;
  std::string file;         ///< mesh: OBJ, PLY or OFF with texture coordinates
  double uvScale_mm = 1.0;  ///< mesh: millimetres per unit of texture coordinate, 1e-3..1e6
  UnknownKeys unknown;
  friend bool operator==(const Drape&, const Drape&);
};

enum class LightKind { sky, overcast, window, booth, dome, furnace, back, headlight, directional, environment };

/// Which spectrum white light has: of the CIE (CIE 15:2018), of a black body, or of a file. The eye is adapted to it.
enum class StandardIlluminant { d65, d55, d50, a, e, f2, f7, f11, ledB1, ledB2, ledB3, ledB4, ledB5, blackBody, file };

/// What shines on the cloth. z is up. overcast: a grey sky over grass; window: a room with one window, in the direction
/// of the azimuth; booth: a light booth as dyers judge colours in, open towards the azimuth; these three light white
/// paper on a table to radiance 1. dome: white from above; furnace: white from everywhere; back: white from below.
struct Light {
  LightKind kind = LightKind::sky;
  double intensity = 1.0;  ///< factor on radiance, 0..1000
  /// Of the black body that white light is tinted like, 2000..12000, 6500: as it is; or of the black body that it is.
  double temperature_K = 6500;
  double azimuth_deg = 130.0;   ///< of the sun or the direction, from +x towards +y
  double elevation_deg = 45.0;  ///< -90..90, above the xy-plane; the sky needs > 0
  double turbidity = 3.0;       ///< sky: 2..10 (Preetham 1999)
  std::string file;             ///< environment: lat-long EXR
  StandardIlluminant illuminant = StandardIlluminant::d65;
  std::string illuminantFile;  ///< file: wavelengths in nm and power, two columns of text
  UnknownKeys unknown;
  friend bool operator==(const Light&, const Light&);
};

/// Looks at `target` from a direction given by two angles; perspective, or orthographic when fov is 0.
struct Camera {
  glm::dvec3 target_mm{0.0};
  double azimuth_deg = -90.0;   ///< where the camera stands, from +x towards +y
  double elevation_deg = 50.0;  ///< -90..90; 90 looks straight down
  double distance_mm = 60.0;    ///< 0.1..100000
  double fov_deg = 20.0;        ///< vertical, 0..120; 0: orthographic, the height seen is that of 20 degrees
  UnknownKeys unknown;
  friend bool operator==(const Camera&, const Camera&);
};

/// How a virtual scattering event chooses its component and tangent: ours (by sigma_i(d), tangents weighted by the
/// sine) or the report's (Eq. 12: by density alone, tangents unweighted). It is the law of Estimator::none; the other
/// estimators have their own.
enum class EventLaw { projected, report };

/// What light is traced through: the statistical volume, or every fibre as it is. Fibres are the truth that the volume
/// is measured against; they know no estimator.
enum class Method { volume, fibres };

/// How the volume stands for what its voxels have averaged away. none: virtual scattering events alone, chosen as
/// EventLaw says; report: those of the report with its local visibility (section 8.2); loomlight: ours.
enum class Estimator { none, report, loomlight };

struct RenderSettings {
  int width = 640;  ///< pixels, 1..16384
  int height = 480;
  int samplesPerPixel = 64;  ///< 1..1048576
  uint64_t seed = 1;
  int resolution = 8;   ///< voxels per yarn diameter: 1, 2, 4, 8 or 16
  int maxDepth = 4096;  ///< scattering events a path, 1..65536
  Method method = Method::volume;
  Estimator estimator = Estimator::loomlight;
  EventLaw eventLaw = EventLaw::projected;
  Observer observer = Observer::degrees2;
  UnknownKeys unknown;
  /// Whether tables of local visibility are baked for it.
  bool needsVisibility() const { return method == Method::volume && estimator == Estimator::report; }
  friend bool operator==(const RenderSettings&, const RenderSettings&);
};

/// Other colours for the same construction: how much each fibre absorbs, under a name.
struct Colourway {
  std::string name = "colourway";
  std::vector<Absorption> absorption_per_mm;  ///< per Fabric::fibres; fibres beyond its end keep their own
  UnknownKeys unknown;
  friend bool operator==(const Colourway&, const Colourway&);
};

struct WifOrigin;

/// Everything a designer edits; a value. Edits make a new one; threads and undo share them as
/// shared_ptr<const Fabric>.
struct Fabric {
  std::string name = "Untitled";
  std::string description;
  Weave weave;
  std::optional<Draft> draft;        ///< where present, weave == drawdown(*draft)
  std::vector<int> warpSequence{0};  ///< which yarn each end uses, repeating: indices into yarns
  std::vector<int> weftSequence{0};  ///< which yarn each pick uses
  /// How far each end is from the next over what others are, repeating: 0..kMostSpacing of them (thread_spacing.h);
  /// empty: all alike.
  std::vector<double> warpSpacing;
  std::vector<double> weftSpacing;  ///< likewise, of picks
  double ends_per_cm = 20.0;        ///< 0.2..500
  double picks_per_cm = 20.0;
  double settCv_percent = 0;           ///< coefficient of variation of the distances of neighbouring threads, 0..20
  double crowding = 0;                 ///< of threads that float together: 0 even, 1 as relaxed yarns stand, 0..3
  double press = 0.5;                  ///< finish: 0 washed and relaxed, 0.5 pressed, 1 calendered
  bool singed = false;                 ///< finish: loose fibres are burnt off
  bool brushed = false;                ///< finish: loose fibres are raised on the face, along the warp
  double milling = 0;                  ///< finish: 0 clear, 1 felted: yarns of staple fibre swell, and mat
  bool mercerised = false;             ///< finish: cotton is swollen in lye, round and lustrous
  double crimpBalance = 1.0;           ///< of warp against weft, 0.25..4; 1: their stiffness and setts decide
  std::vector<Yarn> yarns{Yarn{}};     ///< 1..64
  std::vector<Fibre> fibres{Fibre{}};  ///< 1..64
  std::vector<Colourway> colourways;   ///< 0..64, to choose from: the cloth has its fibres' own colours
  MillData mill;
  Drape drape;
  Light light;
  Camera camera;
  RenderSettings render;
  std::shared_ptr<const WifOrigin> wif;  ///< what a weaving file said beyond all this; null: it came from none
  UnknownKeys unknown;

  // What belongs to the threads of one system: warpSequence or weftSequence, warpSpacing or weftSpacing, and the
  // distance between neighbouring threads.
  const std::vector<int>& sequence(System system) const { return system == System::warp ? warpSequence : weftSequence; }
  const std::vector<double>& spacing(System system) const { return system == System::warp ? warpSpacing : weftSpacing; }
  double pitch_mm(System system) const { return system == System::warp ? warpPitch_mm() : weftPitch_mm(); }

  int warpYarn(int end) const;  ///< index of the yarn of that end; any integer
  int weftYarn(int pick) const;
  double warpPitch_mm() const { return 10.0 / ends_per_cm; }   ///< distance between neighbouring ends (along x)
  double weftPitch_mm() const { return 10.0 / picks_per_cm; }  ///< distance between neighbouring picks (along y)
  friend bool operator==(const Fabric&, const Fabric&);
};

}  // namespace loomlight
