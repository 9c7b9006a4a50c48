#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Input that is made to crash a reader, or to keep it busy for ever, is refused at once and with a reason; settings of
GDAL in the environment change no bytes.

    hostile.py SELION FIELD
"""
import os
import pathlib
import sqlite3
import subprocess
import sys
import tempfile

HANGS_S = 60  # far more than any needs, sanitizers on a busy machine included


def run(*arguments, **settings):
    """Exit status and standard error, with further settings of the environment."""
    done = subprocess.run(arguments, capture_output=True, stdin=subprocess.DEVNULL, timeout=HANGS_S, check=False,
                          env=os.environ | settings)
    return done.returncode, done.stderr.decode("utf-8")


def endless_view(selion, field, folder):
    """A GeoPackage one of whose layers is a query that never ends."""
    run(selion, "batch", field, "-o", folder / "batch", "-q")
    file = folder / "view.gpkg"
    (folder / "batch" / "results.gpkg").rename(file)
    with sqlite3.connect(file) as database:
        table, = database.execute("SELECT table_name FROM gpkg_contents").fetchone()
        database.execute(f"""CREATE VIEW v AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c)
            SELECT x AS fid, (SELECT geom FROM "{table}" LIMIT 1) AS geom FROM c WHERE x < 0""")
        database.execute("INSERT INTO gpkg_contents(table_name, data_type, identifier, srs_id) "
                         "VALUES('v', 'features', 'v', 4326)")
        database.execute("INSERT INTO gpkg_geometry_columns VALUES('v', 'geom', 'MULTIPOLYGON', 4326, 0, 0)")
    database.close()
    return file


def table_bytes(selion, field, folder, **settings):
    """The GeoPackage that a batch writes."""
    run(selion, "batch", field, "-o", folder, "-q", "--overwrite", **settings)
    return (folder / "results.gpkg").read_bytes()


def main():
    selion, field = sys.argv[1], pathlib.Path(sys.argv[2])
    faults = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)

        def expect(status, words, *arguments):
            got, said = run(selion, *arguments)
            if got != status or words not in said:
                faults.append(f"{' '.join(map(str, arguments))}: {got}, {said!r}")

        view = endless_view(selion, field, folder)
        expect(2, "layer 'v' is a stored query", "inspect", view)
        expect(2, "layer 'v' is a stored query", "plan", view, "-o", folder / "plan", "--layer", "v")
        for name, text in (("tables", "[" + ".".join(["a"] * 60000) + "]"), ("keys", ".".join(["a"] * 60000) + " = 1")):
            job = folder / f"{name}.toml"
            job.write_text(text, encoding="utf-8")
            expect(2, "a key of more than 100 parts", "plan", field, "-o", folder / "plan", "--job", job)
        plain = table_bytes(selion, field, folder / "table")
        for setting in ({"OGR_SQLITE_JOURNAL": "WAL"}, {"OGR_SQLITE_PRAGMA": "page_size=1024"}):
            if table_bytes(selion, field, folder / "table", **setting) != plain:
                faults.append(f"{setting} changes results.gpkg")
    print("\n".join(faults) or "hostile: all refused")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
