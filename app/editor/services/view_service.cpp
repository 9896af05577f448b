#include "app/editor/services/view_service.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/fabric/weave/turned_over.h"
#include "render/display/booth.h"
#include "render/display/changed_rect.h"

namespace loomlight {
namespace {

/// Whose visibility is to be baked: somebody looks at it, or the picture needs it. Null: nobody's.
std::shared_ptr<const Fabric> bakedFor(const ViewState& state) {
  return state.fabric && (state.visibilityShown || state.fabric->render.needsVisibility()) ? state.fabric : nullptr;
}

/// How much of a picture's width and of its height lies in its window.
glm::vec2 shareInWindow(const Frame& frame) {
  const PixelRect reach = frame.reach();
  if (reach.width == 0 || reach.height == 0) return glm::vec2(1.0f);
  return glm::vec2(frame.window.width, frame.window.height) / glm::vec2(reach.width, reach.height);
}

}  // namespace

ViewService::ViewService(DisplayDriver& driver, const std::function<void()>& wake, int threads)
    : stats_(wake),
      visibility_(wake, BvdfOptions{}, BvdfCache(BvdfCache::userFolder())),
      renderer_(wake, threads),
      picture_(driver.makeViewport()),
      insetPicture_(driver.makeViewport()),
      visibilityPicture_(driver.makeTexture()) {}

bool ViewService::take(bool showsDifference) {
  takeInset(showsDifference);
  if (auto newest = visibility_.newest(); newest && newest != shownVisibility_) {
    visibilityPicture_->upload(newest->picture);
    shownVisibility_ = std::move(newest);
  }
  std::shared_ptr<const Scene> built = renderer_.scene();
  const bool another = built != built_;
  built_ = std::move(built);
  if (another && builtAsSeen()) stats_.request(state_.fabric, state_.yarn, built_, state_.longFloat_mm);
  std::shared_ptr<const Frame> newest = renderer_.frame();
  if (!newest || newest == frame_) return false;
  upload(*newest);
  frame_ = std::move(newest);
  const bool isFine = frame_->divider == 1 && (frame_->shared || frame_->samples > 0);
  if (isFine && frame_->generation == generation_) opened_.reset();
  return true;
}

bool ViewService::isOpening() const {
  constexpr double kPatience_s = 3;
  return opened_ && secondsSince(*opened_) < kPatience_s && rivals_.none() && status().error.empty();
}

/// Of the picture what is new: while a pass comes part by part most of it stays, and crossings seldom change at all.
void ViewService::upload(const Frame& newest) {
  const int width = newest.width, height = newest.height;
  if (newest.isDivided()) {
    picture_->upload(width, height, newest.shown(), boothHits(newest));
    return;
  }
  if (!frame_ || frame_->isDivided() || frame_->width != width || frame_->height != height) {
    picture_->upload(width, height, newest.shown(), newest.hits);
    return;
  }
  const auto sameCrossing = [](const Film::Hit& a, const Film::Hit& b) {
    return a.yarn == b.yarn && a.end == b.end && a.pick == b.pick;
  };
  picture_->uploadParts(width, height, newest.shown(), newest.hits,
                        changedRect(frame_->shown(), newest.shown(), width, std::equal_to<glm::vec4>()),
                        changedRect<Film::Hit>(frame_->hits, newest.hits, width, sameCrossing));
}

void ViewService::takeInset(bool showsDifference) {
  insetFrame_ = renderer_.insetFrame();
  if (!insetFrame_) {
    insetUpload_ = nullptr;
    return;
  }
  const Difference* difference = showsDifference ? insetFrame_->difference.get() : nullptr;
  const Frame& fibres = *insetFrame_->fibres;
  const void* wanted = difference ? static_cast<const void*>(difference) : &fibres;
  if (wanted == std::exchange(insetUpload_, wanted)) return;
  insetIsDifference_ = difference != nullptr;
  if (difference)
    insetPicture_->upload(difference->width, difference->height, difference->map, {});
  else
    insetPicture_->upload(fibres.width, fibres.height, fibres.rgba, {});
}

void ViewService::follow(const ViewState& state) {
  const std::shared_ptr<const Fabric> baked = bakedFor(state);
  if (baked != bakedFor(state_) || (baked && state.yarn != state_.yarn)) visibility_.request(baked, state.yarn);
  const bool another = state.fabric != state_.fabric;
  followPicture(state);
  if (state.denoised != state_.denoised) renderer_.denoise(state.denoised);
  if (state.rest != state_.rest) renderer_.restAt(state.rest);
  if (state.booth != state_.booth) renderer_.booth(state.booth);
  if (another || state.yarn != state_.yarn || state.longFloat_mm != state_.longFloat_mm)
    stats_.request(state.fabric, state.yarn, builtAsSeen(), state.longFloat_mm);
  if (state.inset != state_.inset) renderer_.inset(state.inset);
  state_ = state;
}

PartOfTexture ViewService::picture(ImVec2 size, const Tone& tone, const SoftProof& proof,
                                   std::optional<ViewportPicture::Outline> outline) {
  if (outline && state_.back) outline->crossing.end = outline->ends - 1 - outline->crossing.end;
  const glm::vec2 share = frame_ ? shareInWindow(*frame_) : glm::vec2(1.0f);
  const auto pixels = [](float length, float part) { return static_cast<int>(std::lround(length / part)); };
  return {picture_->display(pixels(size.x, share.x), pixels(size.y, share.y), tone, proof, outline),
          ImVec2(share.x, share.y)};
}

std::shared_ptr<const Fabric> ViewService::asSeen(const std::shared_ptr<const Fabric>& fabric) const {
  if (!state_.back && !state_.flat) return fabric;
  return fabric == state_.fabric ? seen_
                                 : std::make_shared<const Fabric>(loomlight::asSeen(*fabric, state_.back, state_.flat));
}

void ViewService::followPicture(const ViewState& state) {
  // Early tables are good enough to begin with; the picture goes over to better ones as they come.
  const std::shared_ptr<const BakedVisibility> baked = visibility_.newest();
  const bool better =
      state.fabric->render.needsVisibility() && baked && (!usedVisibility_ || worthTaking(*baked, *usedVisibility_));
  const bool otherwise = state.fabric != state_.fabric || state.back != state_.back || state.flat != state_.flat;
  const bool another = otherwise || state.width != state_.width || state.height != state_.height;
  if (!another && !better) return;
  if (better) usedVisibility_ = baked;
  if (another) ++generation_;
  if (!state.back && !state.flat)
    seen_ = state.fabric;
  else if (otherwise)
    seen_ = std::make_shared<const Fabric>(loomlight::asSeen(*state.fabric, state.back, state.flat));
  renderer_.request(
      {seen_, state.width, state.height, generation_, usedVisibility_ ? usedVisibility_->tables : nullptr});
}

std::shared_ptr<const Scene> ViewService::builtAsSeen() const {
  return built_ && built_->fabric == seen_ ? built_ : nullptr;
}

bool ViewService::shows(const std::shared_ptr<const Fabric>& fabric, const ClothView& view) const {
  const auto flat = view.flat ? std::optional(view.flat->sight) : std::nullopt;
  const bool isAsked = fabric == state_.fabric && view.back == state_.back && flat == state_.flat;
  return isAsked && frame_ && frame_->width > 0 && frame_->generation == generation_ &&
         frame_->quality != PreviewQuality::sketch;
}

std::optional<Film::Hit> ViewService::hitAt(ImVec2 fraction) const {
  if (!frame_ || frame_->hits.empty()) return std::nullopt;
  const auto index = [](float along, int count) {
    return std::clamp(static_cast<int>(along * static_cast<float>(count)), 0, count - 1);
  };
  const glm::vec2 share = shareInWindow(*frame_);
  BoothPixel at{0, index(fraction.x * share.x, frame_->width), index(fraction.y * share.y, frame_->height)};
  if (frame_->isDivided()) at = boothPixel(at.x, at.y, frame_->width, frame_->height);
  Film::Hit hit = frame_->hits[static_cast<size_t>(at.y) * static_cast<size_t>(frame_->width) + at.x];
  if (hit.yarn < 0) return std::nullopt;
  if (state_.back) hit.end = turnedEnd(hit.end);
  return hit;
}

ImTextureID ViewService::insetPicture(const Tone& tone, const SoftProof& proof) {
  if (!insetFrame_) return {};
  // Colours of the difference go to the display as they are, whatever the exposure.
  const PixelRect window = insetFrame_->fibres->reach();
  return insetPicture_->display(window.width, window.height, insetIsDifference_ ? plainTone() : tone,
                                insetIsDifference_ ? SoftProof{} : proof, std::nullopt);
}

VisibilityModel ViewService::visibilityModel(int yarn) const {
  VisibilityModel model;
  const VisibilityWorker::Status status = visibility_.status();
  model.baking = status.baking;
  model.progress = status.progress;
  model.error = status.error;
  model.columns = VisibilityWorker::kPictureColumns;
  model.rows = 8 / model.columns;
  if (!shownVisibility_ || shownVisibility_->yarn != yarn) return model;
  model.picture = visibilityPicture_->id();
  model.rays = static_cast<double>(shownVisibility_->tables->rays);
  return model;
}

}  // namespace loomlight
