"""The wheel, built from the sdist and used away from the clone, on a machine without our tools."""

import os
import shutil
import subprocess
import sys
import tarfile
import venv
import zipfile
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path

import pytest

from serving import running_lab

ROOT = Path(__file__).parent.parent.parent
VERSION = version("casteljau")
TOOLS = ("make", "git", "node", "npm", "cc", "gcc", "clang", "chromium")


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the sdist and the wheel that was built from it, with Node from PyPI."""
    folder = tmp_path_factory.mktemp("dist")
    command = [sys.executable, "-m", "build", "--outdir", str(folder), str(ROOT)]
    environment = {**os.environ, "PATH": str(folder)}  # an empty one: no tool of this machine
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder


@pytest.fixture(scope="module")
def wheel(built: Path) -> Path:
    (path,) = built.glob("*.whl")
    return path


def test_the_wheel_holds_what_runs_and_nothing_else(
    wheel: Path, record_property: Callable[[str, object], None]
) -> None:
    with zipfile.ZipFile(wheel) as archive:
        sizes = {info.filename: info.file_size for info in archive.infolist()}
        bundles = [name for name in sizes if name.startswith("widgets/static/")]
        stamps = {archive.read(name).splitlines()[0].decode() for name in bundles}
    own = f"casteljau-{VERSION}"
    shared = f"{own}.data/data/share/casteljau/lessons/"
    rooms = {"symbolic", "numeric", "widgets", "casteljau.py", "working_copies.py"}
    assert {name.split("/")[0] for name in sizes} == rooms | {f"{own}.data", f"{own}.dist-info"}
    assert stamps == {f"/* casteljau {VERSION} */"}
    assert {Path(name).name for name in bundles} == {"figure.mjs", "figure.page.js"}
    lessons = {path.name for path in (ROOT / "lessons").iterdir() if path.is_file()}
    assert {name.removeprefix(shared) for name in sizes if name.startswith(shared)} == lessons
    assert {f"{own}.dist-info/licenses/{name}" for name in ("LICENSE", "lessons/LICENSE")} <= set(
        sizes
    )
    unwanted = ("front_end", "node_modules", "__pycache__", "tests", ".ipynb")
    assert not [name for name in sizes if any(word in name for word in unwanted)]
    record_property("wheel", f"{wheel.stat().st_size / 1000:.0f} kB")
    for name in bundles:
        record_property(name, f"{sizes[name] / 1000:.1f} kB")


def test_the_sdist_holds_the_sources_of_the_front_end(built: Path) -> None:
    (path,) = built.glob("*.tar.gz")
    with tarfile.open(path) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    assert {"widgets/front_end/package-lock.json", "hatch_build.py", "lessons/LICENSE"} <= names
    assert not [name for name in names if "node_modules" in name or "widgets/static" in name]


class Installed:
    """An environment with the wheel in it, and programs run there away from the clone."""

    def __init__(self, folder: Path) -> None:
        self.home = folder / "Bücher und Kurven"
        self.bin = self.home / "eigene Umgebung" / ("Scripts" if os.name == "nt" else "bin")
        foreign = ("PYTHON", "VIRTUAL_ENV", "JUPYTER", "DISPLAY", "WAYLAND_DISPLAY", "BROWSER")
        self.environment = {k: v for k, v in os.environ.items() if not k.startswith(foreign)}
        self.environment["PATH"] = str(self.bin)

    def run(self, program: str, *arguments: str) -> str:
        done = subprocess.run(
            [str(self.bin / program), *arguments],
            cwd=self.home,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Installed:
    """Install the wheel in an empty environment, from wheels alone."""
    place = Installed(tmp_path_factory.mktemp("away"))
    venv.create(place.bin.parent, with_pip=True)
    assert not [tool for tool in TOOLS if shutil.which(tool, path=place.environment["PATH"])]
    place.run("python", "-m", "pip", "install", "--quiet", "--only-binary=:all:", str(wheel))
    return place


def test_it_knows_its_version(installed: Installed) -> None:
    assert installed.run("casteljau", "--version") == f"casteljau {VERSION}\n"


def test_a_figure_is_made_away_from_the_clone(installed: Installed) -> None:
    code = (
        "import symbolic, numeric, widgets\n"
        "from widgets import explore\n"
        "html = explore.de_casteljau(points=[[0, 0], [1, 2], [3, 0]]).html()\n"
        "print(widgets.__file__, len(html), '/* casteljau' in html, sep='\\n')"
    )
    place, length, bundled = installed.run("python", "-c", code).splitlines()
    assert Path(place).is_relative_to(installed.home)
    assert int(length) > 1000 and bundled == "True"


def test_the_lab_opens_with_the_lessons(
    installed: Installed, record_property: Callable[[str, object], None]
) -> None:
    program, folder = str(installed.bin / "casteljau"), installed.home / "mein Kurs – Übung"
    with running_lab([program], folder, installed.home, installed.environment) as lab:
        assert "/lab/tree/01_" in lab.url
        record_property("installed wheel: casteljau lab to answer", f"{lab.seconds:.1f} s")
    names = {path.stem for path in (ROOT / "lessons").glob("[0-9]*.md")}
    assert {path.stem for path in folder.glob("*.ipynb")} == names
