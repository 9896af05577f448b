#pragma once

#include <cstdint>

namespace loomlight {

/// How far a frame is from the picture that its fabric asks for; later ones are better. Where frames are mixed, the
/// worse of the two. Until the picture is there something else stands in for it, so that no edit waits to be seen; none
/// of that is ever saved or measured:
///
/// | stands in                    | made by                                 | frames     | until                     |
/// |------------------------------|-----------------------------------------|------------|---------------------------|
/// | yarns made in no time        | ClothGeometry, sketched                 | sketch     | yarns are calibrated      |
/// | bricks of what is in view    | ClothVolume::sketch()                   | sketch     | all bricks are there      |
/// | bricks of another phase      | ClothVolume::build() with a PreviewSink | sketch     | likewise                  |
/// | scenes of these              | makeScene() with ScenePreviews          | sketch     | the scene is there        |
/// | fewer pixels                 | nextPass(), Frame::divider              | coarse     | the first full pass       |
/// | light of the picture before  | SharedLight::known(), after most edits  | coarse     | each pixel has a cell     |
/// | the picture before a drag    | movedView(), StandIn                    | coarse+    | replaced sample by sample |
/// | buckets of a pass            | PictureBuckets, Refinement              | coarse     | the pass is done          |
/// | patches in the clear picture | patched(), where crossings were turned  | coarse+    | the new one is as clear   |
/// | the clear picture, reframed  | reframed() to the viewport's new size   | coarse+    | likewise                  |
/// | the same in other colours    | recolour(), from PathRecords            | recoloured | the new one is as clear   |
/// | the picture before           | StandIn, where a better medium has come | young      | replaced sample by sample |
/// | borrowed visibility          | VisibilityWorker, of similar yarns      | any        | the bake has more rays    |
/// | light that repeats share     | SharedLight: Frame::shared              | coarse+    | SharedLight::kFilmAlone   |
/// | first fibres of neighbours   | FirstHits::standForAll()                | coarse     | each pixel has its own    |
/// | less noise where none shared | despeckle(), denoise(): Frame::helped   | young      | kClearSamples             |
/// | less noise, if asked for     | denoise(): Frame::denoised              | any        | switched off              |
enum class PreviewQuality : uint8_t {
  sketch,      ///< some of it was traced in what there is of a cloth that is still being built
  coarse,      ///< some of its pixels have no sample of their own
  recoloured,  ///< made from paths that were traced in other colours; it is being traced anew
  young,       ///< traced as it is shown, in so few samples that it is smoothed
  clear,       ///< of kClearSamples and more
};

/// Samples of every pixel from which on a picture needs no help.
inline constexpr int kClearSamples = 16;

}  // namespace loomlight
