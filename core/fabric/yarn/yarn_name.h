#pragma once

#include <string>

#include "core/fabric/model/fabric.h"
#include "core/fabric/model/yarn_count.h"

namespace loomlight {

/// A yarn's count as spinners write it: "19.7 tex", "16.7 tex x 2", "30/2 Ne", "2/60 Nm", of a cable "20/2/3 Ne".
std::string writtenCount(const Yarn& yarn, const Fibre& fibre, CountSystem system);

/// What a yarn is called: the name that somebody gave it, or where that is empty its colour and its count ("navy 2/60
/// Nm"), which follow what the yarn becomes. `colour`: that the cloth reaches with it, as it is called
/// (coloursForNames()), linear.
std::string yarnName(const Fabric& fabric, int index, const Rgb& colour, CountSystem system = CountSystem::tex);

/// The letter that stands for a yarn in an order of threads: "A" for yarn 0, "Z" for 25, "AA" for 26.
std::string yarnLetters(int index);

}  // namespace loomlight
