"""What `auditwheel show` says of wheels, without the libraries that come with PyMeshLab, which it cannot be told of.

Usage: show_wheel.py WHEEL...      with a Python that has auditwheel; status 1 if a wheel does not agree with its tag
"""

from __future__ import annotations

import sys
from pathlib import Path

from auditwheel.wheel_abi import analyze_wheel_abi
from auditwheel.wheeltools import get_wheel_architecture, get_wheel_libc

OF_PYMESHLAB = frozenset({"libQt5*", "libmeshlab-common.so"})


def agrees(wheel: Path) -> bool:
    """Print the tag with which the binaries of a wheel are consistent; whether it is at least that of its name."""
    found = analyze_wheel_abi(
        get_wheel_libc(wheel.name),
        get_wheel_architecture(wheel.name),
        wheel,
        OF_PYMESHLAB,
        disable_isa_ext_check=False,
        allow_graft=False,
    )
    print(f'{wheel.name} is consistent with the following platform tag: "{found.overall_policy.name}".')
    return not found.overall_policy < found.policies.get_policy_by_name(wheel.stem.rsplit("-", 1)[1])


if __name__ == "__main__":
    found = [agrees(Path(name)) for name in sys.argv[1:]]
    sys.exit(0 if all(found) else 1)
