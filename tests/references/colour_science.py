#!/usr/bin/env python3
"""Prints tests/unit/colour/reference_weights.h: what an independent implementation makes of colour.

Takes the Python package colour-science (https://www.colour-science.org); 0.4.7 made the file that is kept:
python3 colour_science.py > ../unit/colour/reference_weights.h
"""

import textwrap

import colour
import numpy as np
from colour import SpectralDistribution, SpectralShape
from colour.colorimetry import tristimulus_values

ILLUMINANTS = {"D50": "D50", "D55": "D55", "D65": "D65", "A": "A", "E": "E", "F2": "FL2", "F7": "FL7", "F11": "FL11",
               "LED-B1": "LED-B1", "LED-B2": "LED-B2", "LED-B3": "LED-B3", "LED-B4": "LED-B4", "LED-B5": "LED-B5"}
OBSERVERS = {"degrees2": "CIE 1931 2 Degree Standard Observer", "degrees10": "CIE 1964 10 Degree Standard Observer"}
VISIBLE, WHOLE, BANDS = SpectralShape(360, 780, 1), SpectralShape(360, 780, 10), SpectralShape(380, 730, 10)


def weights(observer, illuminant):
    """ASTM E308 with the weights of ASTM E2022 at 10 nm, Y of white 1; 36 rows of X, Y, Z."""
    functions = colour.MSDS_CMFS[observer].copy().trim(VISIBLE)
    light = colour.SDS_ILLUMINANTS[illuminant].copy().align(VISIBLE)
    whole = tristimulus_values.tristimulus_weighting_factors_ASTME2022(
        functions, light, WHOLE, k=1 / np.sum(light.values * functions.values[:, 1]))
    rows = tristimulus_values.adjust_tristimulus_weighting_factors_ASTME308(whole, WHOLE, BANDS)
    agree(rows, observer, illuminant)
    return rows


def agree(rows, observer, illuminant):
    """The package's own way from a reflectance to XYZ is the sum with these weights."""
    random = np.random.default_rng(18)
    for _ in range(100):
        reflectance = random.random(36)
        xyz = colour.sd_to_XYZ(SpectralDistribution(dict(zip(BANDS.wavelengths, reflectance))),
                               colour.MSDS_CMFS[observer], colour.SDS_ILLUMINANTS[illuminant], method="ASTM E308")
        assert np.abs(xyz / 100 - reflectance @ rows).max() < 1e-9


def braces(values):
    numbers = ", ".join(f"{value:.7f}f".replace("-0.0000000f", "0.0f").replace("0.0000000f", "0.0f") for value in values)
    return "\n".join(textwrap.wrap("{" + numbers + "}", 108, initial_indent="      ", subsequent_indent="       "))


if __name__ == "__main__":
    print('''#pragma once

// Made by tests/references/colour_science.py; not by Loomlight.

#include <array>

#include "core/base/spectrum.h"
#include "render/colour/observer.h"

namespace loomlight {

/// Weights of X, Y and Z under an illuminant.
struct ReferenceWeights {
  const char* illuminant;
  Observer observer;
  std::array<Spectrum, 3> rows;
};

// clang-format off
inline constexpr ReferenceWeights kReferenceWeights[] = {''')
    for name, observer in OBSERVERS.items():
        for mine, theirs in ILLUMINANTS.items():
            rows = weights(observer, theirs)
            print(f'    {{"{mine}", Observer::{name}, {{{{')
            print(",\n".join(braces(rows[:, i]) for i in range(3)) + "}}},")
    print('''};
// clang-format on

}  // namespace loomlight''')
