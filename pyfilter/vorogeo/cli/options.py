"""The options of the command line and their help, as tables."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from typing import Any

from .._arguments import MAX_THREADS
from ..geodesic_methods import methods

_EPILOG = """\
meshes
  Any file that meshio or PyMeshLab reads; with nibabel also GIFTI and FreeSurfer surfaces. Several files, patterns in
  quotes and folders are worked through one by one, each in a process of its own; results go to the folder --out. What
  is there already is kept, so a run that was stopped goes on where it was. A mesh that fails is reported at the end.

points
  Vertex ids (17), positions moved to the surface (0.1,2,3.5), or files with ids or positions: .npy, .txt, .csv, or a
  mesh, whose vertices are taken.

results
  The ending of --out chooses: .npy, .npz (all arrays of a result), .mat, .csv, .ply (the mesh with the values as
  quality, or lines), .gii (a value for each vertex). Files appear whole or not at all.

metrics
  With --metric, --slope-penalty, --hiking or --curvature-weight, distances, radii and areas are in the unit of that
  cost. With --hiking and in a wind, ways back cost something else: all is exact then, and --to asks for the ways to
  points.

json
  With --json, one object on the standard output: "command", "results" (of each mesh "mesh", "out", "seconds" and what
  would be printed, as numbers), "failed" ("mesh", "error") and "kept", how many were there already. Where no path
  leads, null. Errors are on the standard error as well.

exit status
  0: all is done; 1: a mesh or a file could not be used; 2: the command line is wrong; 130: interrupted.

examples
  vorogeo field bunny.ply --from 0 --out field.ply
  vorogeo distance bunny.ply --from 0 --to 17 18 19
  vorogeo matrix 'shapes/*.off' --out out/ --dtype float32 --normalise sqrt-area --jobs 2
  vorogeo distance bunny.ply --from 0 --to 17 --json | jq '.results[0].distance[0]'
  vorogeo girth body.ply --at 0.1,1.2,0 --normal 0,1,0
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


def _vector(text: str) -> list[float]:
    """Three numbers; a list, as options are kept in JSON."""
    try:
        x, y, z = (float(number) for number in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a vector x,y,z") from None
    return [x, y, z]


def _pace(text: str) -> str | list[float]:
    """The name of a law, or what a unit of height costs up and down."""
    if text in ("tobler", "naismith"):
        return text
    try:
        up, down = (float(number) for number in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not tobler, naismith or two numbers UP,DOWN") from None
    return [up, down]


_LENGTH = _number(float, 0, float("inf"), "a length of 0 or more")
_COUNT = _number(int, 1, 2**31 - 1, "a whole number from 1 on")
_SEED = _number(int, 0, 2**64 - 1, "a seed of 0 or more")
_REGION = _number(int, 0, 2**31 - 1, "the number of a region")
_PATCHES = _number(int, 0, 2**31 - 1, "a number of patches")
_THREADS = _number(int, 1, MAX_THREADS, "a number of threads")
_ENTRIES = ("automatic", "pairs", "fields")
_FORMATS = ("npy", "npz", "mat", "csv", "ply", "gii")

#: By the word that stands for what an option takes; "": nothing.
_TAKES: dict[str, dict[str, Any]] = {
    "": {"action": "store_true"},
    "POINT": {"nargs": "+", "action": "extend", "type": str.strip},
    "L": {"type": _LENGTH},
    "X,Y,Z": {"type": _vector},
    "P": {"type": _LENGTH},
    "PACE": {"type": _pace},
    "W": {"type": _number(float, float("-inf"), float("inf"), "a number")},
    "D": {"type": _number(float, 0, 1, "a number from 0 to below 1"), "default": 0.0},
    "K": {"type": _COUNT},
    "MIB": {"type": _COUNT},
}

#: What argparse takes; those in a list exclude one another.
_Option = tuple[str, dict[str, Any]]
_Options = Sequence[_Option | list[_Option]]


def _option(usage: str, text: str, **how: Any) -> _Option:
    """An option as it is written, such as "--mask FILE"; one of choices is written without a word for what it takes."""
    name, _, word = usage.partition(" ")
    takes = {} if "choices" in how and not word else _TAKES.get(word, {})
    return name, {"help": text, **takes, **({"metavar": word} if word else {}), **how}


_JSON = _option(
    "--json", "one JSON object on the standard output instead of lines; progress and errors stay on the other"
)
_SOURCES = _option("--from POINT", "the sources", required=True)
_FROM_OR_TO = [
    _option("--from POINT", "the sources", required=True),
    _option("--to POINT", "instead: by the ways to these", required=True),
]
_PAIRS = (
    _option("--from POINT", "where they begin", required=True),
    _option("--to POINT", "where they end; one start may have many ends, or one end many starts", required=True),
)

_THROUGH = (
    _option("--points POINT", "in order", required=True),
    _option("--closed", "and from the last back to the first"),
    _option("--guides", "the points between the ends are guides only: the locally shortest path, as they lead"),
)

#: By command: what it does, what it needs besides a mesh, and its own options.
_COMMANDS: dict[str, tuple[str, str, _Options]] = {
    "field": (
        "Distance of every vertex from the nearest source, or to it.",
        "--from POINT...",
        (_FROM_OR_TO, _option("--max-distance L", "distances above it become infinite")),
    ),
    "distance": (
        "Distances of pairs of points; without --out they are printed.",
        "--from POINT... --to POINT...",
        _PAIRS,
    ),
    "path": (
        "Shortest paths between points; without --out their lengths are printed.",
        "--from POINT... --to POINT...",
        _PAIRS,
    ),
    "matrix": (
        "Distances between all vertices, or between chosen points.",
        "",
        (
            _option("--points POINT", "rows, and columns without --to; default: all vertices"),
            _option("--to POINT", "columns"),
            _option("--entries", "what they are computed from", choices=_ENTRIES, default="automatic"),
            # Scripts written for 0.2.1 say --method; accepted for one release.
            _option("--method", argparse.SUPPRESS, choices=_ENTRIES, dest="entries", default=argparse.SUPPRESS),
        ),
    ),
    "neighbours": (
        "All pairs of points within a radius, as a sparse matrix (.npz of scipy).",
        "--radius L",
        (
            _option("--radius L", "in the unit of the mesh", required=True),
            _option("--points POINT", "the points; default: all vertices"),
        ),
    ),
    "voronoi": ("The nearest source of every vertex and face, areas and borders.", "--from POINT...", (_FROM_OR_TO,)),
    "sample": (
        "Vertices spread evenly over the surface.",
        "",
        (
            _option("--count K", "how many (farthest)"),
            _option("--radius L", "stop when every vertex is this near; or least distance (poisson)"),
            _option(
                "--method", "default: farthest point sampling", choices=("farthest", "poisson"), default="farthest"
            ),
            _option("--seed N", "of random numbers; default 0", type=_SEED, default=0),
        ),
    ),
    "through": ("The path through points; without --out its length is printed.", "--points POINT...", _THROUGH),
    "loop": (
        "The shortest loop through a point, or a curve pulled tight; without --out its length is printed.",
        "",
        (
            _option("--at POINT", "the point"),
            _option(
                "--curve POINT", "a closed curve through these, which is pulled tight; with --at: to go round like"
            ),
        ),
    ),
    "girth": (
        "How far it is round a limb by section, tape and loop; without --out they are printed.",
        "--at POINT",
        (
            _option("--at POINT", "the point", required=True),
            _option("--normal X,Y,Z", "of the plane of the section; default: of the shortest one there"),
        ),
    ),
    "area": (
        "Area near points or a curve, inside a curve or of regions, and the length of its border; without --out they "
        "are printed.",
        "",
        (
            [
                _option("--from POINT", "the points, with --radius"),
                _option("--to POINT", "the points, by the ways to them"),
                _option("--curve POINT", "in order; with --radius, the path through them"),
                _option("--inside POINT", "in order; the path through them and back to the first"),
                _option("--regions FILE", "of each vertex or face the number of its region (.npy, .txt, .csv, GIFTI)"),
            ],
            _option("--radius L", "how far, in the unit of the mesh"),
            _option("--closed", "the curve leads back to the first point"),
        ),
    ),
    "sets": (
        "Nearest, mean and Hausdorff distance of two sets of points; without --out they are printed.",
        "--from POINT... --to POINT...",
        (
            _option("--from POINT", "the first set", required=True),
            _option("--to POINT", "the second set", required=True),
        ),
    ),
    "polygon": (
        "Area and perimeter of a polygon of shortest paths; without --out they are printed.",
        "--points POINT...",
        (
            _option("--points POINT", "in order", required=True),
            _option("--hull", "of the points in any order the convex hull"),
        ),
    ),
    "profile": (
        "Height, slope, curvature and thickness along the path through points (.csv).",
        "--points POINT...",
        (*_THROUGH, _option("--up X,Y,Z", "the direction in which heights count; default 0,0,1")),
    ),
    "cut": (
        "The mesh cut along the path through points, or at distances from sources (.ply, .npz).",
        "",
        (
            _option("--points POINT", "in order; a path through them is the line"),
            *_THROUGH[1:],
            [_option("--from POINT", "the sources"), _option("--to POINT", "instead: by the ways to these")],
            _option("--levels L", "distances from the sources", nargs="+"),
            _option(
                "--region N", "this part only; default: all, with the part of each face as its quality", type=_REGION
            ),
        ),
    ),
    "directions": (
        "Where all vertices lie as seen from a point: vectors in its frame; in a .ply, quality is their angle.",
        "--at POINT",
        (
            _option("--at POINT", "the point", required=True),
            _option(
                "--max-distance L", "of vectors; a .ply then has texture coordinates, of a picture of twice this width"
            ),
        ),
    ),
    "signed": (
        "Distance of every vertex from a closed curve or the border of a region; negative inside.",
        "",
        (
            [
                _option("--curve POINT", "in order; the path through them and back to the first"),
                _option("--region FILE", "of each face 0 outside and another number inside (.npy, .txt, .csv)"),
            ],
            _option("--max-distance L", "distances above it become infinite"),
        ),
    ),
    "spline": (
        "The smooth curve through points; without --out its length is printed.",
        "--points POINT...",
        (
            _option("--points POINT", "in order", required=True),
            _option("--closed", "and from the last back to the first"),
            _option("--near", "a smoother one, near the points between the ends (B-spline)"),
        ),
    ),
    "mean": (
        "The point in the middle of points; without --out it is printed.",
        "--points POINT...",
        (
            _option("--points POINT", "the points", required=True),
            _option("--median", "the least sum of distances, not of their squares"),
        ),
    ),
    "clusters": (
        "Clusters of all vertices or of points around their means; in a .ply, quality is the number of the cluster.",
        "--count K",
        (
            _option("--count K", "how many", required=True),
            _option("--points POINT", "the points; default: all vertices"),
            _option("--medoids", "the least sum of distances, not of their squares; centres are among the points"),
            _option("--seed N", "of random numbers; default 0", type=_SEED, default=0),
        ),
    ),
    "cut-locus": (
        "Where several shortest paths from points end, as lines (.ply).",
        "--from POINT...",
        (
            _SOURCES,
            _option(
                "--min-angle A",
                "ends of lines are left out up to where directions differ by so many degrees; default 0",
                type=_number(float, 0, 180, "an angle from 0 to 180 degrees"),
                default=0.0,
            ),
            _option("--max-distance L", "only within this distance"),
        ),
    ),
    "index": ("Build the index and write it to a file (.vgi), for --index of other commands.", "", ()),
    "compare": (
        "Errors and times of the index, of other methods, or of a field made elsewhere, against the exact field.",
        "--from POINT...",
        (
            _SOURCES,
            [
                _option(
                    "--methods NAME",
                    f"compared one below the other, instead of the index (vorogeo): all, {', '.join(methods)}",
                    nargs="+",
                    choices=("all", *methods),
                ),
                _option("--with FILE", "a .npy file with a field made elsewhere, instead of the index"),
            ],
        ),
    ),
    "info": ("What a mesh contains, and what a user should know before trusting distances on it.", "", ()),
}

#: Of every command.
_COMMON: _Options = (
    _option("mesh MESH", "files, patterns or folders", nargs="+"),
    _option("--out PLACE", "a file, or for several meshes a folder; default: MESH-COMMAND.npy here"),
    _option(
        "--format",
        "of files in a folder; default: npy; neighbours npz, profile csv, cut and cut-locus ply",
        choices=_FORMATS,
    ),
    _option("--dtype", "of distances", choices=("float64", "float32"), default="float64"),
    _option("--exact", "never from an index, which is built where it pays: slower for many answers, no errors"),
    _option(
        "--normalise",
        "sqrt-area: scale the mesh to area 1, so lengths are parts of its root",
        choices=("none", "sqrt-area"),
        default="none",
    ),
    _option(
        "--mask FILE",
        "what belongs to the surface: labels, an annotation, GIFTI or .npy, with a value for each vertex",
    ),
    _option("--max-snap L", "how far a position may be from the surface, or it is an error; default: any distance"),
    _option("--gap L", "bridge gaps up to this width, in the unit of --normalise; default 0: none", default=0.0),
    [
        _option(
            "--metric FILE",
            "what a step costs, so that paths are the cheapest: a number above 0 for each vertex or face (.npy, "
            ".txt, .csv, GIFTI), a tensor (.npy of shape (n, 3, 3)), or a wind in each face, for what moves at speed 1",
        ),
        _option("--slope-penalty P", "terrain, z upwards: a step costs 1 + P sin(slope)"),
        _option(
            "--hiking PACE",
            "terrain, z upwards, one cost up and another down: seconds by tobler or naismith on metres, or UP,DOWN: "
            "length, and so much more for each unit of height",
        ),
        _option("--curvature-weight W", "a step across limbs, ridges and valleys costs up to sqrt(1 + W)"),
    ],
    _option(
        "--index FILE",
        "an index of this mesh from 'vorogeo index', with the same --normalise, --mask, --gap and metric",
    ),
    _option(
        "--patches N",
        "build an index of so many patches, also where it does not pay; default: chosen",
        nargs=2,
        type=_PATCHES,
    ),
    _option("--delta D", "above 0: build an index, also where it does not pay, and prune it with so much more error"),
    _option("--memory-budget MIB", "what the index may take; default 4096"),
    _option("--threads N", "for each mesh; default: cores shared by the jobs", type=_THREADS),
    _option("--jobs N", "meshes, or processes of --scheduler local, at a time", type=_COUNT, default=1),
    _option(
        "--scheduler ADDRESS",
        "tcp://HOST:PORT of a dask.distributed scheduler whose workers see the same files, or 'local'",
    ),
    _option("--overwrite", "compute results again that are already there"),
    _option("--quiet", "print errors only, and no progress"),
    _JSON,
)

#: Commands without a mesh, as the others.
_WITHOUT_MESH: dict[str, tuple[str, str, _Options]] = {
    "doctor": ("Versions, the filters of PyMeshLab or why they are missing, and the processor.", "", (_JSON,)),
    "completion": (
        "The script that completes commands and options in a shell.",
        "SHELL",
        (_option("shell", "which", choices=("bash", "zsh", "fish")),),
    ),
}
_ALL = _COMMANDS | _WITHOUT_MESH


def options_of(command: str) -> dict[str, dict[str, Any]]:
    """What --help shows of a command, by name, as argparse describes it."""
    own = _ALL[command][2] if command in _WITHOUT_MESH else [*_COMMON, *_ALL[command][2]]
    each = dict(one for option in own for one in (option if isinstance(option, list) else [option]))
    return {name: how for name, how in each.items() if how["help"] != argparse.SUPPRESS}


def commands() -> dict[str, str]:
    """What each command does."""
    return {name: text for name, (text, *_) in _ALL.items()}


def parser() -> argparse.ArgumentParser:
    """The parser of the whole command line."""
    page = ["Geodesic distances on triangle meshes: lengths of shortest paths over the surface.", ""]
    page += ["commands, each with a page of its own (vorogeo COMMAND --help):"]
    page += [f"  {name:<12} {text[0].lower()}{text[1:].split(';')[0].rstrip('.')}" for name, text in commands().items()]
    whole = _OneLineErrors(
        prog="vorogeo",
        description="\n".join(page),
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        usage="vorogeo COMMAND MESH... [options]",
    )
    whole.add_argument("--version", action="store_true", help="print the version")
    added = whole.add_subparsers(
        dest="command", metavar="COMMAND", prog="vorogeo", help=argparse.SUPPRESS, parser_class=_OneLineErrors
    )
    for name, (text, needed, own) in _ALL.items():
        alone = name in _WITHOUT_MESH
        command = added.add_parser(
            name,
            usage=" ".join(filter(None, [f"vorogeo {name}", "" if alone else "MESH...", needed, "[options]"])),
            description=text,
            epilog="Meshes, points, metrics, results and exit status: vorogeo --help",
        )
        _add(command, own if alone else [*_COMMON, *own])
        if alone:
            command.set_defaults(mesh=[], json=False)
    return whole


def _add(command: Any, options: _Options) -> None:
    for option in options:
        if isinstance(option, list):
            needed = all(how.get("required") for _, how in option)
            each = [(name, {**how, "required": False}) for name, how in option]
            _add(command.add_mutually_exclusive_group(required=needed), each)
        else:
            command.add_argument(option[0], **option[1])
