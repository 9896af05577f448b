#pragma once

#include <string>

#include "core/shell/drape_mesh.h"
#include "core/shell/mesh_file.h"

namespace loomlight {

/// Makes a file's triangles into something that cloth can lie on, and says in DrapeMesh::repairs what that took:
/// - triangles without texture coordinates, or without area in the world or in texture space, are left out;
/// - neighbours that are wound against each other are turned to agree with the most part of their piece;
/// - mirrored texture pieces are mirrored back; triangles folded over within a piece are left out;
/// - edges that more than two triangles share, or two that cannot agree, are left as ends of the cloth.
/// Normals are always computed (by angle, over all triangles at a position): files split them at creases, but cloth has
/// one thickness there. Texture coordinates are multiplied by `uvScale_mm`, positions centred about the origin.
/// Throws InputError, naming `file`, if nothing is left or the numbers make no cloth.
DrapeMesh repairMesh(const std::string& file, const MeshFile& mesh, double uvScale_mm);

}  // namespace loomlight
