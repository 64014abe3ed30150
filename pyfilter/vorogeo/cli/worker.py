"""Runs one job: in this process, or in one of its own that reads the job from its standard input."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from ..errors import Error
from .commands import COMMANDS
from .job import Job, MeshTask
from .outputs import plain, write


def run(job: Job) -> str:
    """Compute and write; what `told` makes of it."""
    began = time.perf_counter()
    result = COMMANDS[job.command](MeshTask(job))
    if job.out and result.main:
        write(result, Path(job.out))
    return told(job, result.text, result.summary, time.perf_counter() - began)


def told(job: Job, text: str, summary: dict[str, Any], seconds: float) -> str:
    """What a user is told, or with --json a program: an object in one line."""
    if job.options.get("json"):
        return json.dumps({"seconds": seconds, **plain(summary)})
    return f"{job.out}: {text.splitlines()[0]}, {seconds:.1f} s" if job.out else text


def failure(error: BaseException) -> str:
    """An error in one line."""
    if isinstance(error, MemoryError) and not str(error):
        return "there is not enough memory"
    text = " ".join(str(error).split())
    expected = isinstance(error, (Error, OSError, MemoryError, ImportError))
    return text if expected and text else f"{type(error).__name__}: {text}"


def run_in_own_process(job: Job) -> tuple[bool, str]:
    """Whether it succeeded, and its line; a job that takes its process down is a failure like any other."""
    done = subprocess.run(
        [sys.executable, "-X", "utf8", "-m", "vorogeo.cli.worker"],  # names of files may have any characters
        input=json.dumps(job.as_dict()),
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    if done.returncode == 0:
        return True, done.stdout.strip()
    if done.returncode < 0:
        return False, f"its process was ended by signal {-done.returncode} (9: by hand or for lack of memory)"
    lines = done.stderr.strip().splitlines()
    return False, lines[-1] if lines else f"its process ended with status {done.returncode}"


def _main() -> int:
    given: dict[str, Any] = json.load(sys.stdin)
    try:
        print(run(Job(**given)))
    except Exception as error:
        print(failure(error), file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(_main())
