#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the `selion` commands and the job files that README.md and docs/ show; each must end with status 0.

    readme.py SELION ROOT

A command counts where it stands in a block of shell and names no placeholder in capitals.
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile


def commands(page, scratch):
    """The arguments of every run; a job file is written into the scratch folder and its job printed."""
    for number, block in enumerate(re.findall(r"```toml\n(.*?)```", page, flags=re.S)):
        job = pathlib.Path(scratch, f"{number}.toml")
        job.write_text(block, encoding="utf-8")
        yield ["plan", "--print-job", "--job", str(job)]
    for block in re.findall(r"```sh\n(.*?)```", page, flags=re.S):
        for line in block.splitlines():
            words = shlex.split(line, comments=True)
            if words[:1] == ["selion"] and not re.search(r"\b[A-Z]{3,}\b|\.\.\.", line):
                yield words[1:]


def main(selion, root):
    run = failed = 0
    with tempfile.TemporaryDirectory() as scratch:
        pathlib.Path(scratch, "data").symlink_to(root / "data")
        for page in [root / "README.md", *sorted((root / "docs").glob("*.md"))]:
            for words in commands(page.read_text(encoding="utf-8"), scratch):
                done = subprocess.run([selion, *words], cwd=scratch, capture_output=True, text=True, check=False)
                run += 1
                if done.returncode != 0:
                    failed += 1
                    print(f"{page.name}: selion {shlex.join(words)}: status {done.returncode}\n{done.stderr}")
    print(f"readme: {run} commands, {failed} failed")
    return 1 if failed or run == 0 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()))
