#include "core/fabric/weave/turned_over.h"

#include "core/fabric/model/thread_spacing.h"
#include "core/fabric/weave/weave_edit.h"
#include "core/fabric/weave/yarn_sequence.h"

namespace loomlight {

Fabric turnedOver(Fabric fabric) {
  fabric.draft.reset();
  fabric.weave = inverted(mirroredEnds(fabric.weave));
  fabric.warpSequence = reversed(fabric.warpSequence);
  fabric.warpSpacing = mirroredSpacing(fabric.warpSpacing);
  return fabric;
}

}  // namespace loomlight
