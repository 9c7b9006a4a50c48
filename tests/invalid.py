#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plans every broken or tricky file of the shared fields and compares what is said with a table.

    invalid.py SELION FIELDS TABLE             checks; FIELDS is the folder that holds invalid/ and public/
    invalid.py SELION FIELDS TABLE --print     prints the table anew, to be read before it is taken

A line of the table: file, further options, exit status, the file whose plan it must be alike (or -), and every line on
standard error that is about the file, as it stands there, parted by " | ". {file} stands for the file's path; notes that
every plan has are left out. Where there is no plan, nothing may be written; `inspect` refuses what `plan` refuses.
"""
import json
import pathlib
import resource
import shlex
import subprocess
import sys
import tempfile

HANGS_S = 60  # far more than any needs, sanitizers on a busy machine included
EVERY_PLAN_SAYS = ("No gate was given", "Machine: none was given", "Flat ground", "Boundary accuracy unknown",
                   "Datum of the boundary")


def run(*arguments):
    """Exit status and standard error; a hang counts as status None."""
    try:
        done = subprocess.run(arguments, capture_output=True, stdin=subprocess.DEVNULL, timeout=HANGS_S, check=False)
    except subprocess.TimeoutExpired:
        return None, f"still running after {HANGS_S} s"
    return done.returncode, done.stderr.decode("utf-8")


def cpu_s():
    """Of all runs so far: on a busy machine the clock on the wall says little."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def said(stderr, file):
    lines = [line for line in stderr.splitlines() if not any(usual in line for usual in EVERY_PLAN_SAYS)]
    return " | ".join(line.replace(str(file), "{file}") for line in lines) or "-"


def figures(folder):
    """Covered area and swaths of each plan below the folder, in the order of the folders' names."""
    found = []
    for report in sorted(folder.rglob("report.json")):
        blocks = json.loads(report.read_text(encoding="utf-8"))["blocks"]
        found.append((sum(block["covered_m2"] for block in blocks), sum(block["swaths"]["strips"] for block in blocks)))
    return found


def alike(some, others):
    """Coordinates of seven decimals, or by way of another CRS: the same swaths, and the same area within 1 m2."""
    return len(some) == len(others) and all(
        abs(a[0] - b[0]) < 1 and a[1] == b[1] for a, b in zip(some, others))


class Checker:
    def __init__(self, selion, fields, scratch):
        self.selion, self.fields, self.scratch = selion, fields, scratch
        self.plans = {}
        self.slowest = (0, "-")

    def plan(self, name, options=()):
        """Status, standard error and figures; a name without a folder is among the broken files."""
        if (name, *options) not in self.plans:
            file = self.fields / (name if name.startswith("public/") else f"invalid/{name}")
            out = self.scratch / str(len(self.plans))
            before = cpu_s()
            status, stderr = run(self.selion, "plan", file, "-o", out, *options)
            self.slowest = max(self.slowest, (cpu_s() - before, name))
            if status not in (0, 4) and out.exists():
                stderr += "\nsomething was written all the same"
            self.plans[(name, *options)] = status, said(stderr, file), figures(out)
        return self.plans[(name, *options)]

    def faults(self, name, options, status, like, words):
        got_status, got_words, got_figures = self.plan(name, options)
        if str(got_status) != status:
            yield f"status {got_status}, not {status}"
        if got_words != words:
            yield f"says     {got_words}\n    and not  {words}"
        if like != "-" and not alike(got_figures, self.plan(like)[2]):
            yield f"covers and drives {got_figures}, {like} {self.plan(like)[2]}"
        if "--repair" in options:  # which is plan's alone: the problems are still there to be shown
            return
        inspected = run(self.selion, "inspect", self.fields / "invalid" / name, *options)[0]
        if inspected != (2 if status == "2" else 0):
            yield f"inspect ends with {inspected}"


def main():
    selion, fields, table = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    if not (fields / "invalid" / "EXPECTED.tsv").exists():
        print("skipped: no folder of shared fields")
        return 0
    rows = [line.split("\t") for line in table.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    with tempfile.TemporaryDirectory() as scratch:
        checker = Checker(selion, fields, pathlib.Path(scratch))
        if "--print" in sys.argv:
            for name, options, _, like, *_ in rows:
                status, words, _ = checker.plan(name, [] if options == "-" else shlex.split(options))
                print(name, options, status, like, words, sep="\t")
            return 0
        failures = 0
        for name, options, status, like, words in rows:
            for fault in checker.faults(name, [] if options == "-" else shlex.split(options), status, like, words):
                failures += 1
                print(f"{name}: {fault}")
    known = {line.split("\t")[0] for line in (fields / "invalid" / "EXPECTED.tsv").read_text(encoding="utf-8")
             .splitlines()[1:]}
    missing = sorted(known - {row[0] for row in rows})
    if missing:
        print("not in the table:", *missing)
    print(f"invalid: {len(rows)} runs, {failures} faults, the slowest plan {checker.slowest[0]:.2f} s of CPU: "
          f"{checker.slowest[1]}")
    return 1 if failures or missing else 0


if __name__ == "__main__":
    sys.exit(main())
