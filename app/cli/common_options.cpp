#include "app/cli/common_options.h"

#include <CLI/CLI.hpp>

namespace loomlight {

void addValue(CLI::App& app, const std::string& name, const std::string& value, const std::string& help,
              const Setter& set) {
  const std::string option = name.substr(name.rfind(',') + 1);
  app.add_option_function<std::string>(
         name, [option, set](const std::string& text) { set(option, text); }, help)
      ->type_name(value);
}

void addValues(CLI::App& app, const std::string& name, const std::string& value, const std::string& help,
               const Setter& set) {
  app.add_option_function<std::vector<std::string>>(
         name,
         [name, set](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) set(name, text);
         },
         help)
      ->type_name(value)
      ->allow_extra_args(false);
}

void addInputFile(CLI::App& app, const std::string& name, std::string& file) {
  app.add_option(name, file,
                 "a fabric (.json, .loomlight), draft (.wif, .dtx, .twa), weave bitmap (.png) or picture (.exr)")
      ->type_name("")
      ->required();
}

void addInput(CLI::App& app, const std::string& name, FabricSource& input) {
  addInputFile(app, name, input.file);
  addWifChoices(app, input.wif);
}

void addResolution(CLI::App& app, FabricOptions& options) {
  addValue(app, "--resolution", "R", "voxels per yarn diameter: 1, 2, 4, 8 or 16; beyond 8 no finer than a fibre",
           [&options](const auto& option, const auto& text) { options.resolution = parseResolution(option, text); });
}

void addFabricOptions(CLI::App& app, FabricOptions& options) {
  addValue(app, "--drape", "KIND|FILE",
           "what the cloth lies on: flat, cylinder, sphere, folds, cushion, skirt, or a mesh",
           [&options](const auto& option, const auto& text) { options.drape = parseDrape(option, text); });
  addValue(app, "--grain", "DEG",
           "how far the warp is turned to the left of the length of a drape that is not flat: 45 is the bias",
           [&options](const auto& option, const auto& text) {
             options.grain_deg = parseField(option, text, &Drape::grain_deg);
           });
  addValue(app, "--uv-scale", "MM", "millimetres of cloth per unit of a mesh's texture coordinates",
           [&options](const auto& option, const auto& text) {
             options.uvScale_mm = parseField(option, text, &Drape::uvScale_mm);
           });
  addResolution(app, options);
}

void addSampling(CLI::App& app, FabricOptions& options, const std::string& samplesHelp) {
  addValue(app, "--spp", "N", samplesHelp, [&options](const auto& option, const auto& text) {
    options.samplesPerPixel = parseWholeField(option, text, &RenderSettings::samplesPerPixel);
  });
  addValue(app, "--seed", "N", "another number gives another pattern of noise",
           [&options](const auto& option, const auto& text) { options.seed = parseSeed(option, text); });
  addValue(app, "--method", "volume|fibres", "what light is traced through: the volume, or every fibre as it is",
           [&options](const auto& option, const auto& text) { options.method = parseMethod(option, text); });
}

void addTraceOptions(CLI::App& app, FabricOptions& options, const std::string& samplesHelp) {
  addSampling(app, options, samplesHelp);
  addValue(app, "--light", "LIGHT",
           "ibl[:FILE], sky[:AZ,EL], directional[:AZ,EL], overcast, window, booth, dome, point, back or furnace",
           [&options](const auto& option, const auto& text) { options.light = parseLight(option, text); });
  addValue(app, "--estimator", "none|report|loomlight", "how the volume sees what is smaller than a voxel",
           [&options](const auto& option, const auto& text) { options.estimator = parseEstimator(option, text); });
  addValue(app, "--max-depth", "N", "scattering events of a path, at most",
           [&options](const auto& option, const auto& text) {
             options.maxDepth = parseWholeField(option, text, &RenderSettings::maxDepth);
           });
  addValue(app, "--event-law", "projected|report",
           "without an estimator, how a path chooses its fibre: ours, or Eq. 12 of the report",
           [&options](const auto& option, const auto& text) { options.eventLaw = parseEventLaw(option, text); });
}

void addColourway(CLI::App& app, FabricOptions& options) {
  app.add_option("--colourway", options.colourway, "the colours of the fabric that have this name")->type_name("NAME");
}

void addPictureOptions(CLI::App& app, FabricOptions& options) {
  addValue(app, "--size", "WxH", "pixels",
           [&options](const auto& option, const auto& text) { options.size = parseSize(option, text); });
  addTraceOptions(app, options, "samples per pixel");
  addValue(app, "--temperature", "K", "colour of the light: 2700 a warm lamp, 6500 as it is, 9000 a blue sky",
           [&options](const auto& option, const auto& text) {
             options.temperature_K = parseField(option, text, &Light::temperature_K);
           });
  addValue(
      app, "--illuminant", "NAME|KELVIN|FILE",
      "spectrum of white light: D65, D55, D50, A, E, F2, F7, F11, LED-B1 to LED-B5, a black body such as 2856K, or a "
      "text file of nm and power; the eye is adapted to it",
      [&options](const auto& option, const auto& text) { options.illuminant = parseIlluminant(option, text); });
  addValue(app, "--observer", "2|10", "whose eye sees the colours: the CIE observer for so many degrees",
           [&options](const auto& option, const auto& text) { options.observer = parseObserver(option, text); });
  addColourway(app, options);
  addValue(app, "--view", "NAME|AZ,EL[,MM]", viewPresetNames() + ", or angles in degrees and a distance",
           [&options](const auto& option, const auto& text) { options.view = parseView(option, text); });
}

void addThreads(CLI::App& app, int& threads, const std::string& help) {
  addValue(app, "--threads", "N", help, [&threads](const auto& option, const auto& text) {
    threads = static_cast<int>(parseWhole(option, text, 1, 1024));
  });
}

void addMemoryLimit(CLI::App& app, double& limit_bytes) {
  addValue(app, "--memory-limit", "GB",
           "what fibres may take, and the maps of a tile; three quarters of the memory where not given",
           [&limit_bytes](const auto& option, const auto& text) {
             limit_bytes = 1e9 * parseNumber(option, text, 1e-3, 1e6);
           });
}

void addFibreExtent(CLI::App& app, FibreExtent& extent) {
  addValue(
      app, "--fibres-extent", "auto|piece|repeat|bricks",
      "all fibres of the piece, or of a flat one a repeat, side by side, or those of each kind of cell once; auto: "
      "the piece where memory allows, else bricks",
      [&extent](const auto& option, const auto& text) { extent = parseFibreExtent(option, text); });
}

void addTone(CLI::App& app, Tone& tone) {
  addValue(app, "--exposure", "STOPS", "brighter or darker; only a .png has it",
           [&tone](const auto& option, const auto& text) {
             tone.exposure_stops = static_cast<float>(parseNumber(option, text, -20, 20));
           });
  addValue(
      app, "--tone", "plain|filmic",
      "of a .png; plain, for judging colour: linear up to white, which is a perfect diffuser in light of intensity "
      "1; filmic where not given: what is bright is bent to fit",
      [&tone](const auto& option, const auto& text) { tone.filmic = parseIsFilmic(option, text); });
}

void addProgress(CLI::App& app, ProgressStyle& style) {
  addValue(app, "--progress", "plain|json", "how far it is, on stderr: for people, or as lines of JSON",
           [&style](const auto& option, const auto& text) { style = parseProgress(option, text); });
}

void addWifChoices(CLI::App& app, WifChoices& choices) {
  addValue(app, "--wif-sizes", "file|keep", "sett and yarn count of a draft: as its file says, or the default's",
           [&choices](const auto& option, const auto& text) { choices.sizes = parseWifSizes(option, text); });
  addValue(app, "--wif-threads", "all|named", "threads of a draft: as many as its file states, or as its lines name",
           [&choices](const auto& option, const auto& text) { choices.threads = parseWifThreads(option, text); });
}

}  // namespace loomlight
