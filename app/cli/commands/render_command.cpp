#include "app/cli/commands/render_command.h"

#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <new>

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

/// Throws UsageError where one picture would be written over another.
void expectDistinct(const std::vector<RenderOrder>& jobs) {
  std::map<std::string, const RenderOrder*> taken;
  for (const RenderOrder& job : jobs) {
    const auto [other, isNew] = taken.try_emplace(job.output, &job);
    if (isNew) continue;
    const std::string& before = other->second->input;
    throw UsageError(
        before == job.input
            ? fmt::format("--output: expected #### in '{}', where the number of the frame goes", job.output)
            : fmt::format("--output: expected {{}} for the names of fabrics, so that {} and {} are not "
                          "both '{}'",
                          before, job.input, job.output));
  }
}

void tellBegun(const RenderCommand& command, const std::vector<RenderOrder>& jobs, size_t i) {
  if (command.progress == ProgressStyle::plain) {
    fmt::print(stderr, "loomlight: picture {} of {}: {}\n", i + 1, jobs.size(), jobs[i].output);
    return;
  }
  fmt::print(stderr, "{{\"stage\":\"picture\",\"number\":{},\"of\":{}}}\n", i + 1, jobs.size());
}

/// Renders one of several pictures. False where it failed, which is told.
bool tried(const RenderCommand& command, const RenderOrder& job, const Interrupt& interrupt, ReusableCloth& built,
           int& status) {
  try {
    status = renderPicture(command, job, interrupt, built);
    return true;
  } catch (const InputError& error) {
    fmt::print(stderr, "loomlight: {}\n", error.what());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "loomlight: {}: there is not enough memory for this\n", job.input);
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
    if (!tried(command, jobs[i], interrupt, built, status)) failed.push_back(jobs[i].output);
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
  const std::vector<RenderOrder> jobs = jobsOf(command);
  expectDistinct(jobs);
  const Interrupt interrupt;
  ReusableCloth built;
  return jobs.size() == 1 ? renderPicture(command, jobs.front(), interrupt, built)
                          : renderAll(command, jobs, interrupt);
}

}  // namespace loomlight
