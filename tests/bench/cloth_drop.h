#pragma once

#include <string>

#include "core/shell/drape_mesh.h"

namespace loomlight {

/// A square cloth that falls over a ball and hangs down round it in folds. Position-based dynamics with compliant
/// constraints (XPBD: Macklin, Mueller, Chentanez 2016) in small steps: threads that hardly stretch, easy shear, weak
/// bending, no part nearer to another than the thickness. This makes samples/folded_cloth.obj; no render waits for it.
struct ClothDrop {
  double size_mm = 60.0;  ///< side of the cloth
  int cells = 100;        ///< of the mesh, along a side; even: the motion is computed with half as many
  double ballRadius_mm = 11.0;
  glm::dvec2 offset_mm{0.8, -0.5};  ///< of the middle of the cloth from the ball's; what is centred hangs lifelessly
  double turn_deg = 20.0;           ///< of the cloth about the vertical
  double gap_mm = 1.8;              ///< kept between the middles of parts that touch: room for cloth of some thickness
  double bending = 1.0;             ///< stiffness; 1: a supple silk, whose folds are some 8 mm wide
  double seconds = 2.5;             ///< of motion, until it hangs still
};

/// Same numbers, same cloth. Texture coordinates run from 0 to size_mm.
DrapeMesh dropCloth(const ClothDrop& drop);

/// OBJ text of a mesh, positions and texture coordinates in mm.
std::string toObj(const DrapeMesh& mesh);

}  // namespace loomlight
