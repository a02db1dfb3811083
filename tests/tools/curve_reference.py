#!/usr/bin/python3
"""Writes tests/loaders/CurveReference.inc: COLLADA's curves evaluated by SciPy, which shares no code with Curve.cpp.

usage: curve_reference.py > tests/loaders/CurveReference.inc      (needs python3-scipy)

Splines that are functions of time are SciPy's own objects (CubicHermiteSpline, BSpline, BPoly); where the time is itself a
cubic of the parameter, SciPy's brentq finds the parameter first.
"""
import numpy as np
from scipy.interpolate import BPoly, BSpline, CubicHermiteSpline
from scipy.optimize import brentq

TIMES = np.array([0.25, 1.0, 1.75, 3.5])
EVEN = np.array([0.5, 1.0, 1.5, 2.0, 2.5])
VALUES = np.array([1.0, 4.0, -2.0, 3.0])
EVEN_VALUES = np.array([2.0, -1.0, 5.0, 0.5, 3.0])


def parametric(x, y, t):
    return float(y(brentq(lambda s: x(s) - t, 0.0, 1.0, xtol=1e-15, rtol=1e-15)))


def bezier(points):
    return BPoly(np.array(points, float).reshape(-1, 1), [0, 1])


def bezier_pairs(t):
    handles_out = [(0.4, 3.0), (1.3, 6.0), (2.9, -4.0)]
    handles_in = [(0.9, 4.5), (1.45, -2.0), (3.0, 9.0)]
    i = min(max(int(np.searchsorted(TIMES, t, 'right')) - 1, 0), 2)
    x = bezier([TIMES[i], handles_out[i][0], handles_in[i][0], TIMES[i + 1]])
    y = bezier([VALUES[i], handles_out[i][1], handles_in[i][1], VALUES[i + 1]])
    return parametric(x, y, t)


def bezier_values(t):
    handles_out, handles_in = [3.0, 6.0, -4.0], [4.5, -2.0, 9.0]
    curve = BPoly(np.array([VALUES[:3], handles_out, handles_in, VALUES[1:]]), TIMES)
    return float(curve(t))


def hermite(t):  # tangents (length of the segment, slope * length): the time runs evenly
    return float(CubicHermiteSpline(TIMES, VALUES, [2.0, -3.0, 0.5, 4.0])(t))


def hermite_pairs(t):  # tangents with times of their own
    tangents_out, tangents_in = [(0.3, 2.0), (1.2, -5.0), (3.0, 1.0)], [(1.5, 4.0), (0.2, 0.0), (1.0, -6.0)]
    i = min(max(int(np.searchsorted(TIMES, t, 'right')) - 1, 0), 2)
    x = CubicHermiteSpline([0, 1], TIMES[i:i + 2], [tangents_out[i][0], tangents_in[i][0]])
    y = CubicHermiteSpline([0, 1], VALUES[i:i + 2], [tangents_out[i][1], tangents_in[i][1]])
    return parametric(x, y, t)


def cardinal(t):
    padded = np.concatenate([[2 * EVEN_VALUES[0] - EVEN_VALUES[1]], EVEN_VALUES, [2 * EVEN_VALUES[-1] - EVEN_VALUES[-2]]])
    slopes = (padded[2:] - padded[:-2]) / (2 * 0.5)
    return float(CubicHermiteSpline(EVEN, EVEN_VALUES, slopes)(t))


def padded(a):
    return np.concatenate([[2 * a[0] - a[1]], a, [2 * a[-1] - a[-2]]])


def bspline(t):
    knots = 0.5 + 0.5 * np.arange(-3, 8)
    return float(BSpline(knots, padded(EVEN_VALUES), 3)(t))


def bspline_uneven(t):
    knots = np.arange(-3.0, 7.0)
    x, y = BSpline(knots, padded(TIMES), 3), BSpline(knots, padded(VALUES), 3)
    return float(y(brentq(lambda s: x(s) - t, 0.0, 3.0, xtol=1e-15, rtol=1e-15)))


def table(name, curve, times):
    rows = ',\n    '.join(f'{{{t!r}, {curve(t):.12g}}}' for t in times)
    print(f'constexpr ReferencePoint {name}[] = {{\n    {rows}}};\n')


print('// Made by tests/tools/curve_reference.py with SciPy; do not edit.\n')
uneven = [0.3, 0.5, 0.77, 0.95, 1.1, 1.35, 1.6, 1.74, 1.9, 2.5, 3.1, 3.45]
even = [0.6, 0.75, 0.99, 1.2, 1.4, 1.63, 1.88, 2.1, 2.35, 2.49]
table('kBezierPairs', bezier_pairs, uneven)
table('kBezierValues', bezier_values, uneven)
table('kHermite', hermite, uneven)
table('kHermitePairs', hermite_pairs, uneven)
table('kCardinal', cardinal, even)
table('kBSpline', bspline, even)
table('kBSplineUneven', bspline_uneven, uneven)
