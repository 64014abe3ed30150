"""Many meshes: which they are, where their results go, what is done already, and what failed."""

from __future__ import annotations

import glob
import json
import os
import sys
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

from ..errors import FileError, InvalidInput
from ..mesh_files import FREESURFER
from .job import Job
from .outputs import whole_file
from .worker import run_in_own_process

#: In the folder of results: the options that they were made with.
RECORD = "vorogeo.json"
_ENDINGS = {".gii", ".mesh", ".obj", ".off", ".ply", ".stl", ".vtk", ".vtp", ".vtu", *FREESURFER}


def mesh_files(words: list[str]) -> list[Path]:
    """The files that names, patterns and folders stand for, each once; every pattern and folder holds a mesh."""
    found: list[Path] = []
    for word in words:
        path = Path(word)
        if path.is_dir():
            some = sorted(
                file for file in path.iterdir() if file.suffix.lower() in _ENDINGS or file.name.endswith(".gii.gz")
            )
        elif glob.has_magic(word) and not path.exists():
            some = [Path(name) for name in sorted(glob.glob(word, recursive=True)) if os.path.isfile(name)]
        else:
            some = [path]
        if not some:
            raise InvalidInput(f"{word}: there is no mesh; give files, a folder, or a pattern in quotes.")
        found += some
    return list(dict.fromkeys(found))


def targets(meshes: list[Path], folder: Path, ending: str) -> dict[Path, Path]:
    """Where the result of each mesh goes; no two go into one file."""
    chosen: dict[Path, Path] = {}
    for mesh in meshes:
        name = mesh.name.removesuffix(".gz")
        suffix = Path(name).suffix
        is_format = suffix.lower() in _ENDINGS.difference(FREESURFER)  # lh.white and lh.pial differ in nothing else
        stem = name.removesuffix(suffix) if is_format else name
        target = folder / f"{stem}{ending}"
        if target in chosen:
            raise InvalidInput(f"{chosen[target]} and {mesh} would both go into {target}; give them in two runs.")
        chosen[target] = mesh
    return {mesh: target for target, mesh in chosen.items()}


def prepare_folder(folder: Path, options: dict[str, object], overwrite: bool) -> None:
    """Make the folder of results, and write down the options; results of other options are not mixed with these."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(f"{folder}: cannot be made ({error.strerror}).") from None
    record = folder / RECORD
    if record.is_file() and not overwrite:
        before = json.loads(record.read_text())
        if "entries" in options:  # up to 0.2.1 they were called method
            before.setdefault("entries", before.pop("method", None))
        for name in sorted({*before, *options}):
            if before.get(name) != options.get(name):
                raise InvalidInput(
                    f"{folder}: holds results with {name} {before.get(name)!r}, not {options.get(name)!r}; give "
                    "another folder, or --overwrite."
                )
    with whole_file(record) as part:
        part.write_text(json.dumps(options, indent=1, sort_keys=True) + "\n")


def is_done(mesh: Path, target: Path) -> bool:
    """Whether the result is there and no older than its mesh."""
    try:
        return target.stat().st_mtime >= mesh.stat().st_mtime
    except OSError:
        return False


def in_processes(jobs: list[Job], at_once: int) -> Iterator[tuple[Job, bool, str]]:
    """Each job in a process of its own, some at a time; as they end: whether it succeeded, and its line."""
    with ThreadPoolExecutor(at_once) as pool:
        running = {pool.submit(run_in_own_process, job): job for job in jobs}
        try:
            for done in as_completed(running):
                yield running[done], *done.result()
        finally:
            for waiting in running:
                waiting.cancel()


def print_object(command: str, ended: list[tuple[Job, str]], failed: list[tuple[str, str]], kept: int = 0) -> None:
    """Print what a command with --json tells: of each mesh that ended its values, of each that failed its sentence."""
    results = [{"mesh": job.mesh, "out": job.out or None, **json.loads(line)} for job, line in ended]
    failures = [{"mesh": mesh, "error": sentence} for mesh, sentence in failed]
    print(json.dumps({"command": command, "results": results, "failed": failures, "kept": kept}))


def report(ended: Iterable[tuple[Job, bool, str]], count: int, kept: int, quiet: bool, json_of: str = "") -> int:
    """Tell what ended and, at the end, what failed, as the JSON of a command if one is named; the exit status."""
    finished: list[tuple[Job, str]] = []
    failed: list[tuple[Job, str]] = []
    bar = _bar(count, quiet)
    for job, succeeded, line in ended:
        if not succeeded:
            failed.append((job, line))
        elif json_of:
            finished.append((job, line))
        elif not quiet:
            print(line, flush=True)
        if bar is not None:
            bar.update()
    if bar is not None:
        bar.close()
    if json_of:
        print_object(json_of, finished, [(job.mesh, line) for job, line in failed], kept)
    elif not quiet:
        print(f"{count - len(failed)} done, {kept} kept, {len(failed)} failed")
    for job, line in failed:
        print(f"vorogeo: {line if job.mesh in line else f'{job.mesh}: {line}'}", file=sys.stderr)
    return 1 if failed else 0


def cores() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _bar(count: int, quiet: bool):  # type: ignore[no-untyped-def]
    if quiet or not sys.stderr.isatty():
        return None
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm(total=count, unit="mesh")
