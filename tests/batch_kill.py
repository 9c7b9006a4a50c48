#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Kills `selion batch` at random moments and resumes it; the files must be those of a run that nothing disturbed.

    batch_kill.py SELION [KILLS [SEED]]

A last run is interrupted by SIGINT instead: it must end with status 130 and say how to go on.
"""
import json
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

FIELDS = 40


def write_fields(path):
    """Small fields of different shapes; every tenth is too narrow, every thirteenth crosses itself."""
    features = []
    for i in range(1, FIELDS + 1):
        west, south = 3.43 + 0.003 * i, 46.336
        east = west + (0.00003 if i % 10 == 0 else 0.0008 + 0.00003 * (i % 7))
        north = south + 0.0006 + 0.00002 * (i % 11)
        ring = [[west, south], [east, south], [east, north], [west, north], [west, south]]
        if i % 13 == 0:
            ring[1], ring[2] = ring[2], ring[1]
        features.append({"type": "Feature", "properties": {"name": f"field {i}"},
                         "geometry": {"type": "Polygon", "coordinates": [ring]}})
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}), encoding="utf-8")


def tree(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def run(selion, fields, out, *options):
    started = time.monotonic()
    done = subprocess.run([selion, "batch", fields, "-o", out, "-q", *options], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"batch_kill: status {done.returncode}: {done.stderr}")
    return time.monotonic() - started


def stopped(selion, fields, out, how, after_s):
    """Starts a batch and sends it the signal. @returns status and standard error"""
    with subprocess.Popen([selion, "batch", fields, "-o", out, "--resume", "--threads", "2"], stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True) as process:
        time.sleep(after_s)
        process.send_signal(how)
        _, said = process.communicate(timeout=120)
        return process.returncode, said


def results_in(out):
    journal = out / "journal" / "1-of-1.jsonl"
    return journal.read_bytes().count(b'"status"') if journal.is_file() else 0


def main(selion, kills, seed):
    chance = random.Random(seed)
    with tempfile.TemporaryDirectory() as scratch:
        fields, whole, out = (pathlib.Path(scratch, name) for name in ("fields.geojson", "whole", "out"))
        write_fields(fields)
        seconds = run(selion, fields, whole, "--threads", "1")
        killed = 0
        for _ in range(kills):
            status, _ = stopped(selion, fields, out, signal.SIGKILL, chance.uniform(0, 0.1 + 2 * seconds / kills))
            killed += status == -signal.SIGKILL
        before = results_in(out)
        run(selion, fields, out, "--resume")
        if tree(out) != tree(whole):
            sys.exit(f"batch_kill: {killed} kills, and {sorted(set(tree(out)) ^ set(tree(whole)))} or their bytes differ")
        print(f"batch_kill: killed {killed} of {kills} times, {before} of {FIELDS} fields done then; "
              f"resumed to the same {len(tree(whole))} files")
        status, said = stopped(selion, fields, pathlib.Path(scratch, "interrupted"), signal.SIGINT, 0.4 * seconds)
        if status == 130 and "--resume goes on" not in said:
            sys.exit(f"batch_kill: interrupted, it said only {said!r}")
        if status not in (0, 130, -signal.SIGINT):  # on a busy machine it may come before the program has begun
            sys.exit(f"batch_kill: interrupted, it ended with status {status}")
        run(selion, fields, pathlib.Path(scratch, "interrupted"), "--resume")
        if tree(pathlib.Path(scratch, "interrupted")) != tree(whole):
            sys.exit("batch_kill: interrupted and resumed, its files differ")
    return 0 if killed > 0 else 1


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 10,
                  int(sys.argv[3]) if len(sys.argv) > 3 else 1))
