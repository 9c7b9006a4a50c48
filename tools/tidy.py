#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs clang-tidy's rules (.clang-tidy) over the sources below src, some at a time.

clang-tidy 14 walks through the system's headers anew for every source, which takes nine tenths of its
time. So the sources of a folder are put one after the other into one file; those that use one name for
different things are parted again, as the compiler tells.

    tools/tidy.py BUILD [SOURCE...]    BUILD: where compile_commands.json lies; all sources if none is named
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST_AT_ONCE = 14  # two processors are busy to the end, and a file that clang-tidy reads fits into memory
PLACE = re.compile(r"^(?P<file>/\S+?):(?P<line>\d+)(?P<rest>:\d+: (?P<kind>\w+).*)", re.S)


class Bundle:
    """Sources compiled with the same options, in one text."""

    def __init__(self, folder, options, sources):
        self.folder, self.options, self.sources = folder, options, sources
        self.lines = []  # of the text: (source, its line there)
        text, included = [], set()
        for source in sources:
            own = source.read_text().splitlines()
            for number, line in enumerate(own, 1):
                text.append("" if line in included else line)
                self.lines.append((source, number))
            included |= {line for line in own if line.startswith("#include")}
        self.file = folder / f"{sources[0].parent.name}_{sources[0].stem}.cpp"
        self.file.write_text("\n".join(text) + "\n")
        # Only side by side does one source's name hide another's; the compiler tells of those within a source.
        self.arguments = [*options, f"-I{sources[0].parent}", "-Wno-shadow"]

    def place(self, line):
        """A line of output with the source's own place in it, and that source where one is at fault."""
        found = PLACE.match(line)
        if not found or pathlib.Path(found["file"]) != self.file:
            return line, None
        source, number = self.lines[min(int(found["line"]), len(self.lines)) - 1]
        return f"{source.relative_to(ROOT)}:{number}{found['rest']}", source if found["kind"] == "error" else None

    def parted(self, compiler):
        """Bundles of the same sources that compile."""
        if len(self.sources) == 1:
            return [self]
        command = [compiler, *self.arguments, "-fsyntax-only", "-w", str(self.file)]
        said = subprocess.run(command, capture_output=True, text=True).stderr.splitlines()
        wrong = {self.place(line)[1] for line in said} - {None}
        if not said:
            return [self]
        wrong = [source for source in self.sources if source in wrong] or self.sources[1:]
        right = [source for source in self.sources if source not in wrong] or [wrong.pop(0)]
        return [part for sources in (right, wrong)
                for part in Bundle(self.folder, self.options, sources).parted(compiler)]

    def findings(self):
        command = ["clang-tidy", "--quiet", str(self.file), "--", *self.arguments]
        run = subprocess.run(command, capture_output=True, text=True, cwd=ROOT)
        said = [self.place(line)[0] for line in run.stdout.splitlines()]
        return said or [f"clang-tidy: {run.stderr}"] if run.returncode else []


def compiled(build):
    """What compile_commands.json says of each source below src: compiler and options."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        source = pathlib.Path(entry["file"])
        if source.is_relative_to(ROOT / "src"):
            words = shlex.split(entry["command"])
            found[source] = words[0], tuple(words[1:words.index("-o")])
    return found


def main():
    build, chosen = pathlib.Path(sys.argv[1]).resolve(), [pathlib.Path(name).resolve() for name in sys.argv[2:]]
    folder = build / "tidy"
    folder.mkdir(exist_ok=True)
    (folder / ".clang-tidy").write_text((ROOT / ".clang-tidy").read_text())
    groups = {}
    for source, (compiler, options) in sorted(compiled(build).items()):
        if not chosen or source in chosen:
            groups.setdefault((source.parent, compiler, options), []).append(source)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        whole = [(Bundle(folder, options, sources[i:i + MOST_AT_ONCE]), compiler)
                 for (_, compiler, options), sources in groups.items() for i in range(0, len(sources), MOST_AT_ONCE)]
        parts = [part for parts in pool.map(lambda one: one[0].parted(one[1]), whole) for part in parts]
        said = [line for lines in pool.map(Bundle.findings, parts) for line in lines]
    print("\n".join(dict.fromkeys(said)), end="\n" if said else "")
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main())
