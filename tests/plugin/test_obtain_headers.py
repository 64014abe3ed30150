"""The script that finds the host's headers: its order, its checks, and what it says when nothing works."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from support import PROJECT

SCRIPT = PROJECT / "plugin" / "host" / "obtain_headers.sh"
NEEDED = [
    "src/common/plugins/interfaces/filter_plugin.h",
    "src/vcglib/vcg/complex/complex.h",
    "src/vcglib/wrap/callback.h",
]


def make_tree(folder: Path, version: str) -> Path:
    """A folder that looks like a source tree of MeshLab to the script."""
    for name in NEEDED:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()
    (folder / "ML_VERSION").write_text(version)
    return folder


def fake_tools(folder: Path, **texts: str) -> dict[str, str]:
    """Programs of these names that run other commands, found before the real ones."""
    tools = folder / "bin"
    tools.mkdir()
    for name, text in texts.items():
        (tools / name.replace("_", "-")).write_text(f"#!/bin/sh\n{text}\n")
        (tools / name.replace("_", "-")).chmod(0o755)
    return {"PATH": f"{tools}:{os.environ['PATH']}"}


def run(*arguments: str, cache: Path, **variables: str) -> subprocess.CompletedProcess[str]:
    """Run the script with a cache of its own."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith("VOROGEO_")}
    environment.update(variables, VOROGEO_HOST_CACHE=str(cache))
    return subprocess.run(
        ["bash", SCRIPT, *arguments], env=environment, capture_output=True, text=True, check=False, timeout=300
    )


@pytest.mark.parametrize("arguments", [(), ("2021.10",), ("2025.7",)])
def test_unknown_version(tmp_path, arguments):
    result = run(*arguments, cache=tmp_path)
    assert result.returncode != 0
    assert "name the version of MeshLab, 2022.02, 2023.12 or 2025.07" in result.stderr


def test_named_folder_comes_before_the_cache(tmp_path):
    tree = make_tree(tmp_path / "mine", "2025.07")
    make_tree(tmp_path / "cache" / "2025.07", "2025.07")
    for result in (
        run("2025.07", str(tree), cache=tmp_path / "cache"),
        run("2025.07", cache=tmp_path / "cache", VOROGEO_MESHLAB_SOURCE_2025_07=str(tree)),
    ):
        assert result.returncode == 0
        assert result.stdout.splitlines()[-1] == str(tree)
        assert "taken from the folder you named" in result.stderr


def test_cache(tmp_path):
    tree = make_tree(tmp_path / "2022.02", "2022.02\n")
    result = run("2022.02", cache=tmp_path)
    assert result.returncode == 0
    assert result.stdout.splitlines()[-1] == str(tree)
    assert "taken from the cache" in result.stderr


def test_named_folder_of_another_version_is_refused(tmp_path):
    tree = make_tree(tmp_path / "mine", "2023.12")
    result = run("2025.07", str(tree), cache=tmp_path)
    assert result.returncode != 0
    assert result.stdout == ""
    assert f"{tree} is MeshLab 2023.12, not 2025.07" in result.stderr


def test_named_folder_without_vcglib_is_refused(tmp_path):
    tree = make_tree(tmp_path / "mine", "2025.07")
    (tree / "src/vcglib/vcg/complex/complex.h").unlink()
    result = run("2025.07", cache=tmp_path, VOROGEO_MESHLAB_SOURCE_2025_07=str(tree))
    assert result.returncode != 0
    assert "has no src/vcglib/vcg/complex/complex.h" in result.stderr
    assert "unset VOROGEO_MESHLAB_SOURCE_2025_07" in result.stderr


def test_named_folder_that_does_not_exist(tmp_path):
    result = run("2025.07", str(tmp_path / "nowhere"), cache=tmp_path)
    assert result.returncode != 0
    assert "there is no folder" in result.stderr


def test_every_way_that_failed_is_named(tmp_path):
    tools = fake_tools(
        tmp_path,
        apt_get='echo "E: no such thing" ; exit 100',
        git='echo "fatal: no network" >&2 ; exit 128',
    )
    cache = tmp_path / "cache"
    result = run("2025.07", cache=cache, **tools)
    assert result.returncode != 0
    assert "Debian source package: " in result.stderr
    assert "git clone: fatal: no network" in result.stderr
    assert "VOROGEO_MESHLAB_SOURCE_2025_07=FOLDER" in result.stderr
    assert list(cache.iterdir()) == []  # nothing half-done is left behind


def test_damaged_cache_is_not_used(tmp_path):
    make_tree(tmp_path / "2025.07", "2022.02")
    result = run("2025.07", cache=tmp_path, **fake_tools(tmp_path, apt_get="exit 1", git="exit 1"))
    assert result.returncode != 0
    assert "taken from the cache" not in result.stderr


def git(folder: Path, *arguments: str) -> None:
    """Run git in a folder."""
    settings = ("-c", "user.name=Test", "-c", "user.email=test@localhost", "-c", "protocol.file.allow=always")
    subprocess.run(["git", *settings, *arguments], cwd=folder, check=True, capture_output=True)


def test_git_tag_with_its_submodule(tmp_path):
    """Where Debian's source package cannot be obtained, the tag is cloned; here from repositories on this disk."""
    server = tmp_path / "server"
    meshlab, vcglib = server / "meshlab", server / "vcglib"
    make_tree(meshlab, "2025.07")
    (meshlab / "src" / "vcglib").rename(vcglib)
    for repository in (vcglib, meshlab):
        git(repository, "init", "-q")
    git(vcglib, "add", ".")
    git(vcglib, "commit", "-q", "-m", "VCG")
    git(meshlab, "submodule", "add", "-q", str(vcglib), "src/vcglib")
    git(meshlab, "config", "-f", ".gitmodules", "submodule.src/vcglib.url", "https://github.com/cnr-isti-vclab/vcglib")
    git(meshlab, "add", ".")
    git(meshlab, "commit", "-q", "-m", "MeshLab")
    git(meshlab, "tag", "MeshLab-2025.07")

    cache = tmp_path / "cache"
    result = run(
        "2025.07",
        cache=cache,
        **fake_tools(tmp_path, apt_get="exit 1"),
        GIT_CONFIG_COUNT="2",
        GIT_CONFIG_KEY_0=f"url.file://{server}/.insteadOf",
        GIT_CONFIG_VALUE_0="https://github.com/cnr-isti-vclab/",
        GIT_CONFIG_KEY_1="protocol.file.allow",
        GIT_CONFIG_VALUE_1="always",
    )
    assert result.returncode == 0, result.stderr
    assert result.stdout.splitlines()[-1] == str(cache / "2025.07")
    assert "cloned from MeshLab's repository" in result.stderr
    assert (cache / "2025.07" / "src/vcglib/vcg/complex/complex.h").is_file()
