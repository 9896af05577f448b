#!/usr/bin/env python3
"""Prints the rows of Bradford.AgreesWithAnIndependentImplementation in tests/unit/colour/tristimulus_test.cpp.

A row is XYZ, the white that it was seen under, the white that it is brought to, and XYZ there. Takes the Python package
colour-science; 0.4.7 made the rows that are kept: python3 colour_adaptation.py
"""

import colour
import numpy as np

WHITES = {name: colour.xy_to_XYZ(colour.CCS_ILLUMINANTS["CIE 1964 10 Degree Standard Observer"][name])
          for name in ("A", "D50", "FL2", "FL11", "D65")}

random = np.random.default_rng(18)
for i in range(16):
    source, target = random.choice(list(WHITES), 2, replace=False)
    white, other = np.round(WHITES[source], 6), np.round(WHITES[target], 6)
    xyz = np.round(white * random.uniform(0.02, 1, 3), 6)
    there = colour.adaptation.chromatic_adaptation_VonKries(xyz, white, other, transform="Bradford")
    print("    {" + ", ".join("{" + ", ".join(f"{v:.6f}" for v in row) + "}" for row in (xyz, white, other, there)) + "},")
