"""Runs the methods in processes of their own and collects times, distances, peak memory and failures."""

from __future__ import annotations

import json
import os
import platform
import re
import signal
import subprocess
import sys
import tempfile
import threading
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import meshes

PROGRAMS = meshes.ROOT / "build" / "bench" / "tests" / "bench"
CORE_BENCH = PROGRAMS / "core_bench"


@dataclass
class Limits:
    """What a method may take: seconds of all cores until no further query is begun, and until it is killed."""

    budget: float = 20.0
    limit: float = 300.0
    repeats: int = 3


@dataclass
class Result:
    """What became of a method on a mesh."""

    name: str
    prepared: float | None = None  #: processor time of the set-up
    version: str = ""
    field_seconds: list[float] = field(default_factory=list)
    field_cpu: list[float] = field(default_factory=list)  #: the same, all cores together
    fields: NDArray[np.float64] | None = None  #: shape (sources done, n)
    pair_seconds: list[float] = field(default_factory=list)
    pair_cpu: list[float] = field(default_factory=list)
    pair_distances: list[float] = field(default_factory=list)
    many: list[float] = field(default_factory=list)  #: pairs per second of one call
    many_cpu: list[float] = field(default_factory=list)  #: pairs per second of processor time
    matrix_rows: int = 0
    peak_bytes: int = 0
    failure: str = ""


@dataclass
class Task:
    """The same questions for every method of a mesh."""

    mesh: Path
    vertices: int
    sources: list[int]
    pairs: NDArray[np.int64]
    many: NDArray[np.int64] | None = None
    index_file: Path | None = None
    threads: int = 2
    matrix: dict[str, int] | None = None  #: `rows` instead of fields and pairs, of which `checked` are compared


def run(name: str, task: Task, limits: Limits) -> Result:
    """Measure one method; never raises because of it."""
    result = Result(name)
    with tempfile.TemporaryDirectory(dir=task.mesh.parent) as folder:
        fields = Path(folder) / "fields"
        command = _command(name, task, limits, Path(folder), fields)
        if command is None:
            result.failure = "not installed"
            return result
        status, errors, result.peak_bytes = stream(command, limits.limit, lambda line: _take(result, line))
        if status == "limit":
            result.failure = f"ended after {limits.limit:g} s of processor time"
        elif status != 0:
            result.failure = errors or f"crashed ({_signal(status)})"
        if fields.is_file() and task.vertices:
            found = np.fromfile(fields, np.float64)
            complete = len(found) // task.vertices
            result.fields = found[: complete * task.vertices].reshape(complete, task.vertices)
    return result


def stream(command: list[str], limit: float, take: Any) -> tuple[int | str, str, int]:
    """Run a program and pass on its lines as they come; return its status or "limit", last error, peak resident bytes.

    The limit is one of processor time, so that other work on the machine does not bring it nearer.
    """
    with tempfile.TemporaryFile("w+") as errors:
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=errors, text=True)
        over = threading.Event()
        ended = threading.Event()
        peak = [0]

        def watch() -> None:
            while not ended.wait(0.1):
                peak[0] = max(peak[0], _peak_bytes(process.pid))
                if _processor_seconds(process.pid) > limit:  # RLIMIT_CPU would make the clock of processes coarse
                    over.set()
                    process.kill()

        watcher = threading.Thread(target=watch)
        watcher.start()
        assert process.stdout
        with process.stdout:
            for line in process.stdout:
                peak[0] = max(peak[0], _peak_bytes(process.pid))
                take(line)
        process.wait()
        ended.set()
        watcher.join()
        errors.seek(0)
        said = [line.strip() for line in errors.read().splitlines() if line.strip()]
    return (
        "limit" if over.is_set() else process.returncode,
        said[-1][:200] if said else "",
        peak[0],
    )


@dataclass
class Line:
    """One measurement of core_bench: seconds of wall clock and of processor time, or another quantity."""

    values: list[float]
    cpu: list[float] = field(default_factory=list)


Lines = dict[tuple[str, float], Line]


def program(*arguments: object, take: Any = None, limit: float = float("inf")) -> Any:
    """The lines that a task of core_bench prints, or the peak memory if `take` takes them; ends the run if it fails."""
    found: list[Any] = []

    def read(text: str) -> None:
        (take or found.append)(json.loads(text.replace("inf", "Infinity")))

    status, errors, peak = stream([str(CORE_BENCH), *map(str, arguments)], limit, read)
    if status != 0:
        sys.exit(f"core_bench {arguments[0]}: {errors or status}")
    return peak if take else found


def core(*arguments: object) -> tuple[Lines, int]:
    """Lines of core_bench by name and detail, and its peak memory."""
    found: Lines = {}

    def take(line: dict[str, Any]) -> None:
        found[line["name"], line["detail"]] = Line(line["values"], line["cpu"])

    return found, program(*arguments, take=take, limit=7200.0)


def _command(name: str, task: Task, limits: Limits, folder: Path, fields: Path) -> list[str] | None:
    if name.startswith("cgal_"):
        program = PROGRAMS / "cgal_peer"
        options = [str(task.mesh), str(fields), f"{limits.budget:g}", str(limits.repeats), *map(str, task.sources)]
        return [str(program), name.removeprefix("cgal_"), *options] if program.is_file() else None
    np.save(folder / "pairs.npy", task.pairs)
    many = name == "vorogeo_index" and task.many is not None
    if many:
        np.save(folder / "many.npy", task.many)
    description = {
        "method": name,
        "mesh": str(task.mesh),
        "sources": task.sources,
        "pairs": str(folder / "pairs.npy"),
        "many": str(folder / "many.npy") if many else None,
        "fields": str(fields),
        "index_file": str(task.index_file) if task.index_file else None,
        "threads": task.threads,
        "budget": limits.budget,
        "repeats": limits.repeats,
        "matrix": task.matrix,
    }
    (folder / "task.json").write_text(json.dumps(description))
    return [sys.executable, str(Path(__file__).with_name("worker.py")), str(folder / "task.json")]


def _take(result: Result, text: str) -> None:
    """One line of a worker; packages may print lines of their own."""
    try:
        line = json.loads(text)
    except json.JSONDecodeError:
        return
    if not isinstance(line, dict):
        return
    if "prepared" in line:
        result.prepared, result.version = line["prepared"], line["version"]
    elif "field" in line:
        result.field_seconds.append(line["seconds"])
        result.field_cpu.append(line["cpu"])
    elif "matrix" in line:
        result.matrix_rows = line["matrix"]
        result.field_cpu.append(line["cpu"])
    elif "pair" in line:
        result.pair_seconds.append(line["seconds"])
        result.pair_cpu.append(line["cpu"])
        result.pair_distances.append(line["distance"])
    elif "many" in line:
        result.many.append(line["many"] / line["seconds"])
        result.many_cpu.append(line["many"] / line["cpu"])


def _peak_bytes(process: int) -> int:
    """Greatest resident memory of a program so far; rusage counts what this process had before it began as well."""
    try:
        found = re.search(r"^VmHWM:\s*(\d+) kB", Path(f"/proc/{process}/status").read_text(), re.MULTILINE)
    except OSError:
        return 0
    return 1024 * int(found[1]) if found else 0


def _processor_seconds(process: int) -> float:
    """Processor time of a program so far."""
    try:
        figures = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    except (OSError, IndexError):
        return 0.0
    return (int(figures[11]) + int(figures[12])) / os.sysconf("SC_CLK_TCK")


def _signal(status: int | str) -> str:
    return signal.Signals(-status).name if isinstance(status, int) and status < 0 else f"status {status}"


def machine() -> str:
    """Processor and cores, as far as the system tells."""
    try:
        found = re.search(r"^model name\s*:\s*(.+)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    except OSError:
        found = None
    return f"{found[1] if found else platform.machine()}, {os.cpu_count()} cores, {platform.system()}"
