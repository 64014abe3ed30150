"""The command line over dask.distributed: many meshes, or the matrix of one by blocks of rows."""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from .._output import matrix
from ..dask import blocks_of, matrix_rows, write_files
from ..errors import Error, InvalidInput
from .job import Job, MeshTask
from .outputs import format_of
from .worker import run_in_own_process, told

_RETRIES = 3
_SECONDS = 20  # to reach the scheduler


@contextmanager
def _client(address: str, workers: int) -> Iterator[Any]:
    """A client of a scheduler; of one with so many worker processes on this machine for 'local'."""
    try:
        from distributed import Client, LocalCluster
    except ImportError:
        raise InvalidInput("--scheduler: needs dask.distributed; run 'pip install vorogeo[dask]'.") from None
    if address != "local":
        try:
            client = Client(address, timeout=_SECONDS)
        except (OSError, ValueError) as error:
            raise InvalidInput(f"--scheduler {address}: cannot be reached ({error}).") from None
        with client:
            yield client
        return
    cluster = LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None)
    with cluster, Client(cluster) as client:
        yield client


def _absolute(job: Job) -> Job:
    """The job for a process in another folder: names of files, also among the points, begin at the root."""
    options = dict(job.options)
    for name in ("mask", "metric", "index", "with", "regions", "region"):
        if isinstance(options.get(name), str):  # of cut, a region is a number
            options[name] = os.path.abspath(options[name])
    for name in ("from", "to", "points", "at", "curve", "inside"):
        if options.get(name):
            options[name] = [os.path.abspath(word) if os.path.isfile(word) else word for word in options[name]]
    return replace(job, mesh=os.path.abspath(job.mesh), out=job.out and os.path.abspath(job.out), options=options)


def run_many(jobs: list[Job], address: str, workers: int) -> Iterator[tuple[Job, bool, str]]:
    """Each job in a process of its own that a worker starts; as they end: whether it succeeded, and its line."""
    from distributed import as_completed

    with _client(address, workers) as client:
        running = {client.submit(run_in_own_process, _absolute(job), pure=False, retries=_RETRIES): job for job in jobs}
        for done in as_completed(list(running)):
            job = running[done]
            if done.status == "finished":
                succeeded, line = done.result()
            else:
                succeeded, line = False, f"its workers were lost ({done.status})"
            yield job, succeeded, line.replace(os.path.abspath(job.out), job.out) if job.out else line


def run_one(job: Job, address: str, workers: int) -> str:
    """One job: a matrix of all vertices by blocks of rows on all workers, anything else on one of them."""
    if job.command == "matrix" and not job.options.get("to") and format_of(Path(job.out)) == ".npy":
        return _matrix_by_rows(job, address, workers)
    for _, succeeded, line in run_many([job], address, workers):
        if succeeded:
            return line
        raise Error(line)
    raise Error("the scheduler returned nothing")


def _matrix_by_rows(job: Job, address: str, workers: int) -> str:
    from distributed import as_completed

    began = time.perf_counter()
    task = MeshTask(job)
    if task.options.get("points"):
        points = task.points("points")
        if not isinstance(points, np.ndarray):
            raise InvalidInput("--points: over a scheduler, give vertex ids.")
        ids = points.astype(np.int32)
    else:
        ids = np.arange(len(task.vertices), dtype=np.int32)
    columns = ids if task.options.get("points") else None
    entries = "pairs" if task.options.get("entries") == "pairs" else "fields"
    dtype = np.dtype(task.dtype)
    beside = os.path.dirname(os.path.abspath(job.out))  # on the file system that the workers share
    with tempfile.TemporaryDirectory(prefix=".vorogeo-", dir=beside) as folder, _client(address, workers) as client:
        files = write_files(task.index, folder)
        blocks = blocks_of(len(ids), len(ids), dtype.itemsize, None)
        with matrix(len(ids), len(ids), job.out, None, dtype) as out:
            at_once = 4 * max(1, len(client.scheduler_info(n_workers=-1)["workers"]))
            waiting = iter(blocks)
            running: dict[Any, tuple[int, int]] = {}

            def submit() -> Any:
                for block in waiting:
                    rows = ids[slice(*block)]
                    asked = files, rows, columns, task.dtype, task.method, entries
                    future = client.submit(matrix_rows, *asked, pure=False, retries=_RETRIES)
                    running[future] = block
                    return future
                return None

            first = [submit() for _ in range(min(at_once, len(blocks)))]
            finished = as_completed(first)
            for done in finished:
                out[slice(*running.pop(done))] = done.result()
                done.release()
                following = submit()
                if following is not None:
                    finished.add(following)
    text = f"{len(ids)} x {len(ids)} distances, {dtype}, in {len(blocks)} blocks"
    return told(job, text, {"shape": [len(ids), len(ids)], "blocks": len(blocks)}, time.perf_counter() - began)
