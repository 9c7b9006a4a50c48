#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the coefficients of the Fresnel integrals and what the tests compare them and the clothoids with.

    tools/make_fresnel.py table        src/motion/fresnel_table.hpp
    tools/make_fresnel.py integrals    tests/motion_fresnel_reference.hpp
    tools/make_fresnel.py clothoids    tests/motion_clothoid_reference.hpp

All numbers are worked out with 60 digits and more (python3-mpmath). With phi = pi/2 t^2 and z = sqrt(pi)/2 (1 - i) t,
C(t) + i S(t) = (1 + i)/2 erf(z) = (1 + i)/2 - (g(t) + i f(t)) exp(i phi) for t >= 0 (Abramowitz and Stegun 1964,
7.3.9, 7.3.22), so that g + i f = (1 + i)/2 exp(-i phi) erfc(z) (f and g are real on the real line).
"""
import random
import sys

import mpmath as mp

mp.mp.dps = 60
FAR = 4          # from here on f and g by powers of 1 / (pi t^2)^2
PIECES = 16      # of [0, FAR]
DEGREE = 11      # of a piece
FAR_DEGREE = 11


def auxiliary(t):
    """g + i f at t >= 0."""
    t = mp.mpf(t)
    z = mp.sqrt(mp.pi) / 2 * (1 - 1j) * t
    return (1 + 1j) / 2 * mp.exp(-1j * mp.pi / 2 * t * t) * mp.erfc(z)


def integrals(t):
    """C + i S at any t."""
    return (1 + 1j) / 2 * mp.erf(mp.sqrt(mp.pi) / 2 * (1 - 1j) * mp.mpf(t))


def interpolated(function, low, high, degree):
    """Coefficients, constant first, of the polynomial in x = (t - middle) / half through the Chebyshev nodes."""
    count = degree + 1
    nodes = [mp.cos(mp.pi * (2 * i + 1) / (2 * count)) for i in range(count)]
    middle, half = (low + high) / 2, (high - low) / 2
    values = [function(middle + half * x) for x in nodes]
    chebyshev = [2 / mp.mpf(count) * mp.fsum(v * mp.cos(j * mp.acos(x)) for v, x in zip(values, nodes))
                 for j in range(count)]
    chebyshev[0] /= 2
    basis = [[mp.mpf(1)], [mp.mpf(0), mp.mpf(1)]]
    while len(basis) < count:
        doubled = [mp.mpf(0)] + [2 * a for a in basis[-1]]
        for i, a in enumerate(basis[-2]):
            doubled[i] -= a
        basis.append(doubled)
    return [mp.fsum(c * b[i] for c, b in zip(chebyshev, basis) if i < len(b)) for i in range(count)]


def far_parts(x):
    """(pi t f, pi^2 t^3 g) at x = 1 / (pi t^2)^2."""
    if x == 0:
        return mp.mpf(1), mp.mpf(1)
    t = 1 / mp.sqrt(mp.pi * mp.sqrt(x))
    with mp.workdps(90):
        both = auxiliary(t)
        return mp.pi * t * both.imag, mp.pi ** 2 * t ** 3 * both.real


def number(value):
    return mp.nstr(value, 20, min_fixed=0, max_fixed=0) if value else "0"


def row(values):
    return ", ".join(number(v) for v in values)


def error(coefficients, function, low, high):
    worst = mp.mpf(0)
    for i in range(41):
        x = mp.mpf(2 * i) / 40 - 1
        value = mp.polyval(coefficients[::-1], x)
        worst = max(worst, abs(value - function((low + high) / 2 + (high - low) / 2 * x)))
    return worst


def print_header(about):
    print("// SPDX-License-Identifier: GPL-3.0-or-later")
    print("#pragma once\n\n#include <array>\n#include <cstddef>\n")
    print(f"// Printed by tools/make_fresnel.py. {about}\n// clang-format off\nnamespace selion {{\n")


def print_table():
    print_header("Per row: factors of 1, x, x^2, ...")
    print(f"// x runs from -1 to 1 over each piece of [0, {FAR}].")
    print(f"constexpr double kFresnelFar = {FAR};")
    print(f"constexpr std::size_t kFresnelPieces = {PIECES};")
    worst = mp.mpf(0)
    for name, part in (("F", lambda t: auxiliary(t).imag), ("G", lambda t: auxiliary(t).real)):
        print(f"constexpr std::array<std::array<double, {DEGREE + 1}>, kFresnelPieces> kFresnel{name}{{{{")
        for i in range(PIECES):
            low, high = mp.mpf(FAR) * i / PIECES, mp.mpf(FAR) * (i + 1) / PIECES
            coefficients = interpolated(part, low, high, DEGREE)
            worst = max(worst, error(coefficients, part, low, high))
            print("    {{" + row(coefficients) + "}},")
        print("}};")
    high = 1 / (mp.pi * FAR ** 2) ** 2
    print("\n// pi t f and pi^2 t^3 g; x = 2 (16 pi / (pi t^2))^2 - 1 from t = 4 on.")
    for name, which in (("F", 0), ("G", 1)):
        part = lambda x, which=which: far_parts(x)[which]
        coefficients = interpolated(part, mp.mpf(0), high, FAR_DEGREE)
        worst = max(worst, error(coefficients, part, mp.mpf(0), high))
        print(f"constexpr std::array<double, {FAR_DEGREE + 1}> kFresnelFar{name}{{{row(coefficients)}}};")
    print("\n// The integrals near 0, by x = t^4: C / t and S / t^3 (Abramowitz and Stegun 1964, 7.3.11 and 13).")
    for name, odd in (("C", 0), ("S", 1)):
        terms = [(-1) ** n * (mp.pi / 2) ** (2 * n + odd) / (mp.factorial(2 * n + odd) * (4 * n + 1 + 2 * odd))
                 for n in range(10)]
        print(f"constexpr std::array<double, {len(terms)}> kFresnelNear{name}{{{row(terms)}}};")
    print("\n}  // namespace selion\n// clang-format on")
    print("largest error of a polynomial", mp.nstr(worst, 3), file=sys.stderr)


def places():
    """Where the integrals are compared: near 0, at every seam, at random, towards 50 and beyond."""
    chance = random.Random(1)
    near = [m * 10.0 ** -n for n in (300, 20, 9, 3) for m in (1, 7)]
    seams = [FAR * i / PIECES for i in range(PIECES + 1)]
    beside = [t + e for t in seams + [0.8, 50.0] for e in (-1e-9, 1e-9) if t + e > 0]
    scattered = [chance.uniform(0, 6) for _ in range(130)] + [chance.uniform(6, 50) for _ in range(90)]
    beyond = [50.5, 77.7, 1234.5678, 1e5 + 0.1]
    return [(-t if i % 3 == 0 else t) for i, t in enumerate([*near, *seams, *beside, *scattered, 50.0, *beyond])]


def print_integrals():
    print_header("t, C(t), S(t)")
    rows = places()
    print(f"constexpr std::array<std::array<long double, 3>, {len(rows)}> kFresnelReference{{{{")
    for t in rows:
        pair = integrals(t)
        print(f"    {{{{{t!r}L, {mp.nstr(pair.real, 25)}L, {mp.nstr(pair.imag, 25)}L}}}},".replace("{-0.0L", "{0.0L"))
    print("}};\n\n}  // namespace selion\n// clang-format on")


def displaced(k, c, s):
    """Integral of exp(i (k u + c u^2 / 2)) over [0, s]."""
    with mp.workdps(90):
        k, c, s = mp.mpf(k), mp.mpf(c), mp.mpf(s)
        if c == 0:
            return s if k == 0 else mp.expm1(1j * k * s) / (1j * k)
        if abs(k * s) + abs(c * s * s) < 1:
            # The power series in u: erf loses all its digits to cancellation here.
            total, terms = mp.mpc(0), [mp.mpc(1)]
            for n in range(200):
                total += terms[n] * s ** (n + 1) / (n + 1)
                terms.append(1j * (k * terms[n] + (c * terms[n - 1] if n else 0)) / (n + 1))
            return total
        if c < 0:
            return mp.conj(displaced(-k, -c, s))
    with mp.workdps(140):
        scale = mp.sqrt(mp.pi / c)
        low, high = k / (c * scale), (k + c * s) / (c * scale)
        heading = (k + c * s / 2) * s
        both = lambda t: auxiliary(abs(t)) * (-1 if t < 0 else 1)
        whole = ((high >= 0) - (low >= 0)) * (1 + 1j) * mp.exp(-1j * k * k / (2 * c))
        return scale * (whole - both(high) * mp.exp(1j * heading) + both(low))


def shapes():
    """(curvature, sharpness, length), each over its orders of magnitude."""
    chance = random.Random(2)
    either = lambda low, high: chance.choice((-1, 1)) * 10 ** chance.uniform(low, high)
    rows = [(0.0, 0.0, 1000.0), (10.0, 0.0, 1000.0), (0.0, 10.0, 1000.0), (-10.0, 0.02, 1000.0), (-10.0, 10.0, 2.0),
            (-10.0, 0.02, 500.0), (-9.7, 0.0203, 480.0), (3.3, -0.0071, 465.0), (7.77, -0.0155, 500.0)]
    while len(rows) < 400:
        k = 0.0 if chance.random() < 0.1 else either(-12, 1)
        c = 0.0 if chance.random() < 0.1 else either(-14, 1)
        length = 10 ** chance.uniform(-6, 3)
        if chance.random() < 0.3 and c:  # a turning point within
            k = -c * length * chance.random()
            if abs(k) > 10:
                continue
        rows.append((k, c, length))
    return rows


def print_clothoids():
    print_header("Curvature, sharpness, length, end x, end y; eastwards from 0")
    rows = shapes()
    print(f"constexpr std::array<std::array<long double, 5>, {len(rows)}> kClothoidReference{{{{")
    for k, c, s in rows:
        end = mp.mpc(displaced(k, c, s))
        print(f"    {{{{{k!r}L, {c!r}L, {s!r}L, {mp.nstr(end.real, 25)}L, {mp.nstr(end.imag, 25)}L}}}},")
    print("}};\n\n}  // namespace selion\n// clang-format on")


def main():
    work = {"table": print_table, "integrals": print_integrals, "clothoids": print_clothoids}
    if len(sys.argv) != 2 or sys.argv[1] not in work:
        print(__doc__)
        return 2
    work[sys.argv[1]]()
    return 0


if __name__ == "__main__":
    sys.exit(main())
