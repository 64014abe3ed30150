"""Measures one method in a process of its own, so that a crash or a time limit ends nothing else.

Usage: python worker.py TASK, a file written by measure.py; what comes out are lines of JSON, read by it as they come:
  {"prepared": processor time, "version": text}, {"field": source, "seconds": t, "cpu": t},
  {"pair": i, "seconds": t, "cpu": t, "distance": d}, {"many": pairs, "seconds": t, "cpu": t},
  {"matrix": rows, "cpu": t}.
The first field of each source, or the rows of a matrix that are checked, are added to the task's file of fields.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import meshes
import methods


def main() -> None:
    """Run the task named on the command line."""
    task = json.loads(Path(sys.argv[1]).read_text())
    vertices, faces = meshes.read_raw(Path(task["mesh"]))
    try:
        methods.import_package(task["method"])
        method, _, prepared = timed(
            lambda: methods.make(task["method"], vertices, faces, task["threads"], task["index_file"])
        )
        say(prepared=prepared, version=methods.version(task["method"]))
        if task["matrix"]:
            measure_matrix(method.index, task, len(vertices))
            return
        if method.field:
            measure_fields(method, task)
        if method.pair:
            measure_pairs(method, task)
        if task["many"]:
            measure_many(method, np.load(task["many"]))
    except ImportError as error:
        sys.exit(f"not installed: {error}")
    except Exception as error:  # the parent shows it in the table
        sys.exit(f"{type(error).__name__}: {error}")


def measure_fields(method: Any, task: dict[str, Any]) -> None:
    """Fields of the sources, each several times, until the budget is used up."""
    end = time.process_time() + task["budget"]
    with Path(task["fields"]).open("wb") as file:
        for number, source in enumerate(task["sources"]):
            if number > 0 and time.process_time() > end:
                break
            for repeat in range(task["repeats"]):
                if repeat > 0 and time.process_time() > end:
                    break
                found, seconds, cpu = timed(lambda s=source: method.field(s))
                if repeat == 0:
                    np.ascontiguousarray(found, np.float64).tofile(file)
                    file.flush()
                say(field=source, seconds=seconds, cpu=cpu)


def measure_pairs(method: Any, task: dict[str, Any]) -> None:
    """The pairs one by one until half of the budget is used up."""
    pairs = np.load(task["pairs"]).tolist()
    end = time.process_time() + 0.5 * task["budget"]
    for number, (source, target) in enumerate(pairs):
        if number > 0 and time.process_time() > end:
            break
        found, seconds, cpu = timed(lambda s=source, t=target: method.pair(s, t))
        say(pair=number, seconds=seconds, cpu=cpu, distance=found)


def measure_many(method: Any, pairs: np.ndarray) -> None:
    """All pairs in one call of VoroGeo."""
    for _ in range(3):
        _, seconds, cpu = timed(lambda: method.index.distance(pairs[:, 0], pairs[:, 1]))
        say(many=len(pairs), seconds=seconds, cpu=cpu)


def measure_matrix(index: Any, task: dict[str, Any], count: int) -> None:
    """Rows of our matrix, float32 in a file: all of them, or as many as the budget allows."""
    sources, checked = np.array(task["sources"]), task["matrix"]["checked"]
    out = Path(task["fields"]).with_name("matrix.npy")
    if task["matrix"]["rows"] == count:
        numbers, spent, done = np.arange(count), 0.0, count
        work = lambda: index.distance_matrix(numbers, entries="fields", dtype="float32", out=out)  # noqa: E731
        places = sources[:checked]
    else:
        _, _, spent = timed(lambda: index.fields(sources[:64], dtype="float32"))
        some = int(min(count, max(64, 64 * task["budget"] / spent)))
        work = lambda: index.fields(sources[:some], dtype="float32", out=out)  # noqa: E731
        places, done = np.arange(checked), some + 64
    matrix, _, cpu = timed(work)
    say(matrix=done, cpu=spent + cpu)
    np.array(matrix[places], np.float64).tofile(task["fields"])


def timed(run: Callable[[], Any]) -> tuple[Any, float, float]:
    """Result of a call, and its seconds of wall clock and of processor time."""
    start, cpu = time.perf_counter(), time.process_time()
    result = run()
    return result, time.perf_counter() - start, time.process_time() - cpu


def say(**values: object) -> None:
    """One line for the parent."""
    print(json.dumps(values), flush=True)


if __name__ == "__main__":
    main()
