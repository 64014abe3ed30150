"""Names of filters that several scripts use, as the menu shows them."""

from __future__ import annotations

FROM_POINT = "Geodesic distance from a given point (VoroGeo)"
EXACT_FROM_POINT = "Exact geodesic distance from a given point (VoroGeo)"
BUILD = "Geodesic index: build (VoroGeo)"
SAVE = "Geodesic index: save to file (VoroGeo)"
LOAD = "Geodesic index: load from file (VoroGeo)"
DESCRIBE = "Geodesic index: describe (VoroGeo)"
