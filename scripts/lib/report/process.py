"""Running the programs that are measured: one at a time, on stated cores, and stopping where one fails."""

import json
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any


class CommandFailed(Exception):
    """A command ended with an error: its line."""


@dataclass(frozen=True)
class Programs:
    """Where things are."""

    root: Path
    isolume: Path
    sweep_bench: Path
    report: Path  # folder of the report's own programs and the peers
    work: Path  # volumes and pictures made on the way
    shared: Path  # volumes that are not part of the project

    @staticmethod
    def of(root: Path, build: Path) -> "Programs":
        # Made anew, so that no volume of an earlier build is measured.
        work = build / "report" / "work"
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        shared = Path(os.environ.get("ISOLUME_SHARED_DATA", root.parent / "shared" / "data"))
        bench = next((path for path in build.rglob("bench_sweep") if path.is_file()), build / "tests" / "bench_sweep")
        return Programs(root, build / "isolume", bench, build / "report", work, shared)


def pinned(command: list[str], threads: int) -> list[str]:
    """The command on as many cores as it has threads, the same ones for every method."""
    cores = sorted(os.sched_getaffinity(0))[:threads]
    return ["taskset", "--cpu-list", ",".join(map(str, cores)), *command]


def output_of(command: list[Any], threads: int = 0, environment: dict[str, str] | None = None) -> str:
    """Standard output. Threads: 0 leaves the cores as they are. CommandFailed with the command's last line."""
    words = [str(word) for word in command]
    print("  " + " ".join(words), file=sys.stderr, flush=True)
    if threads:
        words = pinned(words, threads)
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False,
                              env={**os.environ, **(environment or {})})
    except OSError as error:
        raise CommandFailed(f"{words[0]}: {error.strerror}") from error
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or [f"no message, exit code {done.returncode}"]
        raise CommandFailed(f"{Path(str(command[0])).name}: {lines[-1]}")
    return done.stdout


def json_of(command: list[Any], threads: int = 0, environment: dict[str, str] | None = None) -> Any:
    """What the command prints, as JSON."""
    text = output_of(command, threads, environment)
    try:
        return json.loads(text)
    except ValueError as error:
        raise CommandFailed(f"{Path(str(command[0])).name}: expected JSON on standard output, found {text[:80]!r}"
                            ) from error


def has(program: str) -> bool:
    """Whether a program is installed."""
    return shutil.which(program) is not None
