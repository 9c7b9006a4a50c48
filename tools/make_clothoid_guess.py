#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints src/motion/clothoid_guess_table.hpp: the root a of the clothoid between two headings over a chord, a
polynomial in the squares of the headings' sum and difference, times the sum. Needs python3-mpmath."""
from mpmath import cos, cospi, legendre, lu_solve, matrix, mp, mpf, nstr, pi, sin

DEGREE = 7
NODES = 34  # along each heading

mp.dps = 30
GAUSS = []  # nodes and weights on [0, 1]


def legendre_nodes(count):
    for i in range(count):
        x = cospi((mpf(i) + mpf("0.75")) / (count + mpf("0.5")))
        for _ in range(8):
            value, last = legendre(count, x), legendre(count - 1, x)
            slope = count * (last - x * value) / (1 - x * x)
            x -= value / slope
        yield (1 + x) / 2, 1 / ((1 - x * x) * slope * slope)


def height(start, turn, a):
    return sum(w * sin(start + (turn - a) * t + a * t * t) for t, w in GAUSS)


def height_slope(start, turn, a):
    return sum(w * (t * t - t) * cos(start + (turn - a) * t + a * t * t) for t, w in GAUSS)


def root(start, end):
    a = 3 * (start + end) - (start + end) * (start * start + end * end) / 2 / pi**2
    for _ in range(30):
        step = height(start, end - start, a) / height_slope(start, end - start, a)
        a -= step
        if abs(step) < mpf(10) ** -24:
            return a
    raise SystemExit("no root")


def terms(sums, differences):
    return [sums**i * differences**j for i in range(DEGREE + 1) for j in range(DEGREE + 1 - i)]


def index(i, j):
    """Place of the term in `terms`."""
    return i * (DEGREE + 1) - i * (i - 1) // 2 + j


def fitted(rows, values):
    """Least squares, weighted anew until the largest errors are alike (Lawson 1961)."""
    weights = [mpf(1)] * len(rows)
    best, least = None, mpf(1)
    size = len(rows[0])
    for _ in range(30):
        normal, right = matrix(size, size), matrix(size, 1)
        for row, value, weight in zip(rows, values, weights):
            for i in range(size):
                scaled = weight * row[i]
                right[i] += scaled * value
                for j in range(i + 1):
                    normal[i, j] += scaled * row[j]
        for i in range(size):
            for j in range(i):
                normal[j, i] = normal[i, j]
        factors = lu_solve(normal, right)
        errors = [abs(sum(f * r for f, r in zip(factors, row)) - value) for row, value in zip(rows, values)]
        if max(errors) < least:
            best, least = factors, max(errors)
        weights = [w * (e + max(errors) / 1000) for w, e in zip(weights, errors)]
        mean = sum(weights) / len(weights)
        weights = [w / mean for w in weights]
    return best, least


def main():
    GAUSS.extend(legendre_nodes(24))
    rows, values = [], []
    nodes = [pi * cospi(mpf(i) / NODES) for i in range(NODES + 1)]
    for i, start in enumerate(nodes):
        for end in nodes[i:]:
            both = start + end
            if both < mpf("1e-3"):
                continue
            # Weighted by the sum: the error of a counts.
            rows.append([both * t for t in terms((both / (2 * pi)) ** 2, ((start - end) / (2 * pi)) ** 2)])
            values.append(root(start, end))
    factors, error = fitted(rows, values)
    print("""// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

// Printed by tools/make_clothoid_guess.py. Per row, a power of the difference's square: factors of the powers
// of the sum's square.
// clang-format off
namespace selion {
""")
    print(f"// Largest error of a: {nstr(error, 2)}.")
    print(f"constexpr std::size_t kGuessTerms = {DEGREE + 1};")
    print("constexpr std::array<std::array<double, kGuessTerms>, kGuessTerms> kClothoidGuess{{")
    for j in range(DEGREE + 1):
        row = [nstr(factors[index(i, j)], 17) for i in range(DEGREE + 1 - j)]
        print("    {{" + ", ".join(row) + "}},")
    print("}};\n\n}  // namespace selion\n// clang-format on")


if __name__ == "__main__":
    main()
