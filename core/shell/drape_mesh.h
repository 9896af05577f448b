#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// A triangle mesh that cloth lies on: positions in mm, texture coordinates in mm of cloth (x along the weft, y along
/// the warp). Seams (one position, two texture coordinates) split vertices. Every triangle is counter-clockwise both
/// seen from the cloth's face and in texture space, so that (x, y, normal) is right-handed.
struct DrapeMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  ///< unit, smooth, pointing to the cloth's face
  std::vector<glm::vec2> uv_mm;
  std::vector<glm::uvec3> triangles;
  std::vector<std::string> repairs;  ///< what was mended or left out, in words for the user
  std::string name = "drape";        ///< in messages: the file that it is from, or the part of the fabric
};

/// The surface a fabric asks for: generated or loaded. z is up; it is centred at the origin.
/// - flat: two triangles in the xy-plane, face up.
/// - cylinder: the warp goes round an axis along x, the middle of the swatch on top; isometric; one turn at most.
/// - sphere: the exponential map about the top, so the two lines through the middle keep their length and rings about
///   it are gathered by sin(a) / a; no farther than 0.8 of the way to the opposite pole.
/// - folds: isometric; its section along the weft is a sine-generated curve (Langbein and Leopold 1966), the curve of
///   the least change of bend; its tightest bend has the radius, or less, so that there are three folds at least.
/// - cushion: the upper face; its lines through the middle keep their length.
/// - skirt: a full circle of cloth with a hole for the waist; isometric: a cone over a fluted curve.
/// So it is on straight grain; all drapes but the flat one have the warp turned by `grain_deg` from there.
/// Throws InputError for a mesh that cannot be used, naming file, place and what was expected.
DrapeMesh makeDrape(const Drape& drape);

/// Reads an OBJ, PLY or OFF file (ASCII or, for PLY, binary) with texture coordinates, which are multiplied by
/// `uvScale_mm`; positions are mm, moved so that the bounding box is centred at the origin. Repairs what can be
/// repaired and says so; throws InputError otherwise.
DrapeMesh loadDrapeMesh(const std::string& file, double uvScale_mm);

}  // namespace loomlight
