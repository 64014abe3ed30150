"""The options of the command line and their help."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import Any

from .._arguments import MAX_THREADS
from ..geodesic_methods import methods

_PAGE = """\
Geodesic distances on triangle meshes: lengths of shortest paths over the surface.

commands, each with a page of its own (vorogeo COMMAND --help):
  field        distance of every vertex from the nearest source
  distance     distances of pairs of points
  path         shortest paths between points
  matrix       distances between all vertices, or between chosen points
  neighbours   all pairs within a radius, as a sparse matrix
  voronoi      the nearest source of every vertex and face
  sample       vertices spread evenly over the surface
  index        the index of a mesh in a file, to use it again
  compare      errors and times against exact distances
  info         what a mesh contains"""

_EPILOG = """\
meshes
  Any file that meshio or PyMeshLab reads; with nibabel also GIFTI and FreeSurfer surfaces. Several files, patterns in
  quotes and folders are worked through one by one, each in a process of its own; results go to the folder --out. What
  is there already is kept, so a run that was stopped goes on where it was. A mesh that fails is reported at the end.

points
  Vertex ids (17), positions moved to the surface (0.1,2,3.5; --from=-1,0,2 if the first is negative), or files with
  ids or positions: .npy, .txt, .csv, or a mesh, whose vertices are taken.

results
  The ending of --out chooses: .npy, .npz (all arrays of a result), .mat, .csv, .ply (the mesh with the values as
  quality, or lines), .gii (a value for each vertex). Files appear whole or not at all.

metrics
  --metric, --slope-penalty or --curvature-weight: distances, radii and areas are then costs, as docs/metrics.md says.

exit status
  0: all is done; 1: a mesh or a file could not be used; 2: the command line is wrong; 130: interrupted.

examples
  vorogeo field bunny.ply --from 0 --out field.ply
  vorogeo distance bunny.ply --from 0 --to 17 18 19
  vorogeo matrix 'shapes/*.off' --out out/ --dtype float32 --normalise sqrt-area --jobs 2
  vorogeo neighbours lh.midthickness.gii --radius 10 --mask roi.shape.gii --out near.npz
  vorogeo matrix cortex.gii --dtype float32 --scheduler tcp://10.0.0.5:8786 --out cortex.npy"""


class _OneLineErrors(argparse.ArgumentParser):
    """A parser whose errors are one line."""

    def error(self, message: str) -> Any:
        self.exit(2, f"{self.prog}: error: {message} (see {self.prog} --help)\n")


def _number(kind: type, low: float, high: float, what: str) -> Callable[[str], Any]:
    def read(text: str) -> Any:
        try:
            value = kind(text)
        except ValueError:
            value = None
        if value is None or not low <= value <= high:
            raise argparse.ArgumentTypeError(f"{text!r} is not {what}")
        return value

    return read


_LENGTH = _number(float, 0, float("inf"), "a length of 0 or more")
_COUNT = _number(int, 1, 2**31 - 1, "a whole number from 1 on")


def parser() -> argparse.ArgumentParser:
    """The parser of the whole command line."""
    whole = _OneLineErrors(
        prog="vorogeo",
        description=_PAGE,
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        usage="vorogeo COMMAND MESH... [options]",
    )
    whole.add_argument("--version", action="store_true", help="print the version")
    commands = whole.add_subparsers(
        dest="command", metavar="COMMAND", prog="vorogeo", help=argparse.SUPPRESS, parser_class=_OneLineErrors
    )

    field = _command(commands, "field", "Distance of every vertex from the nearest source.", "--from POINT...")
    _points(field, "--from", True, "the sources")
    field.add_argument("--max-distance", type=_LENGTH, metavar="L", help="distances above it become infinite")

    for name, text in (
        ("distance", "Distances of pairs of points; without --out they are printed."),
        ("path", "Shortest paths between points; without --out their lengths are printed."),
    ):
        pairs = _command(commands, name, text, "--from POINT... --to POINT...")
        _points(pairs, "--from", True, "where they begin")
        _points(pairs, "--to", True, "where they end; one start may have many ends, or one end many starts")

    matrix = _command(commands, "matrix", "Distances between all vertices, or between chosen points.")
    _points(matrix, "--points", False, "rows, and columns without --to; default: all vertices")
    _points(matrix, "--to", False, "columns")
    matrix.add_argument(
        "--method", choices=("automatic", "pairs", "fields"), default="automatic", help="how it is filled"
    )

    near = _command(
        commands, "neighbours", "All pairs of points within a radius, as a sparse matrix (.npz of scipy).", "--radius L"
    )
    near.add_argument("--radius", type=_LENGTH, required=True, metavar="L", help="in the unit of the mesh")
    _points(near, "--points", False, "the points; default: all vertices")

    regions = _command(
        commands, "voronoi", "The nearest source of every vertex and face, areas and borders.", "--from POINT..."
    )
    _points(regions, "--from", True, "the sources")

    sample = _command(commands, "sample", "Vertices spread evenly over the surface.")
    sample.add_argument("--count", type=_COUNT, metavar="K", help="how many (farthest)")
    sample.add_argument(
        "--radius", type=_LENGTH, metavar="L", help="stop when every vertex is this near; or least distance (poisson)"
    )
    sample.add_argument(
        "--method", choices=("farthest", "poisson"), default="farthest", help="default: farthest point sampling"
    )
    sample.add_argument("--seed", type=_number(int, 0, 2**64 - 1, "a seed of 0 or more"), default=0, metavar="N")

    _command(commands, "index", "Build the index and write it to a file (.vgi), for --index of other commands.")

    compare = _command(
        commands,
        "compare",
        "Errors and times of the index, of other methods, or of a field made elsewhere, against the exact field.",
        "--from POINT...",
    )
    _points(compare, "--from", True, "the sources")
    what = compare.add_mutually_exclusive_group()
    what.add_argument(
        "--methods",
        nargs="+",
        choices=("all", *methods),
        metavar="NAME",
        help=f"compared one below the other, instead of the index (vorogeo): all, {', '.join(methods)}",
    )
    what.add_argument("--with", metavar="FILE", help="a .npy file with a field made elsewhere, instead of the index")

    _command(commands, "info", "What a mesh contains, and what a user should know before trusting distances on it.")
    return whole


def _points(command: argparse.ArgumentParser, name: str, needed: bool, text: str) -> None:
    command.add_argument(name, nargs="+", action="extend", required=needed, metavar="POINT", help=text)


def _command(commands: Any, name: str, text: str, needed: str = "") -> argparse.ArgumentParser:
    command: argparse.ArgumentParser = commands.add_parser(
        name,
        usage=" ".join(filter(None, [f"vorogeo {name} MESH...", needed, "[options]"])),
        description=text,
        epilog="Meshes, points, metrics, results and exit status: vorogeo --help",
    )
    command.add_argument("mesh", nargs="+", metavar="MESH", help="files, patterns or folders")
    command.add_argument(
        "--out", metavar="PLACE", help="a file, or for several meshes a folder; default: MESH-COMMAND.npy here"
    )
    command.add_argument(
        "--format",
        choices=("npy", "npz", "mat", "csv", "ply", "gii"),
        help="of files in a folder; default: npy, of neighbours npz",
    )
    command.add_argument("--dtype", choices=("float64", "float32"), default="float64", help="of distances")
    command.add_argument(
        "--exact", action="store_true", help="exact propagation instead of the index: slower, no errors"
    )
    command.add_argument(
        "--normalise",
        choices=("none", "sqrt-area"),
        default="none",
        help="sqrt-area: scale the mesh to area 1, so lengths are parts of its root",
    )
    command.add_argument(
        "--mask",
        metavar="FILE",
        help="what belongs to the surface: labels, an annotation, GIFTI or .npy, with a value for each vertex",
    )
    command.add_argument(
        "--gap",
        type=_LENGTH,
        default=0.0,
        metavar="LENGTH",
        help="bridge gaps up to this width, in the unit of --normalise; default 0: none",
    )
    metric = command.add_mutually_exclusive_group()
    metric.add_argument(
        "--metric",
        metavar="FILE",
        help="what a step costs, so that paths are the cheapest: a number above 0 for each vertex or face (.npy, "
        ".txt, .csv, GIFTI), or a tensor (.npy of shape (n, 3, 3))",
    )
    metric.add_argument(
        "--slope-penalty", type=_LENGTH, metavar="P", help="terrain, z upwards: a step costs 1 + P sin(slope)"
    )
    metric.add_argument(
        "--curvature-weight",
        type=_number(float, float("-inf"), float("inf"), "a number"),
        metavar="W",
        help="a step across limbs, ridges and valleys costs up to sqrt(1 + W)",
    )
    command.add_argument(
        "--index",
        metavar="FILE",
        help="an index of this mesh from 'vorogeo index', with the same --normalise, --mask, --gap and metric",
    )
    command.add_argument(
        "--patches",
        nargs=2,
        type=_number(int, 0, 2**31 - 1, "a number of patches"),
        metavar="N",
        help="numbers of patches of the index; default: chosen",
    )
    command.add_argument(
        "--delta",
        type=_number(float, 0, 1, "a number from 0 to below 1"),
        default=0.0,
        metavar="D",
        help="error that pruning the index may add",
    )
    command.add_argument("--memory-budget", type=_COUNT, metavar="MIB", help="what the index may take; default 4096")
    command.add_argument(
        "--threads",
        type=_number(int, 1, MAX_THREADS, "a number of threads"),
        metavar="N",
        help="for each mesh; default: cores shared by the jobs",
    )
    command.add_argument(
        "--jobs", type=_COUNT, default=1, metavar="N", help="meshes, or processes of --scheduler local, at a time"
    )
    command.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="tcp://HOST:PORT of a dask.distributed scheduler whose workers see the same files, or 'local'",
    )
    command.add_argument("--overwrite", action="store_true", help="compute results again that are already there")
    command.add_argument("--quiet", action="store_true", help="print errors only, and no progress")
    return command
