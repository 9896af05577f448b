#pragma once

#include <functional>
#include <string>

#include "app/cli/fabric_options.h"
#include "app/cli/inputs.h"
#include "app/cli/option_values.h"
#include "app/cli/progress.h"
#include "core/fabric/model/field_tables.h"
#include "render/colour/tone.h"
#include "render/scene/fibre_extent.h"

namespace CLI {
class App;
}

namespace loomlight {

// Options that several commands take, described to the library that reads the command line. Values are parsed by our
// own functions, so that every message names the option and says what was expected.

using Setter = std::function<void(const std::string& option, const std::string& text)>;

void addValue(CLI::App& app, const std::string& name, const std::string& value, const std::string& help,
              const Setter& set);
/// An option that may be given several times: `set` is called for each, in the order of the command line.
void addValues(CLI::App& app, const std::string& name, const std::string& value, const std::string& help,
               const Setter& set);

/// A number, or a whole one, within the bounds of a fabric's field.
template <class Object>
double parseField(const std::string& option, const std::string& text, double Object::* member) {
  const FieldInfo info = fieldInfo(member);
  return parseNumber(option, text, info.min, info.max);
}
template <class Object, class Number>
int parseWholeField(const std::string& option, const std::string& text, Number Object::* member) {
  const FieldInfo info = fieldInfo(member);
  return static_cast<int>(parseWhole(option, text, static_cast<int64_t>(info.min), static_cast<int64_t>(info.max)));
}

void addInputFile(CLI::App& app, const std::string& name, std::string& file);
/// The file of a fabric, and addWifChoices().
void addInput(CLI::App& app, const std::string& name, FabricSource& input);
/// Whether sett and yarn counts of a draft are used: most drafts have those that some program writes by default; and
/// whether threads that it only counts are.
void addWifChoices(CLI::App& app, WifChoices& choices);
void addResolution(CLI::App& app, FabricOptions& options);
void addFabricOptions(CLI::App& app, FabricOptions& options);
/// --spp, --seed and --method.
void addSampling(CLI::App& app, FabricOptions& options, const std::string& samplesHelp);
/// --spp, --seed and --method, and all other options of how light is traced, for pictures and measurements alike.
void addTraceOptions(CLI::App& app, FabricOptions& options, const std::string& samplesHelp);
void addColourway(CLI::App& app, FabricOptions& options);
void addPictureOptions(CLI::App& app, FabricOptions& options);
void addThreads(CLI::App& app, int& threads, const std::string& help = "threads; all where not given");
void addMemoryLimit(CLI::App& app, double& limit_bytes);
void addFibreExtent(CLI::App& app, FibreExtent& extent);
/// --exposure and --tone.
void addTone(CLI::App& app, Tone& tone);
void addProgress(CLI::App& app, ProgressStyle& style);

}  // namespace loomlight
