"""The program ``vorogeo``: reads the command line, runs its jobs, and turns errors into a line and a status."""

from __future__ import annotations

import glob
import io
import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..errors import InvalidInput
from . import batch, completion, doctor
from .job import Job
from .options import parser
from .worker import failure, run

_PRINTED = (
    "distance",
    "path",
    "through",
    "loop",
    "girth",
    "area",
    "sets",
    "polygon",
    "spline",
    "mean",
    "compare",
    "info",
)
#: A position that begins with a number below 0, which argparse would take for an option.
_NEGATIVE = re.compile(r"-[\d.][\d.eE+-]*(,[\d.eE+-]+)+")
_ENDINGS = {"index": ".vgi", "neighbours": ".npz", "profile": ".csv", "cut": ".ply", "cut-locus": ".ply"}
_NOT_IN_JOBS = ("command", "mesh", "out", "format", "jobs", "scheduler", "overwrite", "quiet", "version")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the program with these arguments, those of the process if None; its exit status."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")  # a name may have characters that it cannot hold
    whole = parser()
    words = sys.argv[1:] if arguments is None else arguments
    try:
        given = whole.parse_args([f" {word}" if _NEGATIVE.fullmatch(word) else word for word in words])
    except SystemExit as end:
        return int(end.code or 0)
    if given.version:
        from .. import __version__

        print(f"vorogeo {__version__}")
        return 0
    if given.command is None:
        whole.print_usage(sys.stderr)
        print("vorogeo: error: no command given (see vorogeo --help)", file=sys.stderr)
        return 2
    try:
        return _run(given)
    except KeyboardInterrupt:
        print("vorogeo: interrupted", file=sys.stderr)
        return 130
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except Exception as error:
        sentence = failure(error)
        print(f"vorogeo: error: {sentence}", file=sys.stderr)
        if given.json:
            batch.print_object(given.command, [], [(", ".join(given.mesh), sentence)])
        return 1


def _run(given: Any) -> int:
    if given.command == "doctor":
        doctor.tell(given.json)
        return 0
    if given.command == "completion":
        print(completion.script(given.shell), end="")
        return 0
    meshes = batch.mesh_files(given.mesh)
    options = {name: value for name, value in vars(given).items() if name not in _NOT_IN_JOBS}
    options["progress"] = not given.quiet
    many = len(meshes) > 1 or any(Path(word).is_dir() or glob.has_magic(word) for word in given.mesh)
    folder = given.out is not None and (
        many or given.out.endswith((os.sep, os.altsep or os.sep)) or Path(given.out).is_dir()
    )
    if not folder and not many:
        return _run_one(given, meshes[0], options)
    if not given.out:
        if given.command == "info":
            return _report(given, [Job("info", str(mesh), "", options) for mesh in meshes], 0)
        raise InvalidInput("--out: is missing; give a folder for the results of several meshes.")
    if given.index and len(meshes) > 1:
        raise InvalidInput("--index: is the index of one mesh, but there are several.")
    return _run_many(given, meshes, options)


def _ending(given: Any) -> str:
    ending = _ENDINGS.get(given.command, ".npy")
    return f".{given.format}" if given.format and ending != ".vgi" else ending


def _run_one(given: Any, mesh: Path, options: dict[str, Any]) -> int:
    if given.out is None and given.command in _PRINTED:
        target = ""
    elif given.out is None:
        target = f"{mesh.name.removesuffix('.gz').removesuffix(mesh.suffix)}-{given.command}{_ending(given)}"
    else:
        target = given.out
    job = Job(given.command, str(mesh), target, options)
    if given.scheduler:
        from . import cluster

        line = cluster.run_one(job, given.scheduler, given.jobs)
    else:
        line = run(job)
    if given.json:
        batch.print_object(job.command, [(job, line)], [])
    elif not given.quiet or not target:
        print(line)
    return 0


def _run_many(given: Any, meshes: list[Path], options: dict[str, Any]) -> int:
    ending, folder = _ending(given), Path(given.out)
    places = batch.targets(meshes, folder, ending)
    lasting = {name: value for name, value in options.items() if name not in ("threads", "progress", "json")}
    batch.prepare_folder(folder, {"command": given.command, "format": ending[1:], **lasting}, given.overwrite)
    options["progress"] = False
    if options.get("threads") is None:
        options["threads"] = max(1, batch.cores() // given.jobs)
    todo = [mesh for mesh in meshes if given.overwrite or not batch.is_done(mesh, places[mesh])]
    jobs = [Job(given.command, str(mesh), str(places[mesh]), options) for mesh in todo]
    return _report(given, jobs, len(meshes) - len(todo))


def _report(given: Any, jobs: list[Job], kept: int) -> int:
    if given.scheduler:
        from . import cluster

        ended = cluster.run_many(jobs, given.scheduler, given.jobs)
    else:
        ended = batch.in_processes(jobs, given.jobs)
    return batch.report(ended, len(jobs), kept, given.quiet, given.command if given.json else "")
