#!/usr/bin/env python3
"""Prints the rows of tests/unit/colour/daylight_spectrum_test.cpp: daylight of the CIE, as light of the sky is made of it.

A row is the temperature of a daylight in K, its linear colour (Rec. 709, D65 is white), and its power over that of D65 at
380, 430, ... 730 nm; colour and power are of luminance 1. The colour is that of the bands from 380 to 730 nm by ASTM E308.
Takes the Python package colour-science; 0.4.7 made the rows that are kept: python3 colour_daylight.py
"""

import colour
import numpy as np
from colour import SpectralDistribution, SpectralShape
from colour.colorimetry import sd_CIE_illuminant_D_series, sd_to_XYZ
from colour.temperature import CCT_to_xy_CIE_D

OBSERVER = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
D65 = colour.SDS_ILLUMINANTS["D65"]
BANDS = SpectralShape(380, 730, 10)


def xyz(relative):
    bands = SpectralDistribution(dict(zip(BANDS.wavelengths, relative)))
    return sd_to_XYZ(bands, OBSERVER, D65, method="ASTM E308") / 100


white = xyz(np.ones(36))
for kelvin in [4000, 5000, 6000, 8000, 10000, 15000, 25000]:
    power = sd_CIE_illuminant_D_series(CCT_to_xy_CIE_D(kelvin), M1_M2_rounding=False)
    relative = power.copy().align(BANDS).values / D65.copy().align(BANDS).values
    relative /= xyz(relative)[1]
    # From the white of these bands to that of Rec. 709's matrix.
    adapted = colour.adaptation.chromatic_adaptation_VonKries(
        xyz(relative), white, colour.xy_to_XYZ([0.3127, 0.3290]), transform="Bradford")
    rgb = np.linalg.inv(colour.RGB_COLOURSPACES["ITU-R BT.709"].matrix_RGB_to_XYZ) @ adapted
    shown = relative[::5]
    print(f"    {{{kelvin}, {{{', '.join(f'{v:.7f}' for v in rgb)}}}, {{{', '.join(f'{v:.5f}' for v in shown)}}}}},")
