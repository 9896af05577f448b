#!/usr/bin/env python3
"""Prints the table of render/colour/primaries.cpp: the smoothest reflectances of a red, a green and a blue.

Three spectra that are nowhere negative, whose sum is 1 in every band, and that are exactly the primaries of Rec. 709 when
they are seen under D65 by the observer of 2 degrees; of all such the ones with the least sum of squared steps between
bands (Mallett and Yuksel, "Spectral Primary Decomposition for Rendering with sRGB Reflectance", EGSR 2019). That is a
quadratic programme; its active set is solved to the last digit.

Takes the Python packages scipy and colour-science: python3 colour_primaries.py
"""

import colour
import numpy as np
from colour import MultiSpectralDistributions, SpectralDistribution, SpectralShape
from colour.colorimetry import tristimulus_values
from scipy.optimize import lsq_linear

VISIBLE = SpectralShape(360, 780, 1)
BANDS = SpectralShape(380, 730, 10)


def observer():
    """The matching functions at every nm, from the 5 nm that Loomlight keeps."""
    table = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"].copy().trim(VISIBLE)
    nm, values = table.wavelengths, table.values
    each = [colour.SpragueInterpolator(nm[::5], values[::5, i])(nm) for i in range(3)]
    return MultiSpectralDistributions(dict(zip(nm, np.stack(each, 1))))


def d65():
    """CIE 15: the components of daylight at 10 nm, straight between, with factors of three decimals."""
    nm = VISIBLE.wavelengths
    table = colour.colorimetry.SDS_BASIS_FUNCTIONS_CIE_ILLUMINANT_D_SERIES
    s = [np.interp(nm, nm[::10], table[name][nm[::10]]) for name in ("S0", "S1", "S2")]
    return SpectralDistribution(dict(zip(nm, s[0] - 0.295 * s[1] - 0.689 * s[2])))


def linear_weights():
    """3 x 36: from reflectance under D65 to linear Rec. 709, adapted (Bradford) from the weights' white to the standard's."""
    whole = SpectralShape(360, 780, 10)
    functions, light = observer(), d65()
    weights = tristimulus_values.tristimulus_weighting_factors_ASTME2022(
        functions, light, whole, k=1 / np.sum(light.values * functions.values[:, 1]))
    weights = tristimulus_values.adjust_tristimulus_weighting_factors_ASTME308(weights, whole, BANDS).T
    xyz_of_rgb = np.array([[0.4123907993, 0.3575843394, 0.1804807884], [0.2126390059, 0.7151686788, 0.0721923154],
                           [0.0193308187, 0.1191947798, 0.9505321522]])
    bradford = np.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]])
    gain = (bradford @ xyz_of_rgb.sum(1)) / (bradford @ weights.sum(1))
    return np.linalg.inv(xyz_of_rgb) @ np.linalg.inv(bradford) @ np.diag(gain) @ bradford @ weights


def primaries(weights):
    n = weights.shape[1]
    steps = np.kron(np.eye(3), np.diff(np.eye(n), axis=0))
    exact = np.vstack([np.kron(np.eye(3), weights), np.kron(np.ones((1, 3)), np.eye(n))])
    target = np.concatenate([np.eye(3).ravel(), np.ones(n)])
    # The least squares of steps, with the equations weighed so much that they hold, tells which bands are at 0.
    heavy = 1e4
    guess = lsq_linear(np.vstack([steps, heavy * exact]), np.concatenate([np.zeros(len(steps)), heavy * target]),
                       bounds=(0, np.inf), method="bvls", tol=1e-15, max_iter=5000).x
    free = guess > 1e-9
    while True:
        a = exact[:, free]
        kkt = np.block([[steps[:, free].T @ steps[:, free], a.T], [a, np.zeros((len(a), len(a)))]])
        found = np.linalg.lstsq(kkt, np.concatenate([np.zeros(free.sum()), target]), rcond=1e-14)[0][:free.sum()]
        if found.min() > -1e-12:
            break
        free[np.flatnonzero(free)[found < 0]] = False
    result = np.zeros(3 * n)
    result[free] = found
    assert np.abs(exact @ result - target).max() < 1e-10
    return result.reshape(3, n)


if __name__ == "__main__":
    for name, spectrum in zip("rgb", primaries(linear_weights())):
        print(name, ", ".join(f"{value:.8f}f" for value in np.maximum(spectrum, 0)))
