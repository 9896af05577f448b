#include "app/live/pass_scheduler.h"

#include <algorithm>

// How it works. The first pass after an edit is as coarse as it must be to be there within a frame or two; each pass
// after it is twice as fine, until pixels are whole. Where the first whole ones would wait for fibres to be laid, the
// last coarse pass goes on until it has had two paths for each of them. From then on a pass takes a quarter of the time
// spent so far, within limits, so that a picture that has long been good is not interrupted often. Of a picture and an
// inset, the coarser one is traced next, and else the one that has had less time.
namespace loomlight {
namespace {

constexpr double kFirstPictureSeconds = 0.025;  // with all else, a frame or two of a film
constexpr double kUsualSecondsPerPath = 1e-5;   // of cloth that fills the picture, on two cores
constexpr double kShortestPassSeconds = 0.1;
constexpr double kLongestPassSeconds = 1.0;

double pathsAt(const PassHistory& h, int divider) {
  const int columns = (h.width + divider - 1) / divider, rows = (h.height + divider - 1) / divider;
  return static_cast<double>(columns) * rows;
}

int firstDivider(const PassHistory& h) {
  const double secondsPerPath = h.secondsPerPath > 0 ? h.secondsPerPath : kUsualSecondsPerPath;
  int divider = 1;
  const auto takesLongerThan = [&](double seconds) { return pathsAt(h, divider) * secondsPerPath > seconds; };
  while (divider < h.first.coarsest && takesLongerThan(kFirstPictureSeconds)) ++divider;
  while (divider < FirstPass::kCoarsest && takesLongerThan(h.first.patience_s)) ++divider;
  if (divider > 1) divider = (divider + h.first.finer - 1) / h.first.finer * h.first.finer;
  return divider;
}

}  // namespace

double passBudget_s(const PassHistory& h) {
  return std::clamp(h.seconds / 4, kShortestPassSeconds, kLongestPassSeconds);
}

PassPlan nextPass(const PassHistory& h, uint32_t samplesWanted) {
  if (h.divider == 0) {
    const int divider = firstDivider(h);
    return {divider, 1};
  }
  // What repeats share learns as much of a coarse path, which meets no fibres that would have to be laid first.
  constexpr double kBeforeFibres = 2;  // paths for each pixel at full resolution
  const bool isNextFine = h.divider == 2 || h.divider == 3;
  if (h.waitsForFibres && isNextFine && h.coarseSamples * pathsAt(h, h.divider) < kBeforeFibres * pathsAt(h, 1))
    return {h.divider, h.coarseSamples + 1};
  // Half the divider at a time, so that no step leaps to the eye: together they cost a third of the first fine one.
  if (h.divider > 1) return {h.divider / 2, 1};
  if (h.samples >= samplesWanted) return {1, 0};
  const double perSample = std::max(1e-9, pathsAt(h, 1) * h.secondsPerPath);
  const auto more = static_cast<uint32_t>(std::clamp(passBudget_s(h) / perSample, 1.0, 64.0));
  return {1, std::min(samplesWanted, h.samples + more)};
}

uint32_t hitsWanted(const PassHistory& h) {
  if (h.divider == 0) return 0;  // nothing would be seen sooner than the first coarse pass
  if (h.samples > 0) return h.samples == 1 ? 8 : 16;
  // Of a third of the resolution cells have heard little yet: what comes next is not to wait. As they hear more of
  // coarse paths, pixels of few first fibres would be what one sees of noise.
  constexpr uint32_t kPasses = 3;  // to one round of first fibres, which takes about as long
  return (h.divider > 2 ? 1 : 4) + h.coarseSamples / kPasses;
}

Subject nextSubject(const Contender& picture, const Contender& inset) {
  if (!picture.wants) return inset.wants ? Subject::inset : Subject::none;
  if (!inset.wants) return Subject::picture;
  if (picture.divider == 0) return Subject::picture;
  if (inset.divider == 0) return Subject::inset;
  if (picture.divider == 1 && inset.divider > 1) return Subject::inset;
  if (inset.divider == 1 && picture.divider > 1) return Subject::picture;
  return inset.spent_s < picture.spent_s ? Subject::inset : Subject::picture;
}

}  // namespace loomlight
