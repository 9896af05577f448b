#include "app/live/live_renderer.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <variant>

#include "app/live/fibre_layer.h"
#include "app/live/recent_cloths.h"
#include "app/live/worker.h"
#include "core/base/memory.h"
#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "render/bvdf/bake/bvdf_baker.h"
#include "render/media/report_medium.h"
#include "render/transport/make_medium.h"

// How it works. request() replaces the request before and stops its build, but never two builds in a row, or a steady
// drag would show none. The builder makes a scene and a medium from the nearest of the recent cloths, showing first
// looks on the way where the whole takes long, and hands them to the tracer. Counts and measures follow when no newer
// request waits.

namespace loomlight {
namespace {

/// What cloths that are out of date may take: a sixteenth of the memory, a gigabyte at most.
size_t recentBytes() {
  return static_cast<size_t>(std::min<uint64_t>(uint64_t{1} << 30, physicalMemory_bytes() / 16));
}

/// Tables that a fabric of as many yarns can be shown with until its own are baked.
bool serves(const std::shared_ptr<const BvdfSet>& set, const Fabric& fabric) {
  return set && set->tableOfYarn.size() == fabric.yarns.size();
}

std::shared_ptr<const Medium> makeLiveMedium(const Scene& scene, const std::shared_ptr<const BvdfSet>& visibility,
                                             const Task& task) {
  // The tracer may hold the previous fibres until these are done.
  if (!scene.fabric->render.needsVisibility()) return makeMedium(scene, 0.5 * defaultMemoryLimit_bytes(), task);
  return std::make_shared<const ReportMedium>(
      scene.cloth, serves(visibility, *scene.fabric) ? visibility : expectedBvdf(scene, BvdfResolution{}));
}

/// Null pointers when stopped.
BuiltCloth makeCloth(const ViewRequest& request, const Task& task, const RecentCloths::Base& base,
                     const ScenePreviews* first) {
  const Traceable& old = base.cloth.traceable;
  BuiltCloth made;
  made.visibility = request.visibility;
  Traceable& cloth = made.traceable;
  cloth.scene = makeScene(request.fabric, task, SceneBase{old.scene.get(), base.edit}, first);
  if (!cloth.scene) return {};
  const bool sameTables = !request.fabric->render.needsVisibility() || made.visibility == base.cloth.visibility;
  const bool serves = old.medium && sameTables && old.scene->cloth == cloth.scene->cloth;
  cloth.medium = serves ? old.medium : makeLiveMedium(*cloth.scene, made.visibility, task);
  return cloth.medium ? made : BuiltCloth{};
}

}  // namespace

/// The threads and all that they share. Every shared value is behind `mutex`.
struct LiveRenderer::Workers {
  Workers(std::function<void()> wakeWindow, int threadCount)
      : wake(std::move(wakeWindow)),
        threads(threadCount > 0 ? threadCount : hardwareThreads()),
        tracer(wake, threads),
        layer(
            wake, [this](Traceable laid) { tracer.fibres(std::move(laid)); }, threads),
        builder(
            {},
            [this](const ViewRequest& request, auto& job) {
              build(request, job);
              return std::nullopt;
            },
            [this](const ViewRequest&, const std::string& problem) {
              tell(problem);
              return std::monostate{};
            },
            Backlog::newest, Priority::picture) {}

  using Builder = Worker<ViewRequest, std::monostate>;  // what it makes goes to the tracer and into `status`
  using Clock = std::chrono::steady_clock;
  void build(const ViewRequest& request, Builder::Job& job);
  void setBuilding(bool so);
  void tellProgress(double fraction, Clock::time_point& told);
  void tellBuilt(const ViewRequest& request, const std::shared_ptr<const Scene>& made, const Scene* before,
                 const std::string& error, double seconds);
  void showSketch(const ViewRequest& request, std::shared_ptr<const Scene> first, const Task& task, Builder::Job& job);
  void tell(const std::string& problem);
  void count();
  void layFibres();
  InsetStatus insetStatus(const Tracer::State& traced) const;  ///< with the mutex held

  std::function<void()> wake;
  int threads;

  /// The window and the builder both have fibres laid: what was decided last is asked for last. Locked before `mutex`,
  /// and for longer, as a scene may die meanwhile.
  std::mutex laying;
  mutable std::mutex mutex;
  LiveStatus status;  ///< the builder's part of it
  bool building = false;
  bool buildMayBeCancelled = true;  // not twice in a row, or a steady drag would never show a new volume
  std::optional<InsetRequest> inset;
  std::shared_ptr<const Scene> scene;  // the newest that could be built; only the builder changes it
  std::shared_ptr<const Scene> woven;  // the newest whose yarns are final, though bricks of it may still be missing

  // The builder's:
  RecentCloths recent{recentBytes()};
  std::shared_ptr<const ClothVolume> counted;  // what `status` has the counts of

  Tracer tracer;
  FibreLayer layer;
  Builder builder;  // last: it ends before what it uses is gone
};

void LiveRenderer::Workers::tell(const std::string& problem) {
  {
    std::lock_guard lock(mutex);
    building = false;
    buildMayBeCancelled = true;
    status.error = problem;
  }
  wake();
}

void LiveRenderer::Workers::build(const ViewRequest& request, Builder::Job& job) {
  if (builder.isWaiting()) return;  // it came before this one could be stopped
  const auto start = Clock::now();
  auto told = start;
  const Task task{job.stop(), [this, &told](double fraction) { tellProgress(fraction, told); }, threads};
  // A sketch is worth a picture of its own where the whole takes longer than a picture does.
  constexpr double kWorthWaiting_s = 0.05;
  const ScenePreviews first{
      static_cast<double>(request.width) / std::max(1, request.height),
      [start](double fraction) { return secondsSince(start) * (1 / fraction - 1) > kWorthWaiting_s; },
      [&](std::shared_ptr<const Scene> sketch) { showSketch(request, std::move(sketch), task, job); }};
  const bool showsVolume = request.fabric->render.method == Method::volume;
  const RecentCloths::Base base = recent.baseFor(*request.fabric);
  BuiltCloth built;
  std::string error;
  try {
    built = makeCloth(request, task, base, showsVolume ? &first : nullptr);
  } catch (const std::exception&) {
    error = problemCaught();
  }
  const Traceable& made = built.traceable;
  tellBuilt(request, made.scene, base.cloth.traceable.scene.get(), error, secondsSince(start));
  if (made.scene) {
    tracer.show({made, request.width, request.height, request.generation});
    layFibres();
  }
  setBuilding(false);  // only now, lest a sketch that is finished pass for a picture that is
  wake();
  if (made.scene) recent.keep(std::move(built));
  count();
}

void LiveRenderer::Workers::setBuilding(bool so) {
  std::lock_guard lock(mutex);
  building = so;
}

/// Says how far a build is, now and then: a quick one says nothing. `told`: when that was last.
void LiveRenderer::Workers::tellProgress(double fraction, Clock::time_point& told) {
  constexpr std::chrono::milliseconds kTelling{120};
  {
    std::lock_guard lock(mutex);
    const auto now = Clock::now();
    if (now - told < kTelling) return;
    told = now;
    building = true;
    status.buildProgress = fraction;
  }
  wake();
}

/// Says what has become of a build; `made` is null where it failed or was stopped, `before` where nothing served it.
void LiveRenderer::Workers::tellBuilt(const ViewRequest& request, const std::shared_ptr<const Scene>& made,
                                      const Scene* before, const std::string& error, double seconds) {
  std::lock_guard lock(mutex);
  status.buildProgress = 1;
  status.error = error;
  buildMayBeCancelled = made || !error.empty();
  if (!error.empty()) woven = scene;  // not its sketch, which lacks bricks
  if (!made) return;
  status.builtGeneration = request.generation;
  if (!before || made->cloth->volume != before->cloth->volume) {
    status.bricksVoxelised += made->cloth->volume->bricksVoxelised();
    status.buildSeconds = seconds;
  }
  status.notices = made->cloth->shell->repairs();
  scene = woven = made;
}

/// Has a picture traced of what is there of a cloth. From then on its builder may be stopped: a drag moves the picture.
void LiveRenderer::Workers::showSketch(const ViewRequest& request, std::shared_ptr<const Scene> first, const Task& task,
                                       Builder::Job& job) {
  Traceable sketch{first, makeLiveMedium(*first, request.visibility, task)};
  if (!sketch.medium) return;
  setBuilding(true);
  tracer.show({std::move(sketch), request.width, request.height, request.generation, true});
  std::lock_guard lock(mutex);
  if (!first->cloth->volume->geometry().isSketched()) woven = std::move(first);
  if (builder.isWaiting()) job.giveWay();
  buildMayBeCancelled = true;
}

/// Counts and measures the newest volume, unless there is more urgent work.
void LiveRenderer::Workers::count() {
  if (builder.isWaiting() || !scene || scene->cloth->volume == counted) return;
  counted = scene->cloth->volume;
  const VolumeCounts counts = counted->counts();
  const ClothMeasures measures = counted->measure();
  {
    std::lock_guard lock(mutex);
    status.counts = counts;
    status.measures = measures;
  }
  wake();
}

/// Has fibres laid for the newest scene if the inset is open and has a use for them.
void LiveRenderer::Workers::layFibres() {
  std::lock_guard order(laying);
  std::shared_ptr<const Scene> newest;
  double limit_bytes = 0;
  {
    std::lock_guard lock(mutex);
    if (inset && scene && scene->fabric->render.method == Method::volume) {
      newest = scene;
      limit_bytes = inset->memoryLimit_bytes;
    }
  }
  if (newest) {
    layer.lay(std::move(newest), limit_bytes);
  } else {
    layer.clear();
  }
}

InsetStatus LiveRenderer::Workers::insetStatus(const Tracer::State& traced) const {
  using Phase = InsetStatus::Phase;
  InsetStatus result;
  if (!inset) return result;
  const FibreLayer::Status laid = layer.status();
  result.progress = laid.progress;
  result.segments = laid.size.segments;
  result.bytes = laid.size.bytes;
  result.isWholePiece = laid.size.isWholePiece();
  result.error = laid.error;
  if (scene && scene->fabric->render.method == Method::fibres) {
    result.phase = Phase::needless;
    return result;
  }
  switch (laid.phase) {
    case FibreLayer::Status::Phase::none:
      result.phase = Phase::waiting;
      break;
    case FibreLayer::Status::Phase::laying:
      result.phase = Phase::laying;
      break;
    case FibreLayer::Status::Phase::laid:
      result.phase = traced.inset == Tracer::State::Phase::converged ? Phase::converged : Phase::tracing;
      break;
    case FibreLayer::Status::Phase::tooLarge:
      result.phase = Phase::tooLarge;
      break;
    case FibreLayer::Status::Phase::failed:
      result.phase = Phase::failed;
      break;
  }
  return result;
}

LiveRenderer::LiveRenderer(std::function<void()> wake, int threads)
    : workers_(std::make_unique<Workers>(std::move(wake), threads)) {}
LiveRenderer::~LiveRenderer() = default;

void LiveRenderer::request(ViewRequest request) {
  // In one step, as the builder looks whether a request waits before it lets itself be cancelled.
  std::lock_guard lock(workers_->mutex);
  if (workers_->buildMayBeCancelled) {
    workers_->buildMayBeCancelled = false;
    workers_->builder.cancel();
  }
  workers_->builder.ask(std::move(request));
}

void LiveRenderer::inset(std::optional<InsetRequest> request) {
  {
    std::lock_guard lock(workers_->mutex);
    workers_->inset = request;
  }
  workers_->tracer.inset(request ? std::optional(request->window) : std::nullopt);
  workers_->layFibres();
}

std::shared_ptr<const Frame> LiveRenderer::frame() const {
  return workers_->tracer.frame();
}

std::shared_ptr<const InsetFrame> LiveRenderer::insetFrame() const {
  return workers_->tracer.insetFrame();
}

std::shared_ptr<const Scene> LiveRenderer::scene() const {
  std::lock_guard lock(workers_->mutex);
  return workers_->woven;
}

LiveStatus LiveRenderer::status() const {
  const Tracer::State traced = workers_->tracer.state();
  std::lock_guard lock(workers_->mutex);
  LiveStatus status = workers_->status;
  if (status.error.empty()) status.error = traced.error;
  static constexpr LiveStatus::Phase kPhases[] = {LiveStatus::Phase::idle, LiveStatus::Phase::tracing,
                                                  LiveStatus::Phase::converged};
  status.phase = workers_->building ? LiveStatus::Phase::voxelising : kPhases[static_cast<int>(traced.picture)];
  status.inset = workers_->insetStatus(traced);
  return status;
}

void LiveRenderer::denoise(bool wanted) {
  workers_->tracer.denoise(wanted);
}

void LiveRenderer::restAt(uint32_t samples) {
  workers_->tracer.restAt(samples);
}

void LiveRenderer::booth(bool wanted) {
  workers_->tracer.booth(wanted);
}

void LiveRenderer::shareLight(bool wanted) {
  workers_->tracer.shareLight(wanted);
}

void LiveRenderer::pause(bool paused) {
  workers_->tracer.pause(paused);
}

}  // namespace loomlight
