"""Finding, loading and binding the filters: the PyMeshLab versions that have them, others, none, and broken ones."""

import re
import subprocess
import sys
import types
from pathlib import Path

import numpy as np
import pytest
import vorogeo
from vorogeo import plugin

from sample_meshes import cube

PROJECT = Path(__file__).parents[2]
DOCUMENTS = [
    "README.md",
    "pyfilter/README.md",
    *(f"docs/{name}.md" for name in ("filters", "cheatsheet", "guide")),
]


def documented_filters():
    """Names in the documents that have the form of a filter's name and say geodesic or vorogeo."""
    text = "\n".join((PROJECT / name).read_text() for name in DOCUMENTS)
    names = set(re.findall(r"\b(?:compute|get|generate|save|load|apply|set)_[a-z0-9]+_[a-z0-9_]+\b", text))
    return {name for name in names if "geodesic" in name or "vorogeo" in name}


FILTERS = documented_filters()


@pytest.mark.parametrize(
    ("pymeshlab", "meshlab"),
    [
        ("2025.7", "2025.07"),
        ("2025.7.post1", "2025.07"),
        ("2022.2.post4", "2022.02"),
        ("2023.12.post3", "2023.12"),
        ("2025.1", "2025.01"),
        ("2025.70", "2025.70"),
        ("2025.7.1", None),
        ("2025.7rc1", None),
        ("2025.7.dev0", None),
        ("0.2", None),
        ("", None),
    ],
)
def test_whole_versions_are_compared(pymeshlab, meshlab):
    assert plugin.meshlab_version(pymeshlab) == meshlab


@pytest.mark.parametrize("version", ["2025.1", "2025.70", "2025.7rc1", "2021.10", "2023.1", "2026.3", "unknown"])
def test_other_versions_get_a_sentence_that_says_what_to_do(version):
    with pytest.raises(vorogeo.PluginError, match=r"pip install pymeshlab==2025\.7\.post1") as caught:
        plugin.plugin_file(version)
    assert f"PyMeshLab {version} is installed" in str(caught.value)
    assert "numpy functions of vorogeo work" in str(caught.value)


@pytest.mark.parametrize(
    ("version", "host"), [("2022.2.post4", "2022.02"), ("2023.12.post3", "2023.12"), ("2025.7.post1", "2025.07")]
)
def test_a_plugin_left_out_of_the_build_is_explained(monkeypatch, tmp_path, version, host):
    monkeypatch.setattr(plugin, "FOLDER", tmp_path)
    with pytest.raises(vorogeo.PluginError, match=rf"obtain_headers\.sh {host}.*pip install \./pyfilter"):
        plugin.plugin_file(version)
    (tmp_path / host).mkdir()
    (tmp_path / host / plugin.FILE_NAME).touch()
    assert plugin.plugin_file(version) == tmp_path / host / plugin.FILE_NAME


@pytest.mark.parametrize("system", ["Windows", "Darwin"])
def test_other_systems_have_no_filters_which_is_said_to_who_asks(monkeypatch, system):
    monkeypatch.setattr(plugin.platform, "system", lambda: system)
    with pytest.raises(vorogeo.PluginError, match=f"on Linux only, not on {system}.*numpy functions") as caught:
        plugin.plugin_file("2025.7.post1")
    assert "\n" not in str(caught.value)
    plugin.load_on_import()  # without a warning at each start


class FakeHostError(Exception):
    """Stands for PyMeshLabException."""


@pytest.fixture
def fake_host(monkeypatch, tmp_path):
    """A PyMeshLab 2025.7 whose plugins add the filter 'vorogeo_filter'."""
    filters = ["old_filter"]
    host = types.ModuleType("pymeshlab")
    host.__spec__ = types.SimpleNamespace(name="pymeshlab")
    host.pmeshlab = types.SimpleNamespace(__version__="2025.7.post1")
    host.PyMeshLabException = FakeHostError
    host.MeshSet = type("MeshSet", (), {"apply_filter": lambda self, name, **kwargs: {name: kwargs} if kwargs else {}})
    host.filter_list = lambda: list(filters)
    host.load_plugin = lambda file: filters.append("vorogeo_filter")
    folder = tmp_path / "2025.07"
    folder.mkdir()
    (folder / plugin.FILE_NAME).touch()
    monkeypatch.setattr(plugin, "FOLDER", tmp_path)
    monkeypatch.setattr(plugin, "_loaded", None)
    monkeypatch.setitem(sys.modules, "pymeshlab", host)
    return host


def test_vorogeo_filters_become_methods_and_are_loaded_once(fake_host):
    assert plugin.load_plugin() == ("vorogeo_filter",)
    assert plugin.load_plugin() == ("vorogeo_filter",)
    assert fake_host.filter_list() == ["old_filter", "vorogeo_filter"]
    assert not hasattr(fake_host.MeshSet, "old_filter")
    assert fake_host.MeshSet().vorogeo_filter(step=3) == {"vorogeo_filter": {"step": 3}}
    assert fake_host.MeshSet().vorogeo_filter() is None
    assert fake_host.MeshSet.vorogeo_filter.__name__ == "vorogeo_filter"


def test_filters_loaded_by_the_user_become_methods(fake_host):
    fake_host.load_plugin("anywhere.so")

    def refuse(file):
        raise FakeHostError("already loaded")

    fake_host.load_plugin = refuse
    assert plugin.load_plugin() == ("vorogeo_filter",)
    assert fake_host.MeshSet().vorogeo_filter(step=3) == {"vorogeo_filter": {"step": 3}}
    assert not hasattr(fake_host.MeshSet, "old_filter")


def test_a_refused_plugin_is_explained(fake_host):
    def refuse(file):
        raise FakeHostError("wrong scalar")

    fake_host.load_plugin = refuse
    with pytest.raises(vorogeo.PluginError, match=r"refuses .*libfilter_vorogeo\.so: wrong scalar"):
        plugin.load_plugin()
    with pytest.warns(RuntimeWarning, match="wrong scalar"):
        plugin.load_on_import()


def test_named_plugin_file(fake_host, tmp_path):
    with pytest.raises(vorogeo.PluginError, match=r"There is no plugin file .*mine\.so"):
        plugin.load_plugin(tmp_path / "mine.so")
    (tmp_path / "mine.so").touch()
    assert plugin.load_plugin(tmp_path / "mine.so") == ("vorogeo_filter",)


def run_python(code, cwd):
    """Runs code in a fresh interpreter, with `cwd` first on its path."""
    command = [sys.executable, "-c", f"import sys; sys.path.insert(0, {str(cwd)!r})\n{code}"]
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, timeout=120)


USE_NUMPY_PART = """
import vorogeo
print(vorogeo.exact_distance_field([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], 1).tolist())
try:
    vorogeo.load_plugin()
except vorogeo.PluginError as error:
    print(error)
"""


def test_without_pymeshlab_the_numpy_part_works_in_silence(tmp_path):
    run = run_python("sys.modules['pymeshlab'] = None\n" + USE_NUMPY_PART, tmp_path)
    assert run.stderr == ""
    assert run.stdout.splitlines()[0] == "[3.0, 0.0, 5.0]"
    assert "PyMeshLab is not installed: run 'pip install pymeshlab==2025.7.post1'" in run.stdout


def test_with_another_pymeshlab_the_numpy_part_works_with_a_warning(tmp_path):
    package = tmp_path / "pymeshlab"
    package.mkdir()
    (package / "__init__.py").write_text("from . import pmeshlab\n")
    (package / "pmeshlab.py").write_text("__version__ = '2021.10'\n")
    run = run_python(USE_NUMPY_PART, tmp_path)
    assert run.stdout.splitlines()[0] == "[3.0, 0.0, 5.0]"
    assert "RuntimeWarning: PyMeshLab 2021.10 is installed, but" in run.stderr
    assert "pip install pymeshlab==2025.7.post1" in run.stdout


def test_with_a_broken_pymeshlab_the_numpy_part_works_with_a_warning(tmp_path):
    (tmp_path / "pymeshlab.py").write_text("raise ImportError('libGL.so.1: cannot open shared object file')\n")
    run = run_python(USE_NUMPY_PART, tmp_path)
    assert run.stdout.splitlines()[0] == "[3.0, 0.0, 5.0]"
    assert "cannot be imported (libGL.so.1" in run.stderr


@pytest.fixture
def pymeshlab():
    """The real PyMeshLab with the filters; skips where either is missing."""
    module = pytest.importorskip("pymeshlab")
    host = plugin.meshlab_version(module.pmeshlab.__version__)
    if not (plugin.FOLDER / str(host) / plugin.FILE_NAME).is_file():
        pytest.skip(f"this build of vorogeo holds no plugin for PyMeshLab {module.pmeshlab.__version__}")
    return module


def test_all_filters_are_documented_and_mesh_set_methods(pymeshlab):
    assert set(vorogeo.load_plugin()) == FILTERS
    assert set(pymeshlab.filter_list()) >= FILTERS
    for name in FILTERS:
        assert getattr(pymeshlab.MeshSet, name).__name__ == name


LOAD_BEFORE_VOROGEO = """
import pymeshlab
pymeshlab.load_plugin({file!r})
import vorogeo
names = vorogeo.load_plugin()
print(set(names) == {names!r} and all(hasattr(pymeshlab.MeshSet, name) for name in names))
"""


def test_filters_are_mesh_set_methods_also_if_the_user_has_loaded_the_plugin(pymeshlab, tmp_path):
    file = plugin.plugin_file(pymeshlab.pmeshlab.__version__)
    run = run_python(LOAD_BEFORE_VOROGEO.format(file=str(file), names=FILTERS), tmp_path)
    assert run.stdout.splitlines()[-1:] == ["True"], run.stdout + run.stderr
    assert "Warning" not in run.stderr


def test_a_filter_answers_through_its_method(pymeshlab, tmp_path):
    vertices, faces = cube()
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(map(str, row)) for row in (*vertices, *(np.insert(face, 0, 3) for face in faces))]
    (tmp_path / "cube.off").write_text("\n".join(lines))
    mesh_set = pymeshlab.MeshSet()
    mesh_set.load_new_mesh(str(tmp_path / "cube.off"))
    answer = mesh_set.get_vorogeo_distance_between_points(source=0, target=7)
    assert answer["distance"] == pytest.approx(np.sqrt(5), rel=1e-12)
    answer = mesh_set.compute_scalar_by_geodesic_method_comparison_per_vertex(vertex_index=0, method=1, reference=1)
    assert answer["max_error"] == 0
