"""The colour of a black body, linear Rec. 709 with a luminance of one."""

import numpy as np

# Matching functions as sums of Gaussians, by Wyman, Sloan and Shirley, "Simple Analytic Approximations to the CIE XYZ
# Color Matching Functions", 2013: weight, mean, inverse widths below and above it.
_LOBES = (
    ((1.056, 599.8, 0.0264, 0.0323), (0.362, 442.0, 0.0624, 0.0374), (-0.065, 501.1, 0.0490, 0.0382)),
    ((0.821, 568.8, 0.0213, 0.0247), (0.286, 530.9, 0.0613, 0.0322)),
    ((1.217, 437.0, 0.0845, 0.0278), (0.681, 459.0, 0.0385, 0.0725)),
)
_TO_RGB = np.array(
    [[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560], [0.0556434, -0.2040259, 1.0572252]]
)


def blackbody(kelvin):
    wavelength = np.arange(380.0, 781.0)
    metres = wavelength * 1e-9
    radiance = 1 / (metres**5 * np.expm1(1.438776877e-2 / (metres * max(kelvin, 800.0))))
    xyz = []
    for lobes in _LOBES:
        curve = 0
        for weight, mean, below, above in lobes:
            t = (wavelength - mean) * np.where(wavelength < mean, below, above)
            curve = curve + weight * np.exp(-0.5 * t * t)
        xyz.append(float(np.sum(radiance * curve)))
    rgb = np.maximum(_TO_RGB @ (np.array(xyz) / xyz[1]), 0)
    return tuple(rgb / (rgb @ np.array([0.2126, 0.7152, 0.0722])))
