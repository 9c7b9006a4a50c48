#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks which folder includes which, and where third parties' headers stand.

    tools/check_layers.py                check include/selion and src
    tools/check_layers.py --self-test    check this script on a made-up tree

The tables below are the architecture (docs/architecture.md): whoever changes it changes them here, in the open.
"""
import pathlib
import re
import sys
import tempfile

# A folder sees itself and those to its left.
LINE = ["core", "geometry", "motion", "field", "layout", "route", "fleet", "sim", "cost", "plan", "output", "batch", "cli"]
SEES = {folder: set(LINE[: i + 1]) for i, folder in enumerate(LINE)}
SEES["planfile"] = {"core", "planfile"}
SEES["verify"] = {"core", "planfile", "verify"}
for reader in ("plan", "output", "sim", "batch", "cli"):
    SEES[reader].add("planfile")
for checker in ("batch", "cli"):
    SEES[checker].add("verify")

# Third parties' headers, by how they are included, and the folders whose .cpp files may include them.
THIRD_PARTY = {
    r"CGAL/": {"geometry"},
    r"polyclipping/|clipper\.hpp$": {"geometry"},
    r"geos": {"geometry", "verify"},
    r"Eigen/": {"motion", "sim"},
    r"nlopt\.h": {"motion", "layout"},
    r"gdal|ogr|cpl_": {"field", "verify"},
    r"proj\.h$": {"field", "planfile", "verify", "output"},
    r"nlohmann/": {"field", "planfile", "verify", "batch"},
    r"opencv2/": {"sim"},
    r"toml\+\+/": {"plan"},
    r"cairo|pango|pugixml\.hpp$": {"output"},
    r"tbb/|oneapi/": {"batch"},
    r"CLI/|spdlog/": {"cli"},
}
# What POSIX adds to the standard library: for files written whole, for terminals, and to load GDAL when it is needed.
POSIX = {r"(unistd|fcntl|signal)\.h$|sys/": {"output", "batch", "cli"}, r"dlfcn\.h$": {"field", "verify"}}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
STANDARD = re.compile(r"[a-z_]+$")


def folder_of(path, root):
    parts = path.relative_to(root).parts
    return parts[2] if parts[0] == "include" else parts[1]


def target_folder(name, path, root):
    """The folder of ours that a quoted include names, else None."""
    if name.startswith("selion/"):
        return name.split("/")[1]
    for start in (path.parent, root / "src"):
        found = (start / name).resolve()
        if found.is_file() and root.resolve() in found.parents:
            return folder_of(found, root.resolve())
    return None


def fault(name, quoted, path, root):
    """Why this include is not allowed, else None."""
    folder = folder_of(path, root)
    if folder not in SEES:
        return f"folder {folder} is not in the table of tools/check_layers.py"
    target = target_folder(name, path, root) if quoted else None
    if target is not None:
        return None if target in SEES[folder] else f"{folder} may not see {target}"
    if STANDARD.match(name):
        return None
    for pattern, folders in {**THIRD_PARTY, **POSIX}.items():
        if re.match(pattern, name):
            if folder not in folders:
                return f"only {', '.join(sorted(folders))} may use it"
            return None if path.suffix == ".cpp" else "third parties' headers belong in .cpp files"
    return "neither ours, nor the standard library's, nor in the table of tools/check_layers.py"


def faults(root):
    """(how many files were read, one line for each include that is not allowed)"""
    files = sorted(p for top in ("include/selion", "src") for p in (root / top).rglob("*.[ch]pp"))
    lines = []
    for path in files:
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            match = INCLUDE.match(line)
            why = match and fault(match[2], match[1] == '"', path, root)
            if why:
                lines.append(f"{path.relative_to(root)}:{number}: includes {match[2]}: {why}")
    return len(files), lines


def self_test():
    sources = {
        "include/selion/core/point.hpp": ("#include <vector>\n", 0),
        "include/selion/core/back.hpp": ('#include "selion/field/field.hpp"\n', 1),
        "include/selion/field/field.hpp": ('#include "selion/core/point.hpp"\n', 0),
        "include/selion/field/open.hpp": ("#include <gdal_priv.h>\n", 1),
        "include/selion/planfile/planfile.hpp": ('#include "selion/core/point.hpp"\n', 0),
        "include/selion/verify/verdict.hpp": ('#include "selion/planfile/planfile.hpp"\n', 0),
        "src/verify/check.cpp": ('#include "selion/geometry/polygon.hpp"\n#include <geos_c.h>\n', 1),
        "src/field/read.cpp": ('#include <gdal_priv.h>\n#include "clean.hpp"\n#include "../output/svg.hpp"\n', 1),
        "src/field/clean.hpp": ("#include <proj.h>\n", 1),
        "src/output/svg.hpp": ('#  include "selion/planfile/planfile.hpp"\n#include <fcntl.h>\n', 1),
        "src/output/map.cpp": ('#include "svg.hpp"\n#include <cairo.h>\n#include <fcntl.h>\n', 0),
        "src/core/angle.cpp": ("#include <boost/any.hpp>\n", 1),
        "src/weather/rain.cpp": ("#include <cmath>\n", 1),
    }
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, (text, _) in sources.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        count, lines = faults(root)
    wrong = [n for n, (_, number) in sources.items() if sum(f.startswith(n + ":") for f in lines) != number]
    for name in wrong:
        print(f"check_layers: self-test: {name} should give {sources[name][1]} faults; all found: {lines}")
    return 1 if wrong or count != len(sources) else 0


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    if sys.argv[1:]:
        print(__doc__)
        return 2
    count, lines = faults(pathlib.Path(__file__).resolve().parent.parent)
    for line in lines:
        print(line)
    if count == 0:
        print("check_layers: found no source file")
    return 1 if lines or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
