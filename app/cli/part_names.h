#pragma once

#include <string>

#include "core/fabric/yarn/cloth_part.h"

namespace loomlight {

/// Which parts of a cloth a name may mean: those that are dyed alone are fibres, those that are looked at yarns too.
enum class NamedParts { fibres, yarnsAndFibres };

/// The part of that name: a fibre's or a yarn's, or its number from 1, which of a yarn is written "yarn 2"; or "piece"
/// for all. Names come first: a fibre may be called "2", or "piece". Throws InputError, starting with `source`, for a
/// name that nothing has, or several have.
ClothPart partNamed(const std::string& name, const Fabric& fabric, NamedParts parts, const std::string& source);

/// As people are told of it: "yarn 2 'navy'", "fibre 1 'wool'", "the piece".
std::string partText(const ClothPart& part, const Fabric& fabric);

}  // namespace loomlight
