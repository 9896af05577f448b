#!/usr/bin/env python3
"""Prints the rows of tests/unit/colour/colour_difference_test.cpp: CMC(2:1) and CMC(1:1) of random pairs of colours.

Takes the Python package colour-science; 0.4.7 made the rows that are kept: python3 colour_differences.py
"""

import colour
import numpy as np

random = np.random.default_rng(18)
for _ in range(24):
    standard = np.round([random.uniform(2, 98), *random.uniform(-60, 60, 2)], 2)
    sample = np.round(standard + random.normal(0, 2, 3), 2)
    two, one = (colour.difference.delta_E_CMC(standard, sample, l=l, c=1) for l in (2, 1))
    both = ["{" + ", ".join(f"{v:g}" for v in lab) + "}" for lab in (standard, sample)]
    print(f"    {{{both[0]}, {both[1]}, {two:.5f}, {one:.5f}}},")
