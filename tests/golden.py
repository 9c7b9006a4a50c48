#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands of golden files and compares what comes out.

    golden.py SELION DATA FILE...

A golden file is a list of runs in one scratch folder. A line is a word, a colon and a value; {data} is the folder of test
fields, \\n and \\xNN stand for bytes. A run starts with `run` and holds for what follows it:

    given: NAME TEXT        before the next run: a file of that text in the scratch folder
    pipe: NAME              before the next run: a named pipe there that nobody writes to
    run: ARGUMENTS          as a shell splits them
    with: stdin FILE | stdin open | limit BYTES | interrupt SECONDS | env NAME=VALUE
    status: N
    stdout: TEXT            the stream contains it; `stdout is:` is all of it, `stdout lacks:` must not be in it
    stderr: TEXT            likewise
    file: NAME              there is such a file, and it is not empty
    no file: NAME
    same: NAME NAME         two files of the same bytes
"""
import os
import pathlib
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import time


class Run:
    def __init__(self, place, arguments):
        self.place, self.arguments = place, arguments
        self.stdin, self.limit, self.interrupt, self.env = None, None, None, {}
        self.checks = []


def unescaped(text):
    return text.encode("utf-8").decode("unicode_escape").encode("latin-1")


def parse(path, data):
    runs, given = [], []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        if not line.strip() or line.startswith("#"):
            continue
        word, value = (part.strip() for part in line.split(":", 1))
        value = value.replace("{data}", shlex.quote(str(data)) if word == "run" else str(data))
        if word == "given":
            given.append(value.split(" ", 1))
        elif word == "pipe":
            given.append((value, None))
        elif word == "run":
            runs.append(Run(f"{path.name}:{number}", shlex.split(value)))
            runs[-1].given, given = given, []
        elif word == "with":
            set_condition(runs[-1], *value.split(" ", 1))
        else:
            runs[-1].checks.append((f"{path.name}:{number}", word, value))
    return runs


def set_condition(run, word, value):
    if word == "env":
        run.env.update([value.split("=", 1)])
    elif word in ("stdin", "limit", "interrupt"):
        setattr(run, word, value)
    else:
        raise SystemExit(f"{run.place}: no condition {word}")


def execute(run, selion, scratch):
    for name, text in run.given:
        if text is None:
            os.mkfifo(scratch / name)
        else:
            (scratch / name).write_bytes(unescaped(text))

    def prepare():
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        if run.limit:
            resource.setrlimit(resource.RLIMIT_FSIZE, (int(run.limit), int(run.limit)))

    stdin = subprocess.DEVNULL
    if run.stdin:
        stdin = subprocess.PIPE if run.stdin == "open" else open(scratch / run.stdin, "rb")
    process = subprocess.Popen([selion, *run.arguments], cwd=scratch, stdin=stdin, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, env={**os.environ, **run.env}, preexec_fn=prepare)
    if run.interrupt:
        interrupt(process, float(run.interrupt))
    out, err = process.communicate(timeout=300)
    return process.returncode, out.decode("utf-8"), err.decode("utf-8")


def interrupt(process, seconds):
    """Sends SIGINT once the program, still running, watches for it (before that it would only be killed) and waits
    for its end, with its standard input still open: closed, it would be another reason to end."""
    mask = 1 << (signal.SIGINT - 1)
    status = pathlib.Path(f"/proc/{process.pid}/status")
    while process.poll() is None:
        blocked = [line.split()[1] for line in status.read_text().splitlines() if line.startswith("SigBlk")]
        if blocked and int(blocked[0], 16) & mask:
            break
        time.sleep(0.01)
    time.sleep(seconds)
    process.send_signal(signal.SIGINT)
    process.wait(timeout=60)


def holds(word, value, outcome, scratch):
    status, out, err = outcome
    stream = {"stdout": out, "stderr": err}.get(word.split(" ")[0])
    if word == "status":
        return status == int(value)
    if stream is not None:
        text = unescaped(value).decode("utf-8")
        return {"": text in stream, "is": text == stream, "lacks": text not in stream}[word[7:]]
    if word == "file":
        return (scratch / value).is_file() and (scratch / value).stat().st_size > 0
    if word == "no file":
        return not (scratch / value).exists()
    if word == "same":
        first, second = value.split(" ")
        return (scratch / first).read_bytes() == (scratch / second).read_bytes()
    raise SystemExit(f"no check '{word}'")


def main():
    selion, data = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    failures = checks = 0
    for path in map(pathlib.Path, sys.argv[3:]):
        with tempfile.TemporaryDirectory() as scratch:
            for run in parse(path, data):
                outcome = execute(run, selion, pathlib.Path(scratch))
                for place, word, value in run.checks:
                    checks += 1
                    if holds(word, value, outcome, pathlib.Path(scratch)):
                        continue
                    failures += 1
                    print(f"{place}: {word}: {value}\n  run: {shlex.join(run.arguments)}\n  status {outcome[0]}"
                          f"\n  stdout {outcome[1][:2000]!r}\n  stderr {outcome[2][:2000]!r}")
    print(f"golden: {checks} checks, {failures} failed")
    return 1 if failures or checks == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
