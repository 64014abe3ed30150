"""What MeshLab's window is asked to do although it cannot be done, and the sentence that has to come."""

from __future__ import annotations

from dataclasses import dataclass, field

from filter_names import BUILD, EXACT_FROM_POINT, FROM_POINT, LOAD, SAVE

ISOLINES = "Isolines of a geodesic distance (VoroGeo)"
LAYER = "Geodesic distance from the points or lines of a layer (VoroGeo)"
PATH = "Shortest path between two points (VoroGeo)"


@dataclass
class BadInput:
    """A filter, applied to a layer of this name with these fields filled in, and a part of its sentence."""

    name: str
    filter: str
    sentence: str
    fields: dict[str, str] = field(default_factory=dict)
    layer: str = "terrain"


@dataclass
class NoPath:
    """What has an answer although no path leads everywhere, and the lines of the log that say so."""

    name: str
    filter: str
    lines: list[str]
    fields: dict[str, str]


def unreached(count: int) -> str:
    """What the log says about vertices that no path leads to."""
    return f"No path leads to {count} vertices, in other components than the sources; their quality is -1"


# On the layer "parts": two pieces of 80 vertices, and vertex 160 without a face.
NO_PATH = [
    NoPath(
        "path between components",
        PATH,
        ["No path: the points lie in different components"],
        {"Source vertex": "5", "Target vertex": "95"},
    ),
    NoPath(
        "start on another component",
        FROM_POINT,
        ["Distances from 1 source vertex to 80 vertices", unreached(81)],
        {"Start vertex": "95"},
    ),
    NoPath(
        "isolated start",
        FROM_POINT,
        ["Distances from 1 source vertex to 1 vertices, the largest 0", unreached(160)],
        {"Start vertex": "160"},
    ),
    NoPath(
        "isolated start, exact",
        EXACT_FROM_POINT,
        ["Distances from 1 source vertex to 1 vertices, the largest 0", unreached(160)],
        {"Start vertex": "160"},
    ),
]

# MeshLab removes such vertices when it opens a file; its own filter makes them in the layer "parts". Formulas for x.
GEOMETRIC_FUNCTION = "Per Vertex Geometric Function"
NOT_FINITE = {"NaN": "(vi == 37) ? 0/0 : x", "infinite": "(vi == 37) ? 1/0 : x"}
FINITE_AGAIN = "(vi == 37) ? 1 : x"
NOT_FINITE_SENTENCE = "Vertex 37 has a coordinate that is NaN or infinite; repair or remove it."

# In this order: what is refused before an index is there comes first. FOLDER stands for the folder of the scenario.
BAD_INPUT = [
    BadInput("no index to save", SAVE, "There is no index for this mesh as it is.", {"Index file": "FOLDER/new.vgi"}),
    BadInput(
        "vertex out of range", FROM_POINT, '"Start vertex" (vertex_index) is 999999, but', {"Start vertex": "999999"}
    ),
    BadInput("vertex below range", FROM_POINT, "numbered from 0 to 3499.", {"Start vertex": "-7"}),
    BadInput("negative limit", FROM_POINT, '"Max distance" (max_distance) is -1. Give', {"Max distance": "-1"}),
    BadInput("empty selection", "Geodesic distance from the selection (VoroGeo)", "No vertex is selected. Select the"),
    BadInput("no edge selected", "Geodesic distance from edges (VoroGeo)", "No edge is selected. Select edges"),
    BadInput("no quality", ISOLINES, "The vertices have no quality."),
    BadInput("matrix without points", "Geodesic distance matrix of the selection (VoroGeo)", "No vertex is selected."),
    BadInput("patches", BUILD, '"First-layer patches" (n1) is -3.', {"First-layer patches": "-3"}),
    BadInput("delta", BUILD, '"Delta" (delta) is 1.5. Give a number from 0 to below 1.', {"Delta": "1.5"}),
    BadInput("memory budget", BUILD, "memory budget is 1 MiB, but", {"Memory budget (MiB)": "1"}, "torus"),
    BadInput("threads", BUILD, '"Threads" (threads) is -1.', {"Threads": "-1"}),
    BadInput("no folder", BUILD, "there is no folder", {"Index file": "FOLDER/nowhere/new.vgi"}),
    BadInput(
        "patch layer", "Geodesic Voronoi patches: colour faces (VoroGeo)", '"Layer" (layer) is 3.', {"Layer": "3"}
    ),
    BadInput("no such file", LOAD, "no_such.vgi", {"Index file": "FOLDER/no_such.vgi"}),
    BadInput("no index file", LOAD, "wrong.vgi", {"Index file": "FOLDER/wrong.vgi"}),
    BadInput("truncated index file", LOAD, "truncated.vgi", {"Index file": "FOLDER/truncated.vgi"}),
    BadInput(
        "index of another mesh", LOAD, "was built for another mesh", {"Index file": "FOLDER/terrain.vgi"}, "torus"
    ),
    BadInput("no border", "Geodesic distance from the border (VoroGeo)", "has no border", {}, "torus"),
    BadInput("point cloud", FROM_POINT, "is a point cloud: it has vertices but no faces", {}, "points"),
]
