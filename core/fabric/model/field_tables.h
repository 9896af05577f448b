#pragma once

#include "core/fabric/model/fabric.h"
#include "core/fabric/model/field_info.h"

/// Every editable value of a fabric: its key in files, its label, unit and range, and a sentence of help. The JSON
/// reader and writer, validation, comparison and the inspector all go through these tables, so they agree.
namespace loomlight {

template <>
struct FieldTable<Fibre> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Fibre::name, {label, "name", "Fibre", "", 0, 0, "What this fibre is called."}},
      Field{
          &Fibre::radius_um,
          {shape, "radius_um", "Radius", "µm", 1, 200, "Half the thickness of one fibre, as if it were round.", true}},
      Field{&Fibre::density_g_cm3,
            {shape, "density_g_cm3", "Density", "g/cm³", 0.2, 20, "Mass of the fibre's substance.", true}},
      Field{&Fibre::refractiveIndex,
            {optics, "refractive_index", "Refractive index", "", 1.01, 3,
             "How strongly the fibre bends and mirrors light; textile fibres lie between 1.46 and 1.6."}},
      Field{&Fibre::absorption_per_mm,
            {colour, "absorption_per_mm", "Absorption", "1/mm", 0, 10000,
             "How deep the colour is: light lost on its way inside the fibre, for red, green and blue.", true}},
      Field{&Fibre::longitudinalRoughness,
            {optics, "longitudinal_roughness", "Roughness along", "", 0.05, 1,
             "How far highlights spread along the fibre: low is lustrous, high is matt (beta_m)."}},
      Field{&Fibre::azimuthalRoughness,
            {optics, "azimuthal_roughness", "Roughness around", "", 0.05, 1,
             "How far light spreads around the fibre; irregular sections have much of it (beta_n)."}},
      Field{&Fibre::scaleTilt_deg,
            {optics, "scale_tilt_deg", "Scale tilt", "°", -10, 10,
             "Tilt of the surface scales; wool has 2 to 3 degrees."}},
      Field{&Fibre::section, {optics, "section", "Section", "", 0, 0, "Shape of the fibre, cut across."}});
};

template <>
struct FieldTable<Yarn> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Yarn::name, {label, "name", "Yarn", "", 0, 0, "What this yarn is called."}},
      Field{&Yarn::fibre,
            {shape | optics, "fibre", "Fibre", "", 0, 63, "The fibre it is spun of: a number in the list, from 0."}},
      Field{&Yarn::blendFibre,
            {shape | optics, "blend_fibre", "Blended with", "", 0, 63,
             "A second fibre that is spun together with the first: a number in the list, from 0."}},
      Field{&Yarn::blendShare,
            {shape | optics, "blend_share", "Share", "", 0, 1, "How much of the yarn's mass is the second fibre."}},
      Field{&Yarn::count_tex,
            {shape, "count_tex", "Count", "tex", 0.5, 5000, "How thick the yarn is: grams of one kilometre.", true}},
      Field{&Yarn::fibresPerPly,
            {shape, "fibres_per_ply", "Fibres per ply", "", 1, 2000,
             "Number of fibres in one ply; where it is given, the count follows from it.", true}},
      Field{&Yarn::plies, {shape, "plies", "Plies", "", 1, 8, "How many singles are twisted together."}},
      Field{&Yarn::plyTwist_per_m,
            {shape, "ply_twist_per_m", "Ply twist", "turns/m", 0, 5000,
             "Turns of the fibres about the axis of their ply."}},
      Field{
          &Yarn::plyTwistDirection,
          {shape, "ply_twist_direction", "Ply direction", "", 0, 0, "Fibres on the near side slant like this letter."}},
      Field{&Yarn::yarnTwist_per_m,
            {shape, "yarn_twist_per_m", "Yarn twist", "turns/m", 0, 5000, "Turns of the plies about each other."}},
      Field{&Yarn::yarnTwistDirection,
            {shape, "yarn_twist_direction", "Yarn direction", "", 0, 0,
             "Plies on the near side slant like this letter."}},
      Field{&Yarn::cords,
            {shape, "cords", "Cords", "", 1, 6,
             "How many plied yarns are twisted together once more, to a cable; 1 is an ordinary yarn."}},
      Field{&Yarn::cableTwist_per_m,
            {shape, "cable_twist_per_m", "Cable twist", "turns/m", 0, 5000, "Turns of the cords about each other."}},
      Field{&Yarn::cableTwistDirection,
            {shape, "cable_twist_direction", "Cable direction", "", 0, 0,
             "Cords on the near side slant like this letter."}},
      Field{&Yarn::packing,
            {shape, "packing", "Packing", "", 0.05, 0.85,
             "Share of a ply's section that is fibre, the rest is air: soft yarns 0.3, ring-spun 0.55, filament 0.7."}},
      Field{&Yarn::flattening,
            {shape, "flattening", "Flattening", "", 1, 4,
             "How readily the yarn's section flattens in the cloth: 1.2 as most do, more for a wider one."}},
      Field{&Yarn::hairiness_per_mm,
            {shape, "hairiness_per_mm", "Hairiness", "1/mm", 0, 50,
             "Loose fibre ends and loops on one millimetre of yarn."}},
      Field{&Yarn::hairLength_mm,
            {shape, "hair_length_mm", "Hair length", "mm", 0.05, 3, "How far loose fibres reach.", true}},
      Field{&Yarn::migration,
            {shape, "migration", "Migration", "", 0, 1,
             "How far fibres wander between the core and the surface of the yarn."}},
      Field{&Yarn::fibreDisorder_deg,
            {shape, "fibre_disorder_deg", "Fibre disorder", "°", 0, 20,
             "How far fibres stray from lying side by side: filaments 1, compact and worsted yarns 4 to 5, ring-spun "
             "cotton 6 to 9, rotor and woollen yarns 11 to 15."}},
      Field{&Yarn::layout,
            {shape, "layout", "Fibre layout", "", 0, 0,
             "How fibres lie in the section: at random, overlaps allowed, or packed without overlap."}});
};

template <>
struct FieldTable<Drape> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Drape::kind, {drape, "kind", "Drape", "", 0, 0, "The surface the cloth lies on."}},
      Field{&Drape::width_mm, {drape, "width_mm", "Width", "mm", 1, 10000, "Size of the piece along the weft.", true}},
      Field{&Drape::height_mm,
            {drape, "height_mm", "Height", "mm", 1, 10000, "Size of the piece along the warp.", true}},
      Field{&Drape::radius_mm,
            {drape, "radius_mm", "Radius", "mm", 0.5, 10000,
             "Of the cylinder, the sphere or the waist of a skirt; of folds, the tightest bend; of a cushion, its "
             "height.",
             true}},
      Field{&Drape::file, {drape, "file", "Mesh", "", 0, 0, "An OBJ, PLY or OFF file with texture coordinates."}},
      Field{&Drape::uvScale_mm,
            {drape, "uv_scale_mm", "Scale", "mm", 1e-3, 1e6, "Millimetres of cloth for one unit of texture coordinate.",
             true}});
};

template <>
struct FieldTable<Light> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Light::kind, {light, "kind", "Light", "", 0, 0, "What shines on the cloth."}},
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
            {light, "file", "Environment", "", 0, 0, "A picture of the surroundings: latitude-longitude EXR."}});
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
             "report)."}});
};

template <>
struct FieldTable<Draft> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Draft::shafts, {label, "shafts", "Shafts", "", 0, 4096, "Frames that lift the ends threaded on them."}},
      Field{&Draft::treadles,
            {label, "treadles", "Treadles", "", 0, 4096, "Pedals that move the shafts tied to them."}},
      Field{&Draft::risingShed,
            {label, "rising_shed", "Rising shed", "", 0, 0,
             "Tied shafts are raised; in a sinking shed they are pulled down."}});
};

template <>
struct FieldTable<Colourway> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Colourway::name, {label, "name", "Colourway", "", 0, 0, "What these colours are called."}});
};

template <>
struct FieldTable<Fabric> {
  using enum Stage;
  static constexpr auto fields = std::make_tuple(
      Field{&Fabric::name, {label, "name", "Name", "", 0, 0, "What this cloth is called."}},
      Field{&Fabric::description, {label, "description", "Description", "", 0, 0, "Anything worth saying about it."}},
      Field{&Fabric::ends_per_cm,
            {grid, "ends_per_cm", "Ends", "/cm", 0.2, 500, "Warp yarns, side by side on one centimetre.", true}},
      Field{&Fabric::picks_per_cm,
            {grid, "picks_per_cm", "Picks", "/cm", 0.2, 500, "Weft yarns, side by side on one centimetre.", true}},
      Field{&Fabric::press,
            {grid, "press", "Press", "", 0, 1,
             "How the cloth was finished: 0 washed and relaxed, 0.5 pressed, 1 calendered, thin and flat."}},
      Field{&Fabric::crimpBalance,
            {grid, "crimp_balance", "Crimp balance", "×", 0.25, 4,
             "Above 1 the warp takes more of the crimp, below 1 the weft; at 1 stiffness and sett decide.", true}});
};

}  // namespace loomlight
