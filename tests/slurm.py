#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs slurm_batch.sh against a stand-in for sbatch, and looks at what is submitted.

    slurm.py SLURM_BATCH_SH
"""
import os
import pathlib
import subprocess
import sys
import tempfile

# Prints what it is told to, and keeps its words, one a line; the jobs are numbered.
SBATCH = """#!/bin/sh
printf '%s\\n' "$@" >>"$KEPT"
echo JOB >>"$KEPT"
echo "$(grep -c '^JOB$' "$KEPT")$CLUSTER"
"""


def submitted(script, folder, shards, cluster):
    kept = folder / "kept"
    kept.unlink(missing_ok=True)
    environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", "SELION": "true", "KEPT": str(kept),
                   "CLUSTER": cluster}
    done = subprocess.run(["sh", script, shards, "fields.gpkg", str(folder / "out")], env=environment,
                          capture_output=True, text=True, check=False)
    return done, kept.read_text(encoding="utf-8").splitlines() if kept.exists() else []


def main():
    faults = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        (folder / "sbatch").write_text(SBATCH, encoding="utf-8")
        (folder / "sbatch").chmod(0o755)
        for cluster in ("", ";north"):
            done, words = submitted(sys.argv[1], folder, "4", cluster)
            if "--array=1-4" not in words or "--dependency=afterany:1" not in words:
                faults.append(f"cluster '{cluster}': submitted {words}")
            if "4 shards in job 1, merged by job 2;" not in done.stdout:
                faults.append(f"cluster '{cluster}': said {done.stdout}")
        for shards in ("", "0", "00", "04", "-1", "four"):
            done, words = submitted(sys.argv[1], folder, shards, "")
            if done.returncode != 2 or words or "is no number of shards" not in done.stderr:
                faults.append(f"'{shards}' shards: {done.returncode}, {done.stderr}")
    print("\n".join(faults) or "slurm: as it should be")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
