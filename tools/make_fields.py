#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes data/fields from metres: P3's fields F1-F6 and the fields of our own making.

    tools/make_fields.py            write all files again
    tools/make_fields.py --check    say which files would change; exit 1 if any would

Local metres (x east, y north) become longitude and latitude by the inverse transverse Mercator with scale 1, centred
on ORIGIN (Karney 2011, series to order 6, good to nanometres here). Coordinates are rounded to 9 decimals, 0.1 mm.
"""
import io
import json
import math
import pathlib
import struct
import sys
import zipfile

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "data" / "fields"
ORIGIN = (3.430409, 46.336788)  # Cariou et al. 2020, caption of figure 8
WGS84_PRJ = (
    'GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],'
    'PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]]'
)

# Cariou et al. 2020, appendix A, table 2: vertices in metres.
P3_FIELDS = {
    "F1": [(0, 0), (55.21, -243.42), (377.79, -47.33), (371.91, -11.45)],
    "F2": [(0, 0), (13.42, 12.31), (75.83, 14.49), (42.75, 136.49), (46.10, 260.95), (-152.02, 288.94),
           (-188.27, 7.57)],
    "F3": [(0, 0), (114.25, 181.54), (153.22, 324.77), (145.49, 463.81), (-7.59, 481.58), (-88.44, 451.44)],
    "F4": [(0, 0), (287.37, -48.84), (352.86, 185.97), (139.12, 250.76), (30.43, 119.15)],
    "F5": [(0, 0), (175.76, 90.14), (105.07, 188.07), (119.22, 207.59), (63.57, 289.57), (-67.04, 290.03),
           (-134.38, 176.89), (-49.53, 145.89)],
    "F6": [(0, 0), (-40.96, -67.74), (-41.18, -69.62), (26.29, -89.86), (120.64, -11.48), (51.28, 90.57),
           (-22.49, 168.24), (-115.74, 99.63)],
}  # fmt: skip
P3_AREAS_M2 = {"F1": 51312.7, "F2": 60046.3, "F3": 72926.7, "F4": 71116.2, "F5": 49211.1, "F6": 27771.2}


def krueger():
    """Rectifying radius (m), eccentricity and Krueger's alpha and beta to order 6 for WGS84 (Karney 2011, eq. 12, 35, 36)."""
    f = 1 / 298.257223563
    n = f / (2 - f)
    radius = 6378137 / (1 + n) * (1 + n**2 / 4 + n**4 / 64 + n**6 / 256)
    powers = [n**k for k in range(1, 7)]
    alpha = [
        [1 / 2, -2 / 3, 5 / 16, 41 / 180, -127 / 288, 7891 / 37800],
        [0, 13 / 48, -3 / 5, 557 / 1440, 281 / 630, -1983433 / 1935360],
        [0, 0, 61 / 240, -103 / 140, 15061 / 26880, 167603 / 181440],
        [0, 0, 0, 49561 / 161280, -179 / 168, 6601661 / 7257600],
        [0, 0, 0, 0, 34729 / 80640, -3418889 / 1995840],
        [0, 0, 0, 0, 0, 212378941 / 319334400],
    ]
    beta = [
        [1 / 2, -2 / 3, 37 / 96, -1 / 360, -81 / 512, 96199 / 604800],
        [0, 1 / 48, 1 / 15, -437 / 1440, 46 / 105, -1118711 / 3870720],
        [0, 0, 17 / 480, -37 / 840, -209 / 4480, 5569 / 90720],
        [0, 0, 0, 4397 / 161280, -11 / 504, -830251 / 7257600],
        [0, 0, 0, 0, 4583 / 161280, -108847 / 3991680],
        [0, 0, 0, 0, 0, 20648693 / 638668800],
    ]
    series = [[sum(c * p for c, p in zip(row, powers)) for row in rows] for rows in (alpha, beta)]
    return radius, math.sqrt(f * (2 - f)), series[0], series[1]


RADIUS_M, ECCENTRICITY, ALPHA, BETA = krueger()


def conformal_tan(tan_lat):
    e = ECCENTRICITY
    sigma = math.sinh(e * math.atanh(e * tan_lat / math.hypot(1, tan_lat)))
    return tan_lat * math.hypot(1, sigma) - sigma * math.hypot(1, tan_lat)


def geodetic_tan(tan_conformal):
    """Newton's method of Karney 2011, eq. 19-21."""
    e2 = ECCENTRICITY**2
    tan_lat = tan_conformal / (1 - e2)
    for _ in range(5):
        found = conformal_tan(tan_lat)
        tan_lat += ((tan_conformal - found) / math.hypot(1, found) *
                    (1 + (1 - e2) * tan_lat**2) / ((1 - e2) * math.hypot(1, tan_lat)))  # fmt: skip
    return tan_lat


def northing_of_origin():
    xi = math.atan(conformal_tan(math.tan(math.radians(ORIGIN[1]))))
    return xi + sum(a * math.sin(2 * (j + 1) * xi) for j, a in enumerate(ALPHA))


ORIGIN_XI = northing_of_origin()


def lonlat(point):
    xi, eta = point[1] / RADIUS_M + ORIGIN_XI, point[0] / RADIUS_M
    xi_sphere = xi - sum(b * math.sin(2 * (j + 1) * xi) * math.cosh(2 * (j + 1) * eta) for j, b in enumerate(BETA))
    eta_sphere = eta - sum(b * math.cos(2 * (j + 1) * xi) * math.sinh(2 * (j + 1) * eta) for j, b in enumerate(BETA))
    tan_conformal = math.sin(xi_sphere) / math.hypot(math.sinh(eta_sphere), math.cos(xi_sphere))
    lon = ORIGIN[0] + math.degrees(math.atan2(math.sinh(eta_sphere), math.cos(xi_sphere)))
    return round(lon, 9), round(math.degrees(math.atan(geodetic_tan(tan_conformal))), 9)


def area_m2(ring):
    """Positive where the ring is anticlockwise."""
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1])) / 2


def wound(ring, anticlockwise):
    if (area_m2(ring) > 0) == anticlockwise:
        return ring
    return ring[:1] + ring[:0:-1]


def closed(ring):
    points = [lonlat(p) for p in ring]
    return points + points[:1]


def rings(shell, holes=()):
    """RFC 7946: shell anticlockwise, holes clockwise, closed, longitude first."""
    return [closed(wound(shell, True))] + [closed(wound(hole, False)) for hole in holes]


def polygon(shell, *holes):
    return {"type": "Polygon", "coordinates": rings(shell, holes)}


def point(p):
    return {"type": "Point", "coordinates": lonlat(p)}


def feature(geometry, **properties):
    return {"type": "Feature", "properties": properties, "geometry": geometry}


def geojson(*features):
    """One feature a line, so that a change shows as one."""
    lines = ",\n".join(json.dumps(f, separators=(",", ":")) for f in features)
    return ('{"type":"FeatureCollection","features":[\n' + lines + "\n]}\n").encode()


def box(x, y, width, height):
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def circle(x, y, radius, corners):
    turn = 2 * math.pi / corners
    return [(x + radius * math.cos(k * turn), y + radius * math.sin(k * turn)) for k in range(corners)]


def curved_edge():
    """220 m x 120 m, its north side an arc that bulges by 40 m, as 61 points."""
    radius = (110**2 + 40**2) / (2 * 40)
    half = math.asin(110 / radius)
    arc = [(110 + radius * math.sin(a), 160 - radius + radius * math.cos(a))
           for a in (half - 2 * half * k / 60 for k in range(61))]  # fmt: skip
    return [(0, 0), (220, 0)] + arc


def shapefile(stem, shell, prj):
    """A zipped polygon shapefile of one ring, clockwise as ESRI wants it; `shell` in the units of `prj`."""
    ring = shell + shell[:1]
    xs, ys = [p[0] for p in ring], [p[1] for p in ring]
    bounds = struct.pack("<4d", min(xs), min(ys), max(xs), max(ys))
    content = struct.pack("<i", 5) + bounds + struct.pack("<3i", 1, len(ring), 0)
    content += b"".join(struct.pack("<2d", *p) for p in ring)

    def header(length):
        return (struct.pack(">7i", 9994, 0, 0, 0, 0, 0, length // 2) + struct.pack("<2i", 1000, 5) + bounds +
                struct.pack("<4d", 0, 0, 0, 0))  # fmt: skip

    files = {
        "shp": header(108 + len(content)) + struct.pack(">2i", 1, len(content) // 2) + content,
        "shx": header(108) + struct.pack(">2i", 50, len(content) // 2),
        "dbf": struct.pack("<B3BIHH20x", 3, 120, 1, 1, 1, 65, 11) + struct.pack("<11sc4xBB14x", b"name", b"C", 10, 0)
        + b"\r" + b" " + stem.upper().encode().ljust(10) + b"\x1a",
    }  # fmt: skip
    if prj:
        files["prj"] = prj.encode()
    return zipped({f"{stem}.{ending}": data for ending, data in files.items()})


def zipped(files):
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as archive:
        for name, data in files.items():
            archive.writestr(zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0)), data)
    return packed.getvalue()


def csv(shell):
    rows = "".join(f"{lon:.9f},{lat:.9f}\n" for lon, lat in closed(wound(shell, True)))
    return ("lon,lat\n" + rows).encode()


def kml(name, shell):
    coordinates = " ".join(f"{lon:.9f},{lat:.9f}" for lon, lat in closed(wound(shell, True)))
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<kml xmlns="http://www.opengis.net/kml/2.2">
  <Document>
    <Placemark>
      <name>{name}</name>
      <Polygon>
        <outerBoundaryIs>
          <LinearRing>
            <coordinates>{coordinates}</coordinates>
          </LinearRing>
        </outerBoundaryIs>
      </Polygon>
    </Placemark>
  </Document>
</kml>
""".encode()


def p3_files():
    for name, shell in P3_FIELDS.items():
        if abs(abs(area_m2(shell)) - P3_AREAS_M2[name]) > 0.1:
            raise SystemExit(f"{name}: area {abs(area_m2(shell)):.1f} m2, expected {P3_AREAS_M2[name]} m2")
        yield f"{name.lower()}.geojson", geojson(feature(polygon(shell), name=name))
    clockwise = [lonlat(p) for p in wound(P3_FIELDS["F1"], False)]
    yield "f1.zip", shapefile("f1", clockwise, WGS84_PRJ)
    yield "f2.csv", csv(P3_FIELDS["F2"])
    yield "f3.kml", kml("F3", P3_FIELDS["F3"])


def own_files():
    def one(name, shell, *holes):
        return f"{name}.geojson", geojson(feature(polygon(shell, *holes), name=name))

    yield one("l_shape", [(0, 0), (200, 0), (200, 70), (90, 70), (90, 150), (0, 150)])
    yield one("u_shape", [(0, 0), (220, 0), (220, 140), (140, 140), (140, 50), (80, 50), (80, 140), (0, 140)])
    yield one("with_pond", box(0, 0, 200, 150), circle(90, 80, 22, 16))
    yield one("pole", box(0, 0, 180, 120), box(70, 60, 1, 1))
    yield one("narrow_neck", [(0, 0), (110, 0), (110, 52), (140, 52), (140, 0), (250, 0), (250, 110), (140, 110),
                              (140, 58), (110, 58), (110, 110), (0, 110)])  # fmt: skip
    yield one("slanted", [(0, 0), (200, 0), (310, 110), (110, 110)])
    yield one("curved_edge", curved_edge())
    yield "two_parts.geojson", geojson(feature(
        {"type": "MultiPolygon", "coordinates": [rings(box(0, 0, 120, 100)), rings(box(150, 20, 100, 130))]},
        name="two_parts"))  # fmt: skip
    yield "gates_obstacles.geojson", geojson(
        feature(polygon(box(0, 0, 200, 140)), name="gates_obstacles"),
        feature(point((60, -1.5)), selion="gate", name="south gate", width_m=6),
        feature(point((200.8, 100)), selion="gate", name="east gate"),
        feature(polygon(box(120, 60, 12, 8)), selion="obstacle", name="barn"),
        feature(polygon(box(-5, 115, 30, 30)), selion="no_go", name="orchids"),
        feature(polygon(circle(60, 90, 9, 12)), selion="water", name="pond"))  # fmt: skip


def bad_files():
    square = polygon(box(0, 0, 100, 100))
    corner = json.dumps(square["coordinates"][0][1])
    whole = geojson(feature(square, name="bad"))
    yield "bad/bowtie.geojson", geojson(feature(polygon([(0, 0), (100, 100), (100, 0), (0, 120)]), name="bad"))
    yield "bad/nan.geojson", whole.replace(corner.replace(" ", "").encode(), b"[NaN,46.336788]")
    north = [[3.43, 91.0], [3.44, 91.0], [3.44, 91.01], [3.43, 91.01], [3.43, 91.0]]
    yield "bad/lat91.geojson", geojson(feature({"type": "Polygon", "coordinates": [north]}, name="bad"))
    line = {"type": "LineString", "coordinates": [lonlat(p) for p in box(0, 0, 100, 100)]}
    yield "bad/no_polygons.geojson", geojson(feature(line, name="bad"))
    yield "bad/empty.geojson", b'{"type":"FeatureCollection","features":[]}\n'
    yield "bad/empty_file.geojson", b""
    yield "bad/truncated.geojson", whole[: len(whole) // 2]
    yield "bad/no_crs.zip", shapefile("no_crs", [(700000 + x, 6580000 + y) for x, y in box(0, 0, 100, 100)[::-1]], "")


def main():
    files = dict([*p3_files(), *own_files(), *bad_files()])
    if sys.argv[1:] == ["--check"]:
        stale = [n for n, data in files.items() if not (FOLDER / n).is_file() or (FOLDER / n).read_bytes() != data]
        for name in stale:
            print(f"data/fields/{name}: differs from what tools/make_fields.py writes; run it and look at the change")
        return 1 if stale else 0
    if sys.argv[1:]:
        print(__doc__)
        return 2
    for name, data in files.items():
        (FOLDER / name).parent.mkdir(parents=True, exist_ok=True)
        (FOLDER / name).write_bytes(data)
    return 0


if __name__ == "__main__":
    sys.exit(main())
