#pragma once

#include "core/fabric/model/fabric.h"
#include "core/fabric/model/field_info.h"

/// Every editable value of a fabric: its key in files, its label, unit and range, and a sentence of help. The JSON
/// reader and writer, validation, comparison and the inspector all go through these tables, so they agree.
namespace loomlight {

template <>
struct FieldTable<Fibre> {
  static constexpr auto fields = std::make_tuple(
      Field{&Fibre::name, {"name", "Fibre", "", 0, 0, "What this fibre is called."}},
      Field{&Fibre::radius_um,
            {"radius_um", "Radius", "µm", 1, 200, "Half the thickness of one fibre, as if it were round.", true}},
      Field{&Fibre::density_g_cm3,
            {"density_g_cm3", "Density", "g/cm³", 0.2, 20, "Mass of the fibre's substance.", true}},
      Field{&Fibre::refractiveIndex,
            {"refractive_index", "Refractive index", "", 1.01, 3,
             "How strongly the fibre bends and mirrors light; textile fibres lie between 1.46 and 1.6."}},
      Field{&Fibre::absorption_per_mm,
            {"absorption_per_mm", "Absorption", "1/mm", 0, 10000,
             "How deep the colour is: light lost on its way inside the fibre, for red, green and blue.", true}},
      Field{&Fibre::longitudinalRoughness,
            {"longitudinal_roughness", "Roughness along", "", 0.05, 1,
             "How far highlights spread along the fibre: low is lustrous, high is matt (beta_m)."}},
      Field{&Fibre::azimuthalRoughness,
            {"azimuthal_roughness", "Roughness around", "", 0.05, 1,
             "How far light spreads around the fibre; irregular sections have much of it (beta_n)."}},
      Field{&Fibre::scaleTilt_deg,
            {"scale_tilt_deg", "Scale tilt", "°", -10, 10, "Tilt of the surface scales; wool has 2 to 3 degrees."}},
      Field{&Fibre::section, {"section", "Section", "", 0, 0, "Shape of the fibre, cut across."}});
};

template <>
struct FieldTable<Yarn> {
  static constexpr auto fields = std::make_tuple(
      Field{&Yarn::name, {"name", "Yarn", "", 0, 0, "What this yarn is called."}},
      Field{&Yarn::fibre, {"fibre", "Fibre", "", 0, 63, "The fibre it is spun of: a number in the list, from 0."}},
      Field{&Yarn::blendFibre,
            {"blend_fibre", "Blended with", "", 0, 63,
             "A second fibre that is spun together with the first: a number in the list, from 0."}},
      Field{&Yarn::blendShare, {"blend_share", "Share", "", 0, 1, "How much of the yarn's mass is the second fibre."}},
      Field{&Yarn::count_tex,
            {"count_tex", "Count", "tex", 0.5, 5000, "How thick the yarn is: grams of one kilometre.", true}},
      Field{&Yarn::fibresPerPly,
            {"fibres_per_ply", "Fibres per ply", "", 1, 2000,
             "Number of fibres in one ply; where it is given, the count follows from it.", true}},
      Field{&Yarn::plies, {"plies", "Plies", "", 1, 8, "How many singles are twisted together."}},
      Field{&Yarn::plyTwist_per_m,
            {"ply_twist_per_m", "Ply twist", "turns/m", 0, 5000, "Turns of the fibres about the axis of their ply."}},
      Field{&Yarn::plyTwistDirection,
            {"ply_twist_direction", "Ply direction", "", 0, 0, "Fibres on the near side slant like this letter."}},
      Field{&Yarn::yarnTwist_per_m,
            {"yarn_twist_per_m", "Yarn twist", "turns/m", 0, 5000, "Turns of the plies about each other."}},
      Field{&Yarn::yarnTwistDirection,
            {"yarn_twist_direction", "Yarn direction", "", 0, 0, "Plies on the near side slant like this letter."}},
      Field{&Yarn::cords,
            {"cords", "Cords", "", 1, 6,
             "How many plied yarns are twisted together once more, to a cable; 1 is an ordinary yarn."}},
      Field{&Yarn::cableTwist_per_m,
            {"cable_twist_per_m", "Cable twist", "turns/m", 0, 5000, "Turns of the cords about each other."}},
      Field{&Yarn::cableTwistDirection,
            {"cable_twist_direction", "Cable direction", "", 0, 0, "Cords on the near side slant like this letter."}},
      Field{&Yarn::packing,
            {"packing", "Packing", "", 0.05, 0.85,
             "Share of a ply's section that is fibre, the rest is air: soft yarns 0.3, ring-spun 0.55, filament 0.7."}},
      Field{&Yarn::flattening,
            {"flattening", "Flattening", "", 1, 4,
             "How much wider than high the yarn's section is, pressed in the cloth."}},
      Field{&Yarn::hairiness_per_mm,
            {"hairiness_per_mm", "Hairiness", "1/mm", 0, 50, "Loose fibre ends and loops on one millimetre of yarn."}},
      Field{&Yarn::hairLength_mm,
            {"hair_length_mm", "Hair length", "mm", 0.05, 3, "How far loose fibres reach.", true}},
      Field{
          &Yarn::migration,
          {"migration", "Migration", "", 0, 1, "How far fibres wander between the core and the surface of the yarn."}},
      Field{&Yarn::layout,
            {"layout", "Fibre layout", "", 0, 0,
             "How fibres lie in the section: at random, overlaps allowed, or packed without overlap."}});
};

template <>
struct FieldTable<Drape> {
  static constexpr auto fields = std::make_tuple(
      Field{&Drape::kind, {"kind", "Drape", "", 0, 0, "The surface the cloth lies on."}},
      Field{&Drape::width_mm, {"width_mm", "Width", "mm", 1, 10000, "Size of the piece along the weft.", true}},
      Field{&Drape::height_mm, {"height_mm", "Height", "mm", 1, 10000, "Size of the piece along the warp.", true}},
      Field{&Drape::radius_mm,
            {"radius_mm", "Radius", "mm", 0.5, 10000,
             "Of the cylinder, the sphere or the waist of a skirt; of folds, the tightest bend; of a cushion, its "
             "height.",
             true}},
      Field{&Drape::file, {"file", "Mesh", "", 0, 0, "An OBJ, PLY or OFF file with texture coordinates."}},
      Field{
          &Drape::uvScale_mm,
          {"uv_scale_mm", "Scale", "mm", 1e-3, 1e6, "Millimetres of cloth for one unit of texture coordinate.", true}});
};

template <>
struct FieldTable<Light> {
  static constexpr auto fields = std::make_tuple(
      Field{&Light::kind, {"kind", "Light", "", 0, 0, "What shines on the cloth."}},
      Field{&Light::intensity,
            {"intensity", "Intensity", "×", 0, 1000, "Factor on the brightness of the light.", true}},
      Field{&Light::temperature_K,
            {"temperature_k", "Temperature", "K", 2000, 12000,
             "Colour of the light: 2700 is a warm lamp, 4000 a shop's, 6500 leaves it as it is, 9000 is a blue sky's. "
             "It changes the colour alone, not the brightness.",
             true}},
      Field{
          &Light::azimuth_deg,
          {"azimuth_deg", "Azimuth", "°", -360, 360, "Where the sun or the lamp stands, turning left from the right."}},
      Field{&Light::elevation_deg,
            {"elevation_deg", "Elevation", "°", -90, 90,
             "How high the sun or the lamp stands; a sky needs more than 0."}},
      Field{&Light::turbidity,
            {"turbidity", "Haze", "", 2, 10, "Haze of the sky: 2 is clear, 10 is hazy (turbidity)."}},
      Field{&Light::file, {"file", "Environment", "", 0, 0, "A picture of the surroundings: latitude-longitude EXR."}});
};

template <>
struct FieldTable<Camera> {
  static constexpr auto fields = std::make_tuple(
      Field{&Camera::target_mm, {"target_mm", "Target", "mm", -1e5, 1e5, "The point the camera looks at."}},
      Field{&Camera::azimuth_deg,
            {"azimuth_deg", "Azimuth", "°", -360, 360, "Where the camera stands, turning left from the right."}},
      Field{&Camera::elevation_deg,
            {"elevation_deg", "Elevation", "°", -90, 90, "How high the camera stands; 90 looks straight down."}},
      Field{&Camera::distance_mm, {"distance_mm", "Distance", "mm", 0.1, 1e5, "From the camera to its target.", true}},
      Field{&Camera::fov_deg,
            {"fov_deg", "Field of view", "°", 0, 120,
             "Angle of the view from top to bottom; 0 is without perspective."}});
};

template <>
struct FieldTable<RenderSettings> {
  static constexpr auto fields = std::make_tuple(
      Field{&RenderSettings::width, {"width", "Width", "px", 1, 16384, "Width of a snapshot."}},
      Field{&RenderSettings::height, {"height", "Height", "px", 1, 16384, "Height of a snapshot."}},
      Field{&RenderSettings::samplesPerPixel,
            {"samples_per_pixel", "Samples", "per px", 1, 1048576, "Light paths for every pixel; more is less noise.",
             true}},
      Field{&RenderSettings::seed,
            {"seed", "Seed", "", 0, 18446744073709551615.0, "Another number gives another pattern of noise."}},
      Field{&RenderSettings::resolution,
            {"resolution", "Resolution", "per yarn", 1, 16,
             "Voxels across the thinnest yarn: 1, 2, 4, 8 or 16; beyond 8 no finer than a fibre."}},
      Field{&RenderSettings::maxDepth,
            {"max_depth", "Depth", "events", 1, 65536, "Where a light path ends at the latest, in fibres met.", true}},
      Field{
          &RenderSettings::method,
          {"method", "Method", "", 0, 0,
           "What light is traced through: the volume, or every single fibre, which is the truth and takes far more."}},
      Field{&RenderSettings::estimator,
            {"estimator", "Estimator", "", 0, 0,
             "How the volume sees what is smaller than a voxel: not at all, as the report does, or our way."}},
      Field{&RenderSettings::eventLaw,
            {"event_law", "Event law", "", 0, 0,
             "Without an estimator, how a path chooses its fibre: by what it sees of it, or by density alone (the "
             "report)."}});
};

template <>
struct FieldTable<Draft> {
  static constexpr auto fields = std::make_tuple(
      Field{&Draft::shafts, {"shafts", "Shafts", "", 0, 4096, "Frames that lift the ends threaded on them."}},
      Field{&Draft::treadles, {"treadles", "Treadles", "", 0, 4096, "Pedals that move the shafts tied to them."}},
      Field{
          &Draft::risingShed,
          {"rising_shed", "Rising shed", "", 0, 0, "Tied shafts are raised; in a sinking shed they are pulled down."}});
};

template <>
struct FieldTable<Colourway> {
  static constexpr auto fields =
      std::make_tuple(Field{&Colourway::name, {"name", "Colourway", "", 0, 0, "What these colours are called."}});
};

template <>
struct FieldTable<Fabric> {
  static constexpr auto fields = std::make_tuple(
      Field{&Fabric::name, {"name", "Name", "", 0, 0, "What this cloth is called."}},
      Field{&Fabric::description, {"description", "Description", "", 0, 0, "Anything worth saying about it."}},
      Field{&Fabric::ends_per_cm,
            {"ends_per_cm", "Ends", "/cm", 0.2, 500, "Warp yarns, side by side on one centimetre.", true}},
      Field{&Fabric::picks_per_cm,
            {"picks_per_cm", "Picks", "/cm", 0.2, 500, "Weft yarns, side by side on one centimetre.", true}});
};

}  // namespace loomlight
