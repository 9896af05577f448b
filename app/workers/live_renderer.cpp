#include "app/workers/live_renderer.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "app/workers/despeckle.h"
#include "app/workers/mailbox.h"
#include "app/workers/pass_scheduler.h"
#include "core/base/parallel.h"
#include "render/trace/make_medium.h"
#include "render/trace/path_tracer.h"
#include "render/trace/scene.h"

namespace loomlight {
namespace {

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Samples at which the viewport goes to sleep.
constexpr uint32_t kViewportSamples = 1024;

/// A scene and what its light is traced through, which may have been made for an earlier scene of the same cloth.
struct Traceable {
  std::shared_ptr<const Scene> scene, mediumScene;
  std::shared_ptr<const Medium> medium;
};

/// Null pointers when stopped.
Traceable makeTraceable(const std::shared_ptr<const Fabric>& fabric, const Task& task, const Traceable& previous) {
  Traceable made;
  made.scene = makeScene(fabric, task, previous.scene.get());
  if (!made.scene) return {};
  if (previous.medium && sameMedium(*previous.mediumScene, *made.scene)) {
    made.mediumScene = previous.mediumScene;
    made.medium = previous.medium;
    return made;
  }
  // The tracer may hold the previous fibres until these are done.
  made.mediumScene = made.scene;
  made.medium = makeMedium(*made.scene, 0.5 * defaultMemoryLimit_bytes(), task);
  return made.medium ? made : Traceable{};
}

/// From here on pictures are shown as they are.
constexpr uint32_t kClearSamples = 16;

struct TraceRequest {
  Traceable cloth;
  ViewRequest view;
};

std::shared_ptr<const Frame> makeFrame(const Film& film, const TraceRequest& request, const PassPlan& plan,
                                       double seconds) {
  auto frame = std::make_shared<Frame>();
  frame->width = film.width();
  frame->height = film.height();
  film.toDisplayBuffer(frame->rgba);
  // One lucky path to the sun must not stand as a block in a coarse picture; it fades as samples come.
  if (plan.samples < kClearSamples)
    despeckle(frame->rgba, frame->width, frame->height, 1.5f + static_cast<float>(plan.samples));
  frame->hits.reserve(frame->rgba.size());
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) frame->hits.push_back(film.hit(x, y));
  frame->generation = request.view.generation;
  frame->samples = plan.divider == 1 ? static_cast<int>(plan.samples) : 0;
  frame->divider = plan.divider;
  frame->seconds = seconds;
  return frame;
}

}  // namespace

/// The threads and all that they share. Every shared value is either behind `mutex` or in a mailbox.
struct LiveRenderer::Workers {
  Workers(std::function<void()> wakeWindow, int threadCount)
      : wake(std::move(wakeWindow)), threads(threadCount > 0 ? threadCount : std::max(1, hardwareThreads() - 1)) {
    builder = std::jthread([this](std::stop_token stop) { buildLoop(stop); });
    tracer = std::jthread([this](std::stop_token stop) { traceLoop(stop); });
  }
  ~Workers() {
    builder.request_stop();
    tracer.request_stop();
    std::lock_guard lock(mutex);
    buildStop.request_stop();
    passStop.request_stop();
  }

  void buildLoop(std::stop_token stop);
  void build(const ViewRequest& request, std::stop_token stop);
  void traceLoop(std::stop_token stop);
  /// Passes until converged, or until something newer has arrived and this scene has been seen at least once.
  void refine(const TraceRequest& request, std::stop_token stop);
  std::stop_token beginPass(bool mayBeCancelled, std::stop_token stop);
  /// After a pass was cut short: whether to go on with the same scene, once a pause is over.
  bool goesOn(std::stop_token stop);

  std::function<void()> wake;
  int threads;

  Mailbox<ViewRequest> requests;
  Mailbox<TraceRequest> scenes;

  mutable std::mutex mutex;
  LiveStatus status;
  std::shared_ptr<const Frame> frame;
  std::stop_source buildStop, passStop;
  std::condition_variable_any resumed;
  bool buildMayBeCancelled = true;  // not twice in a row, or a steady drag would never show a new volume
  bool passMayBeCancelled = false;  // not before the scene's first pass has been shown
  bool paused = false;

  Traceable cloth;  // the builder's: the newest that could be built

  std::jthread builder, tracer;  // last: they stop before what they use is gone
};

void LiveRenderer::Workers::buildLoop(std::stop_token stop) {
  while (auto request = requests.wait(stop)) build(*request, stop);
}

void LiveRenderer::Workers::build(const ViewRequest& request, std::stop_token stop) {
  Task task;
  task.threads = threads;
  LiveStatus::Phase before;
  {
    std::lock_guard lock(mutex);
    before = status.phase;
    buildStop = std::stop_source();
    if (stop.stop_requested()) buildStop.request_stop();
    task.stop = buildStop.get_token();
    status.buildProgress = 0;
  }
  task.progress = [this](double fraction) {
    {
      std::lock_guard lock(mutex);
      status.phase = LiveStatus::Phase::voxelising;
      status.buildProgress = fraction;
    }
    wake();
  };
  const auto start = Clock::now();
  Traceable built;
  std::string error;
  try {
    built = makeTraceable(request.fabric, task, cloth);
  } catch (const std::exception& e) {
    error = e.what();
  }
  {
    std::lock_guard lock(mutex);
    status.buildProgress = 1;
    status.error = error;
    if (!built.scene && status.phase == LiveStatus::Phase::voxelising) status.phase = before;  // the old picture's
    buildMayBeCancelled = built.scene || !error.empty();
    if (built.scene) {
      status.builtGeneration = request.generation;
      if (!cloth.scene || built.scene->volume != cloth.scene->volume) {
        status.counts = built.scene->volume->counts();
        status.measures = built.scene->volume->geometry().measure();
        status.buildSeconds = secondsSince(start);
      }
      status.notices = built.scene->shell->repairs();
    }
  }
  if (built.scene) {
    cloth = built;
    scenes.post({built, request});
    // Only now: a pass stopped before the scene can be seen waiting would go on with the old one until it converges.
    std::lock_guard lock(mutex);
    if (passMayBeCancelled) passStop.request_stop();
    resumed.notify_all();
  }
  wake();
}

std::stop_token LiveRenderer::Workers::beginPass(bool mayBeCancelled, std::stop_token stop) {
  std::lock_guard lock(mutex);
  passStop = std::stop_source();
  passMayBeCancelled = mayBeCancelled;
  if (stop.stop_requested() || (mayBeCancelled && (paused || scenes.waiting()))) passStop.request_stop();
  return passStop.get_token();
}

bool LiveRenderer::Workers::goesOn(std::stop_token stop) {
  std::unique_lock lock(mutex);
  resumed.wait(lock, stop, [this] { return !paused || scenes.waiting(); });
  return !stop.stop_requested() && !scenes.waiting();
}

void LiveRenderer::Workers::traceLoop(std::stop_token stop) {
  while (auto request = scenes.wait(stop)) {
    {
      std::lock_guard lock(mutex);
      status.phase = LiveStatus::Phase::tracing;
    }
    try {
      refine(*request, stop);
    } catch (const std::exception& e) {  // a picture too large for the memory, say: the window goes on without
      std::lock_guard lock(mutex);
      status.phase = LiveStatus::Phase::idle;
      status.error = e.what();
    }
  }
}

void LiveRenderer::Workers::refine(const TraceRequest& request, std::stop_token stop) {
  const int width = request.view.width, height = request.view.height;
  if (width <= 0 || height <= 0) return;
  const auto start = Clock::now();
  PassHistory history{width, height};
  {
    std::lock_guard lock(mutex);
    if (status.pathsPerSecond > 0) history.secondsPerPath = 1.0 / status.pathsPerSecond;
  }
  const Scene& scene = *request.cloth.scene;
  std::optional<Film> film;
  while (!stop.stop_requested()) {
    history.seconds = secondsSince(start);
    const PassPlan plan = nextPass(history, kViewportSamples);
    if (plan.samples == 0) break;
    if (!film || plan.divider != history.divider)
      film.emplace((width + plan.divider - 1) / plan.divider, (height + plan.divider - 1) / plan.divider);
    const CameraRays camera(scene.fabric->camera, film->width(), film->height());
    Task task;
    task.threads = threads;
    task.stop = beginPass(history.divider != 0, stop);
    const auto passStart = Clock::now();
    const PassResult result = renderUpTo(plan.samples, scene, *request.cloth.medium, camera, *film, task);
    if (!result.complete) {
      if (!goesOn(stop)) return;
      continue;  // the film knows which samples it has
    }
    history.secondsPerPath = secondsSince(passStart) / static_cast<double>(std::max<uint64_t>(1, result.counts.paths));
    history.divider = plan.divider;
    if (plan.divider == 1) history.samples = plan.samples;
    auto picture = makeFrame(*film, request, plan, secondsSince(start));
    {
      std::lock_guard lock(mutex);
      frame = std::move(picture);
      status.phase = LiveStatus::Phase::tracing;
      status.pathsPerSecond = 1.0 / history.secondsPerPath;
    }
    wake();
  }
  {
    std::lock_guard lock(mutex);
    status.phase = LiveStatus::Phase::converged;
  }
  wake();
}

LiveRenderer::LiveRenderer(std::function<void()> wake, int threads)
    : workers_(std::make_unique<Workers>(std::move(wake), threads)) {}
LiveRenderer::~LiveRenderer() = default;

void LiveRenderer::request(ViewRequest request) {
  {
    std::lock_guard lock(workers_->mutex);
    if (workers_->buildMayBeCancelled) {
      workers_->buildMayBeCancelled = false;
      workers_->buildStop.request_stop();
    }
  }
  workers_->requests.post(std::move(request));
}

std::shared_ptr<const Frame> LiveRenderer::frame() const {
  std::lock_guard lock(workers_->mutex);
  return workers_->frame;
}

LiveStatus LiveRenderer::status() const {
  std::lock_guard lock(workers_->mutex);
  return workers_->status;
}

void LiveRenderer::pause(bool paused) {
  std::lock_guard lock(workers_->mutex);
  workers_->paused = paused;
  if (paused && workers_->passMayBeCancelled) workers_->passStop.request_stop();
  workers_->resumed.notify_all();
}

}  // namespace loomlight
