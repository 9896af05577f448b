#include "core/fabric/weave/turned_over.h"

#include "core/fabric/weave/weave_edit.h"
#include "core/fabric/weave/yarn_sequence.h"

namespace loomlight {

Fabric turnedOver(Fabric fabric) {
  fabric.draft.reset();
  fabric.weave = inverted(mirroredEnds(fabric.weave));
  fabric.warpSequence = reversed(fabric.warpSequence);
  return fabric;
}

}  // namespace loomlight
