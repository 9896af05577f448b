#pragma once

#include <string>

#include "core/fabric/model/fabric.h"

namespace loomlight {

/// What one more fibre is called that is like one of that name: that, or with a number, so that no two fibres of the
/// fabric are called alike.
std::string fibreNameFor(const Fabric& fabric, const std::string& like);

/// What is left of a fibre's name when its colour goes: "polyester" of "polyester, ultramarine", and of "polyester 2".
std::string kindName(const std::string& fibreName);

/// One more fibre, of the colour of the fibre numbered `like` in every colourway that has one for that. Returns its
/// number.
int addFibre(Fabric& fabric, Fibre fibre, int like);

/// Whether an end or a pick of the fabric is of that yarn.
bool isWoven(const Fabric& fabric, int yarn);

/// The fabric with its yarn of that index like `yarn`, spun of `fibre`: that takes the place of the old one's fibre, or
/// is added where other yarns are spun of it too. A blend ends; the name stays.
Fabric withYarn(Fabric fabric, int index, Yarn yarn, Fibre fibre);

/// The fabric with one more yarn, a copy of that one. A new yarn is wanted for a new colour more often than not, so it
/// gets a fibre of its own where there is room for one; its name is not that of the old one, which it is not.
Fabric withYarnCopied(Fabric fabric, int index);

/// The fabric without a yarn that no end or pick uses, and without the fibres that were spun for it alone, in no
/// colourway either.
Fabric withoutYarn(Fabric fabric, int index);

/// The fabric with another fibre in the place of that yarn's first, or added where other yarns are spun of it too;
/// where there is no room for one more, those change with it.
Fabric withFibre(Fabric fabric, int yarn, Fibre fibre);

/// The yarn as thick everywhere as it is on average; the fabric with all of its yarns so, in an even sett. For what
/// stands for the whole cloth, and is too small to have some of each thick and thin place.
Yarn evenlySpun(Yarn yarn);
Fabric evenlySpun(Fabric fabric);

}  // namespace loomlight
