#include "app/export/handover/handover.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/export/file_set.h"
#include "app/export/handover/cloth_facts.h"
#include "app/export/handover/fit_json.h"
#include "app/export/handover/gltf.h"
#include "app/export/handover/jfab.h"
#include "app/export/handover/materialx.h"
#include "app/export/handover/restricted_zip.h"
#include "app/export/handover/textures.h"
#include "app/export/handover/u3m.h"
#include "core/base/file.h"
#include "core/fabric/json/json_text.h"

namespace loomlight {
namespace {

using Json = nlohmann::ordered_json;

double percentOf(double error, const FitError& of) {
  return of.mean > 0 ? 100 * error / of.mean : 0.0;
}

std::string fitLine(const char* side, const SurfaceFit& fit) {
  const auto percent = [](const FitError& error) {
    return error.rms > 0 ? fmt::format("{:.1f} %", percentOf(error.rms, error))
                         : fmt::format("less than the measurement's noise of {:.1f} %", percentOf(error.noise, error));
  };
  const auto mean = [](const Rgb& colour) { return (colour.r + colour.g + colour.b) / 3; };
  return fmt::format(
      "{}: roughness {:.2f}, specular {:.2f}, anisotropy {:.2f}, sheen {:.3f} with roughness {:.2f}; RMS over "
      "directions {} of the mean {:.3f} ({} from afar; a matt surface {}), through it {} of {:.3f}; in even light "
      "{:.2f} of what was measured ({:.2f} from afar)",
      side, fit.surface.roughness, fit.surface.specular, fit.surface.anisotropy,
      std::max({fit.surface.sheenColour.r, fit.surface.sheenColour.g, fit.surface.sheenColour.b}),
      fit.surface.sheenRoughness, percent(fit.reflected), fit.reflected.mean, percent(fit.fromAfar), percent(fit.matt),
      percent(fit.transmitted), fit.transmitted.mean, mean(fit.evenLight), mean(fit.evenLightFromAfar));
}

std::string sidecar(const DigitalCloth& cloth, const SideTextures& front, const SideTextures& back) {
  const ListedName construction = constructionOf(cloth.fabric.weave);
  const Json json = {{"name", cloth.fabric.name},
                     {"program", "Loomlight " LOOMLIGHT_VERSION},
                     {"width_mm", cloth.width_mm()},
                     {"height_mm", cloth.height_mm()},
                     {"ends", cloth.extent.ends},
                     {"picks", cloth.extent.picks},
                     {"twist_joins", cloth.extent.twistJoins},
                     {"width_px", cloth.front.maps.tile.width},
                     {"height_px", cloth.front.maps.tile.height},
                     {"areal_mass_g_m2", cloth.measures.arealMass_g_m2},
                     {"thickness_mm", cloth.measures.thickness_mm},
                     {"construction", construction.name.empty() ? construction.type : construction.name},
                     {"back",
                      "turned over about the vertical axis: column c lies behind column width - 1 - c of the "
                      "front, rows stay"},
                     {"sides", {{"front", sideJson(cloth.front, front)}, {"back", sideJson(cloth.back, back)}}}};
  return jsonText(json, 2) + "\n";
}

std::vector<std::string> textureFiles(const SideTextures& front, const SideTextures& back) {
  std::vector<std::string> files = front.files();
  for (const std::string& file : back.files()) files.push_back(file);
  return files;
}

/// What the files beside the textures are made of.
struct Sources {
  const DigitalCloth& cloth;
  const SideTextures &front, &back;
  std::string folder, name, u3m;  ///< the last: the text of that file, which its archive holds too
  const FileSet& set;
  std::chrono::sys_seconds now;

  std::string scratch() const { return set.pathOf("scratch.png"); }
  /// Where a file will be, in messages.
  std::string path(const char* ending) const { return (std::filesystem::path(folder) / (name + ending)).string(); }
  std::string glb(ClothSide side, const char* ending) const { return glbBytes(cloth, side, scratch(), path(ending)); }
};

std::string archive(const Sources& of) {
  std::vector<ArchivedFile> packed{{of.name + ".u3m", of.u3m}};
  for (const std::string& file : textureFiles(of.front, of.back))
    packed.push_back({file, readFile(of.set.pathOf(file), std::numeric_limits<size_t>::max())});
  return restrictedZip(packed, of.now, of.path(".u3ma"));
}

/// The files beside the textures: what each is called after the name, and its bytes.
constexpr struct {
  const char* ending;
  std::string (*bytes)(const Sources&);
} kFiles[] = {{".u3m", [](const Sources& of) { return of.u3m; }},
              {".u3ma", archive},
              {".glb", [](const Sources& of) { return of.glb(ClothSide::front, ".glb"); }},
              {"_back.glb", [](const Sources& of) { return of.glb(ClothSide::back, "_back.glb"); }},
              {".mtlx", [](const Sources& of) { return materialXText(of.cloth, ClothSide::front, of.front); }},
              {"_back.mtlx", [](const Sources& of) { return materialXText(of.cloth, ClothSide::back, of.back); }},
              {".jfab", [](const Sources& of) { return jfabText(of.cloth, of.front); }},
              {".handover.json", [](const Sources& of) { return sidecar(of.cloth, of.front, of.back); }}};

}  // namespace

std::vector<std::string> handoverFiles(const std::string& name) {
  std::vector<std::string> files =
      textureFiles(namesOfTextures(name, ClothSide::front), namesOfTextures(name, ClothSide::back));
  for (const auto& file : kFiles) files.push_back(name + file.ending);
  return files;
}

std::optional<HandoverReport> writeHandover(const std::string& folder, const std::string& name,
                                            const DigitalCloth& cloth, std::chrono::sys_seconds now, const Task& task) {
  FileSet set(folder, name);
  const SideTextures front = writeTextures(set, name, cloth, ClothSide::front, task);
  const SideTextures back = writeTextures(set, name, cloth, ClothSide::back, task);
  if (task.stopped()) return std::nullopt;

  const Sources sources{cloth, front, back, folder, name, u3mText(cloth, front, back, now), set, now};
  for (const auto& file : kFiles) {
    writeFileAtomically(set.add(name + file.ending), file.bytes(sources));
    if (task.stopped()) return std::nullopt;
  }
  set.place();
  HandoverReport report;
  report.files = handoverFiles(name);
  const FitError &onto = cloth.front.fit.reflected, &ontoBack = cloth.back.fit.reflected;
  report.lines = {fitLine("front", cloth.front.fit), fitLine("back", cloth.back.fit),
                  name + ".jfab: experimental, nobody has tried it in CLO yet"};
  report.front_percent = percentOf(onto.rms, onto);
  report.back_percent = percentOf(ontoBack.rms, ontoBack);
  return report;
}

}  // namespace loomlight
