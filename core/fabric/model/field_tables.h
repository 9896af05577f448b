#pragma once

#include "core/fabric/model/fabric.h"
#include "core/fabric/model/field_info.h"
#include "core/fabric/model/glossary.h"

/// Every editable value of a fabric: its key in files, its label, unit and range, and a sentence of help. The JSON
/// reader and writer, validation, comparison and the inspector all go through these tables, so they agree.
namespace loomlight {

template <>
struct FieldTable<Dyestuff> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Dyestuff::name, {label, "name", "Dye", "", 0, 0, "What the dyer calls it."}},
      Field{&Dyestuff::amount_percent,
            {colour, "amount_percent", "Amount", "%", 0, 100, "On weight of fibre, as a recipe has it."}},
      Field{&Dyestuff::absorption_per_mm,
            {colour, "absorption_per_mm", "Absorption", "/mm", 0, 10000, "Of a fibre with 1 % of it, in each band."}});
};

template <>
struct FieldTable<Fibre> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Fibre::name, {label, "name", words::fibreName.label, "", 0, 0, words::fibreName.help}},
      Field{&Fibre::radius_um,
            {shape, "radius_um", words::fibreRadius.label, "µm", 1, 200, words::fibreRadius.help, true}},
      Field{&Fibre::density_g_cm3,
            {shape, "density_g_cm3", words::fibreDensity.label, "g/cm³", 0.2, 20, words::fibreDensity.help, true}},
      Field{&Fibre::refractiveIndex,
            {optics, "refractive_index", words::refractiveIndex.label, "", 1.01, 3, words::refractiveIndex.help}},
      Field{&Fibre::absorption_per_mm,
            {colour, "absorption_per_mm", words::depthOfShade.label, "/mm", 0, 10000, words::depthOfShade.help, true}},
      Field{&Fibre::longitudinalRoughness,
            {optics, "longitudinal_roughness", words::dullnessAlong.label, "", 0.05, 1, words::dullnessAlong.help}},
      Field{&Fibre::azimuthalRoughness,
            {optics, "azimuthal_roughness", words::dullnessAround.label, "", 0.05, 1, words::dullnessAround.help}},
      Field{&Fibre::scaleTilt_deg,
            {optics, "scale_tilt_deg", words::scaleTilt.label, "°", -10, 10, words::scaleTilt.help}},
      Field{&Fibre::section, {optics, "section", words::fibreSection.label, "", 0, 0, words::fibreSection.help}});
};

template <>
struct FieldTable<Yarn> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Yarn::name, {label, "name", words::yarnName.label, "", 0, 0, words::yarnName.help}},
      Field{&Yarn::fibre, {shape | optics, "fibre", words::yarnFibre.label, "", 0, 63, words::yarnFibre.help}},
      Field{&Yarn::blendFibre,
            {shape | optics, "blend_fibre", words::blendedWith.label, "", 0, 63, words::blendedWith.help}},
      Field{&Yarn::blendShare,
            {shape | optics, "blend_share", words::blendShare.label, "", 0, 1, words::blendShare.help}},
      Field{&Yarn::count_tex, {shape, "count_tex", words::count.label, "tex", 0.5, 5000, words::count.help, true}},
      Field{&Yarn::fibresPerPly,
            {shape, "fibres_per_ply", words::fibresInSingle.label, "", 1, 2000, words::fibresInSingle.help, true}},
      Field{&Yarn::plies, {shape, "plies", words::plies.label, "", 1, 8, words::plies.help}},
      // What keys of files call a ply is the trade's single: ply twist is singles twist, and yarn twist is ply twist.
      Field{&Yarn::plyTwist_per_m,
            {shape, "ply_twist_per_m", words::singlesTwist.label, "turns/m", 0, 5000, words::singlesTwist.help}},
      Field{&Yarn::plyTwistDirection,
            {shape, "ply_twist_direction", words::singlesWay.label, "", 0, 0, words::singlesWay.help}},
      Field{&Yarn::yarnTwist_per_m,
            {shape, "yarn_twist_per_m", words::plyTwist.label, "turns/m", 0, 5000, words::plyTwist.help}},
      Field{&Yarn::yarnTwistDirection,
            {shape, "yarn_twist_direction", words::plyWay.label, "", 0, 0, words::plyWay.help}},
      Field{&Yarn::cords, {shape, "cords", words::cabledFrom.label, "", 1, 6, words::cabledFrom.help}},
      Field{&Yarn::cableTwist_per_m,
            {shape, "cable_twist_per_m", words::cableTwist.label, "turns/m", 0, 5000, words::cableTwist.help}},
      Field{&Yarn::cableTwistDirection,
            {shape, "cable_twist_direction", words::cableWay.label, "", 0, 0, words::cableWay.help}},
      Field{&Yarn::packing, {shape, "packing", words::compactness.label, "", 0.05, 0.85, words::compactness.help}},
      Field{&Yarn::flattening, {shape, "flattening", words::flattening.label, "", 1, 4, words::flattening.help}},
      Field{&Yarn::hairiness_per_mm,
            {shape, "hairiness_per_mm", words::hairiness.label, "/mm", 0, 50, words::hairiness.help}},
      Field{&Yarn::hairLength_mm,
            {shape, "hair_length_mm", words::hairLength.label, "mm", 0.05, 3, words::hairLength.help, true}},
      Field{&Yarn::wrappers_per_cm,
            {shape, "wrappers_per_cm", words::wrappers.label, "/cm", 0, 40, words::wrappers.help}},
      Field{&Yarn::shadeVariation_percent,
            {optics, "shade_variation_percent", words::shadeVariation.label, "%", 0, 40, words::shadeVariation.help}},
      Field{&Yarn::migration,
            {shape, "migration", words::fibreInterchange.label, "", 0, 1, words::fibreInterchange.help}},
      Field{&Yarn::fibreDisorder_deg,
            {shape, "fibre_disorder_deg", words::parallelism.label, "°", 0, 20, words::parallelism.help}},
      Field{&Yarn::evennessCv_percent,
            {shape, "evenness_cv_percent", words::evenness.label, "%", 0, 40, words::evenness.help}},
      Field{&Yarn::slubs_per_m, {shape, "slubs_per_m", words::slubs.label, "/m", 0, 50, words::slubs.help}},
      Field{&Yarn::slubLength_mm,
            {shape, "slub_length_mm", words::slubLength.label, "mm", 5, 500, words::slubLength.help, true}},
      Field{&Yarn::slubRatio, {shape, "slub_ratio", words::slubRatio.label, "×", 1.1, 4, words::slubRatio.help}},
      Field{&Yarn::layout, {shape, "layout", words::fibreLayout.label, "", 0, 0, words::fibreLayout.help}});
};

template <>
struct FieldTable<Drape> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Drape::kind, {drape, "kind", "Drape", "", 0, 0, "The surface the cloth lies on."}},
      Field{&Drape::width_mm,
            {drape, "width_mm", "Width", "mm", 1, 10000,
             "Size of the piece from side to side, along the weft where its grain is straight.", true}},
      Field{&Drape::height_mm,
            {drape, "height_mm", "Height", "mm", 1, 10000,
             "Size of the piece from top to bottom, along the warp where its grain is straight.", true}},
      Field{&Drape::radius_mm,
            {drape, "radius_mm", "Radius", "mm", 0.5, 10000,
             "Of the cylinder, the sphere or the waist of a skirt; of folds, the tightest bend; of a cushion, its "
             "height.",
             true}},
      Field{&Drape::grain_deg,
            {drape, "grain_deg", "Grain", "°", -90, 90,
             "How far the warp is turned to the left of the drape's length: 0 is straight grain, 45 the bias, 90 cross "
             "grain. Yarns gleam where they bend, so a satin shines in folds that cross its floats. Flat cloth is not "
             "turned."}},
      Field{&Drape::file, {drape, "file", "Mesh", "", 0, 0, "An OBJ, PLY or OFF file with texture coordinates."}},
      Field{&Drape::uvScale_mm,
            {drape, "uv_scale_mm", "Scale", "mm", 1e-3, 1e6, "Millimetres of cloth for one unit of texture coordinate.",
             true}});
};

template <>
struct FieldTable<Light> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Light::kind, {light | surroundings, "kind", "Light", "", 0, 0, "What shines on the cloth."}},
      Field{&Light::intensity,
            {brightness, "intensity", "Intensity", "×", 0, 1000, "Factor on the brightness of the light.", true}},
      Field{&Light::temperature_K,
            {brightness, "temperature_k", "Temperature", "K", 2000, 12000,
             "Colour of the light: 2700 is a warm lamp, 4000 a shop's, 6500 leaves it as it is, 9000 is a blue sky's. "
             "It changes the colour alone, not the brightness.",
             true}},
      Field{&Light::azimuth_deg,
            {light, "azimuth_deg", "Azimuth", "°", -360, 360,
             "Where the sun or the lamp stands, turning left from the right."}},
      Field{&Light::elevation_deg,
            {light, "elevation_deg", "Elevation", "°", -90, 90,
             "How high the sun or the lamp stands; a sky needs more than 0."}},
      Field{&Light::turbidity,
            {light, "turbidity", "Haze", "", 2, 10, "Haze of the sky: 2 is clear, 10 is hazy (turbidity)."}},
      Field{&Light::file,
            {light | surroundings, "file", "Environment", "", 0, 0,
             "A picture of the surroundings: latitude-longitude EXR."}},
      Field{&Light::illuminant,
            {colour | brightness, "illuminant", "Lamp spectrum", "", 0, 0,
             "The spectrum of white light: D65 is daylight, A a light bulb, F2, F7 and F11 (TL84) are fluorescent "
             "tubes, LED-B1 to LED-B5 white diodes. The eye is adapted to it, so white stays white, and dyes shift."}},
      Field{&Light::illuminantFile,
            {colour, "illuminant_file", "Measured spectrum", "", 0, 0,
             "A measured lamp: a text file of two columns, nm and power."}});
};

template <>
struct FieldTable<Camera> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Camera::target_mm,
            {camera | light, "target_mm", "Target", "mm", -1e5, 1e5, "The point the camera looks at."}},
      Field{&Camera::azimuth_deg,
            {camera | light, "azimuth_deg", "Azimuth", "°", -360, 360,
             "Where the camera stands, turning left from the right."}},
      Field{&Camera::elevation_deg,
            {camera | light, "elevation_deg", "Elevation", "°", -90, 90,
             "How high the camera stands; 90 looks straight down."}},
      Field{&Camera::distance_mm,
            {camera | light, "distance_mm", "Distance", "mm", 0.1, 1e5, "From the camera to its target.", true}},
      Field{&Camera::fov_deg,
            {camera, "fov_deg", "Field of view", "°", 0, 120,
             "Angle of the view from top to bottom; 0 is without perspective."}});
};

template <>
struct FieldTable<RenderSettings> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&RenderSettings::width, {camera, "width", "Width", "px", 1, 16384, "Width of a snapshot."}},
      Field{&RenderSettings::height, {camera, "height", "Height", "px", 1, 16384, "Height of a snapshot."}},
      Field{&RenderSettings::samplesPerPixel,
            {label, "samples_per_pixel", "Samples", "per px", 1, 1048576,
             "Light paths for every pixel; more is less noise.", true}},
      Field{
          &RenderSettings::seed,
          {sampling, "seed", "Seed", "", 0, 18446744073709551615.0, "Another number gives another pattern of noise."}},
      Field{&RenderSettings::resolution,
            {grid, "resolution", "Resolution", "per yarn", 1, 16,
             "Voxels across the thinnest yarn: 1, 2, 4, 8 or 16; beyond 8 no finer than a fibre."}},
      Field{&RenderSettings::maxDepth,
            {sampling, "max_depth", "Depth", "events", 1, 65536,
             "Where a light path ends at the latest, in fibres met.", true}},
      Field{
          &RenderSettings::method,
          {optics, "method", "Method", "", 0, 0,
           "What light is traced through: the volume, or every single fibre, which is the truth and takes far more."}},
      Field{&RenderSettings::estimator,
            {optics, "estimator", "Estimator", "", 0, 0,
             "How the volume sees what is smaller than a voxel: not at all, as the report does, or our way."}},
      Field{&RenderSettings::eventLaw,
            {optics, "event_law", "Event law", "", 0, 0,
             "Without an estimator, how a path chooses its fibre: by what it sees of it, or by density alone (the "
             "report)."}},
      Field{
          &RenderSettings::observer,
          {colour, "observer", "Observer", "", 0, 0,
           "Whose eye sees the colours: the CIE standard observer for patches of 2 degrees, or for 10, as the textile "
           "trade measures."}});
};

template <>
struct FieldTable<Draft> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Draft::shafts, {label, "shafts", words::shafts.label, "", 0, 4096, words::shafts.help}},
      Field{&Draft::treadles, {label, "treadles", words::treadles.label, "", 0, 4096, words::treadles.help}},
      Field{&Draft::risingShed, {label, "rising_shed", words::risingShed.label, "", 0, 0, words::risingShed.help}});
};

template <>
struct FieldTable<Colourway> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Colourway::name, {label, "name", "Colourway", "", 0, 0, "What these colours are called."}});
};

template <>
struct FieldTable<MillData> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&MillData::reed_per_10cm,
            {label, "reed_per_10cm", words::reed.label, "dents/10 cm", 0, 1000, words::reed.help}},
      Field{&MillData::loomEnds_per_cm,
            {label, "loom_ends_per_cm", words::loomEnds.label, "/cm", 0, 500, words::loomEnds.help}},
      Field{&MillData::loomPicks_per_cm,
            {label, "loom_picks_per_cm", words::loomPicks.label, "/cm", 0, 500, words::loomPicks.help}},
      Field{&MillData::washedEnds_per_cm,
            {label, "washed_ends_per_cm", words::washedEnds.label, "/cm", 0, 500, words::washedEnds.help}},
      Field{&MillData::washedPicks_per_cm,
            {label, "washed_picks_per_cm", words::washedPicks.label, "/cm", 0, 500, words::washedPicks.help}},
      Field{&MillData::selvedgeEnds,
            {label, "selvedge_ends", words::selvedgeEnds.label, "each side", 0, 1000, words::selvedgeEnds.help}},
      Field{&MillData::selvedgeYarn,
            {label, "selvedge_yarn", words::selvedgeYarn.label, "", 0, 63, words::selvedgeYarn.help}},
      Field{&MillData::selvedgeEndsPerDent,
            {label, "selvedge_ends_per_dent", words::selvedgeDenting.label, "", 1, MillData::kMostInDent,
             words::selvedgeDenting.help}},
      Field{&MillData::selvedgeWeave,
            {label, "selvedge_weave", words::selvedgeWeave.label, "", 0, 0, words::selvedgeWeave.help}});
};

template <>
struct FieldTable<Fabric> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Fabric::name, {label, "name", words::clothName.label, "", 0, 0, words::clothName.help}},
      Field{&Fabric::description, {label, "description", words::description.label, "", 0, 0, words::description.help}},
      Field{&Fabric::ends_per_cm, {grid, "ends_per_cm", words::ends.label, "/cm", 0.2, 500, words::ends.help, true}},
      Field{&Fabric::picks_per_cm,
            {grid, "picks_per_cm", words::picks.label, "/cm", 0.2, 500, words::picks.help, true}},
      Field{&Fabric::settCv_percent, {grid, "sett_cv_percent", words::settCv.label, "%", 0, 20, words::settCv.help}},
      Field{&Fabric::crowding, {grid, "crowding", words::crowding.label, "×", 0, 3, words::crowding.help}},
      Field{&Fabric::press, {grid, "press", words::press.label, "", 0, 1, words::press.help}},
      Field{&Fabric::singed, {grid, "singed", words::singed.label, "", 0, 0, words::singed.help}},
      Field{&Fabric::brushed, {grid, "brushed", words::brushed.label, "", 0, 0, words::brushed.help}},
      Field{&Fabric::milling, {grid, "milling", words::milling.label, "", 0, 1, words::milling.help}},
      Field{&Fabric::mercerised, {optics, "mercerised", words::mercerised.label, "", 0, 0, words::mercerised.help}},
      Field{&Fabric::crimpBalance,
            {grid, "crimp_balance", words::crimpBalance.label, "×", 0.25, 4, words::crimpBalance.help, true}});
};

}  // namespace loomlight
