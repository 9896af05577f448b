#include "app/cli/commands/render_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cli/commands/render_picture.h"
#include "app/cli/usage_error.h"
#include "core/base/error.h"

namespace loomlight {
namespace {

/// The pictures of a command: each fabric, in each frame that is wanted.
std::vector<RenderOrder> jobsOf(const RenderCommand& command) {
  std::vector<std::string> inputs = command.inputs;
  if (!command.list.empty())
    for (std::string& name : namesInList(command.list)) inputs.push_back(std::move(name));
  if (inputs.empty()) inputs.emplace_back();  // that of the picture to go on with

  std::vector<std::optional<int>> frames{std::nullopt};
  if (command.turn) {
    const FrameRange range = command.frames.value_or(FrameRange{1, command.turn->frames});
    frames.clear();
    for (int frame = range.first; frame <= range.last; ++frame) frames.emplace_back(frame);
  }
  std::vector<RenderOrder> jobs;
  for (const std::string& input : inputs)
    for (const std::optional<int>& frame : frames)
      jobs.push_back(
          {input, nameInSeries(command.output, input, frame), nameInSeries(command.stats, input, frame), frame});
  return jobs;
}

/// Throws UsageError where two pictures would be written to one file, or the figures of two (`file`, named by
/// `option`).
void expectDistinct(const std::vector<RenderOrder>& jobs, const char* option, std::string RenderOrder::* file) {
  std::map<std::string, const RenderOrder*> taken;
  for (const RenderOrder& job : jobs) {
    const std::string& name = job.*file;
    if (name.empty()) continue;
    const auto [other, isNew] = taken.try_emplace(name, &job);
    if (isNew) continue;
    const std::string& before = other->second->input;
    throw UsageError(
        before == job.input
            ? fmt::format("{}: expected #### in '{}', where the number of the frame goes", option, name)
            : fmt::format("{}: expected {{}} for the names of fabrics, so that {} and {} are not both '{}'", option,
                          before, job.input, name));
  }
}

/// Throws UsageError where the options contradict one another, whatever the fabrics are: nothing is rendered then. What
/// only some fabrics contradict is found out as each is rendered.
void expectTogether(const RenderCommand& command) {
  const FabricOptions& options = command.options;
  const PartChoice& part = command.part;
  if (!command.stats.empty() && command.stats == command.output)
    throw UsageError(fmt::format("--stats: expected another file than the picture's, '{}'", command.output));
  if (command.turn && options.light) expectTurnable(*command.turn, options.light->kind);
  if (options.size && part.crop) expectWindowIn(options.size->width, options.size->height, *part.crop);
  if (options.samplesPerPixel)
    expectSamplesAmong(*options.samplesPerPixel, part.firstSample.value_or(0), part.samples.value_or(0));
}

void tellBegun(const RenderCommand& command, const std::vector<RenderOrder>& jobs, size_t i) {
  if (command.progress == ProgressStyle::plain) {
    fmt::print(stderr, "loomlight: picture {} of {}: {}\n", i + 1, jobs.size(), jobs[i].output);
    return;
  }
  tellJson({{"stage", "picture"}, {"number", i + 1}, {"of", jobs.size()}, {"output", jobs[i].output}});
}

void tellFailed(const RenderCommand& command, const RenderOrder& job, const std::string& why) {
  if (command.progress == ProgressStyle::plain)
    fmt::print(stderr, "loomlight: {}\n", why);
  else
    tellJson({{"stage", "failed"}, {"output", job.output}, {"error", why}});
}

bool areOfOneFabric(const std::vector<RenderOrder>& jobs) {
  return std::all_of(jobs.begin(), jobs.end(), [&](const RenderOrder& job) { return job.input == jobs[0].input; });
}

/// Renders one of several pictures. False where it failed, which is told. An option that does not fit this fabric may
/// fit the others; throws UsageError where there are none.
bool tried(const RenderCommand& command, const std::vector<RenderOrder>& jobs, size_t i, const Interrupt& interrupt,
           ReusableCloth& built, int& status) {
  const RenderOrder& job = jobs[i];
  try {
    status = renderPicture(command, job, interrupt, built);
    return true;
  } catch (const InputError& error) {
    tellFailed(command, job, error.what());
  } catch (const UsageError& error) {
    if (areOfOneFabric(jobs)) throw;
    tellFailed(command, job, fmt::format("{}: {}", job.input, error.what()));
  } catch (const std::bad_alloc&) {
    tellFailed(command, job, job.input + ": there is not enough memory for this");
  } catch (const std::exception& error) {
    tellFailed(command, job, fmt::format("{}: {}", job.input, error.what()));
  }
  built = {};
  return false;
}

int renderAll(const RenderCommand& command, const std::vector<RenderOrder>& jobs, const Interrupt& interrupt) {
  ReusableCloth built;
  std::vector<std::string> failed;
  for (size_t i = 0; i < jobs.size(); ++i) {
    tellBegun(command, jobs, i);
    if (i > 0 && jobs[i].input != jobs[i - 1].input) built = {};
    int status = 0;
    if (!tried(command, jobs, i, interrupt, built, status)) failed.push_back(jobs[i].output);
    if (status == 0) continue;
    fmt::print("stopped in picture {} of {}, {} failed\n", i + 1, jobs.size(), failed.size());
    return status;
  }
  fmt::print("{} of {} pictures rendered\n", jobs.size() - failed.size(), jobs.size());
  for (const std::string& output : failed) fmt::print("failed: {}\n", output);
  return failed.empty() ? 0 : 1;
}

}  // namespace

int run(const RenderCommand& command) {
  expectTogether(command);
  const std::vector<RenderOrder> jobs = jobsOf(command);
  expectDistinct(jobs, "--output", &RenderOrder::output);
  expectDistinct(jobs, "--stats", &RenderOrder::stats);
  const Interrupt interrupt;
  ReusableCloth built;
  return jobs.size() == 1 ? renderPicture(command, jobs.front(), interrupt, built)
                          : renderAll(command, jobs, interrupt);
}

}  // namespace loomlight
