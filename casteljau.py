"""The command line: ``casteljau lab`` opens the course in JupyterLab.

Start-up is felt by everybody, every time, so imports that cost something stand where they are used.
"""

import argparse
import os
import sys
from pathlib import Path
from typing import NoReturn

USAGE = "casteljau lab [FOLDER] [--no-browser] [--port N] [options of JupyterLab]"


def main(arguments: list[str] | None = None) -> int:
    """Run the command line and return its exit code.

    >>> main(["lab", "--port", "http"])
    Traceback (most recent call last):
    SystemExit: 2
    """
    parser = argparse.ArgumentParser("casteljau", description="An exact, interactive course.")
    parser.add_argument("--version", action="store_true", help="print the version and exit")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND")
    opening = commands.add_parser(
        "lab",
        usage=USAGE,
        allow_abbrev=False,
        help="open the course in JupyterLab",
        description="Write working copies of the lessons into FOLDER (casteljau-lessons when "
        "not given), never over a copy you edited, and open JupyterLab there.",
    )
    opening.add_argument("--no-browser", action="store_true", help="print the address instead")
    opening.add_argument("--port", metavar="N", help="the port to listen on")
    options, others = parser.parse_known_args(arguments)
    if options.command == "lab":
        return lab(options.port, options.no_browser, others)
    if others:
        parser.error(f"unrecognized arguments: {' '.join(others)}")
    if options.version:
        print(f"casteljau {version()}")
    else:
        parser.print_help()
    return 0


def lab(port: str | None, no_browser: bool, others: list[str]) -> int:
    """Bring the working copies up to date and hand over to JupyterLab."""
    from working_copies import write_copies

    # FOLDER stands before JupyterLab's options: in "--ip 0.0.0.0" the second word is not a folder.
    if "" in others:
        fail("expected the name of a folder, got an empty one; leave it away for casteljau-lessons")
    named = bool(others) and not others[0].startswith("-")
    folder = Path(others.pop(0) if named else "casteljau-lessons").absolute()
    if others and not others[0].startswith("-"):
        fail(
            f"expected one folder, got {folder.name!r} and {others[0]!r}; quote a name with spaces"
        )
    if port is not None:
        others += [f"--port={free_port(port)}", "--ServerApp.port_retries=0"]
    if no_browser or not has_display():
        others.append("--no-browser")
    if folder.exists() and not folder.is_dir():
        fail(f"expected a folder for the lessons, but {folder} is a file; name another one")
    try:
        copies = write_copies(lessons_folder(), folder, version())
    except OSError as error:
        fail(
            f"expected a folder to write the lessons into, but {folder} cannot be written "
            f"({error.strerror}); name another one, as in: casteljau lab my-lessons"
        )
    print(report(copies, folder), flush=True)
    first = min(copies).partition(".")[0] + ".ipynb"
    return open_jupyterlab(folder, first, others)


def version() -> str:
    """Return the installed version."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version("casteljau")
    except PackageNotFoundError:
        fail("expected an installed casteljau, but there are only its files; run: pip install -e .")


def lessons_folder() -> Path:
    """Return the folder of the lessons: in the clone, or where the wheel put them."""
    from importlib.metadata import files

    from working_copies import LESSONS

    clone = Path(__file__).parent / "lessons"
    if any(clone.glob(LESSONS)):
        return clone
    for file in files("casteljau") or ():
        if file.match(f"lessons/{LESSONS}"):
            return Path(file.locate()).parent.resolve()
    fail(f"expected lessons (01_topic.md, ...) in {clone}, but there are none; reinstall casteljau")


def report(copies: dict[str, str], folder: Path) -> str:
    """Say in a line or two what became of the copies.

    >>> print(report({"01_a.0.2.0.ipynb": "written", "02_b.ipynb": "kept"}, Path("mine")))
    2 lessons in mine: 1 written, 2 of yours kept as you edited them.
    A newer edition lies beside what you edited: 01_a.0.2.0.ipynb
    """
    written = [name for name, what in copies.items() if what == "written"]
    beside = [name for name in written if name.count(".") > 1]
    edited = list(copies.values()).count("kept") + len(beside)
    line = f"{len(copies)} lessons in {folder}: {len(written)} written"
    line += f", {edited} of yours kept as you edited them." if edited else "."
    if beside:
        line += f"\nA newer edition lies beside what you edited: {', '.join(beside)}"
    return line


def free_port(text: str) -> int:
    """Check a port that was asked for.

    >>> free_port("70000")
    Traceback (most recent call last):
    SystemExit: 2
    """
    import socket

    port = int(text) if text.isascii() and text.isdigit() else -1
    if not 0 <= port <= 65535:
        fail(f"expected a port from 1 to 65535, got {text!r}; give one, as in: --port 9000")
    with socket.socket() as probe:
        if os.name == "posix":  # on Windows this option would take the port away from its owner
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind(("127.0.0.1", port))
        except OSError as error:
            fail(
                f"expected a free port, but port {port} cannot be had ({error.strerror}); choose "
                "another one, or leave --port away and JupyterLab finds one"
            )
    return port


def has_display() -> bool:
    """Tell whether a browser can be opened; without one JupyterLab prints its address."""
    variables = ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER")
    return not sys.platform.startswith("linux") or any(map(os.environ.get, variables))


def open_jupyterlab(folder: Path, first: str, others: list[str]) -> int:
    """Become JupyterLab, opened on the first lesson."""
    # -P: a learner's own random.py in the working directory must not shadow Python's.
    command = [sys.executable, "-P", "-m", "jupyterlab", *others]
    command += [f"--ServerApp.root_dir={folder}", f"--LabApp.default_url=/lab/tree/{first}"]
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        command.append("--allow-root")
    os.environ["JUPYTER_PREFER_ENV_PATH"] = "1"  # the kernel of this environment, no other
    if os.name == "posix":
        os.execv(sys.executable, command)
    import subprocess

    with subprocess.Popen(command) as server:
        while True:
            try:
                return server.wait()
            except KeyboardInterrupt:  # meant for JupyterLab, which shuts its kernels down
                continue


def fail(sentence: str) -> NoReturn:
    """Say what is wrong and end with the exit code of a wrong call."""
    print(f"casteljau: {sentence}", file=sys.stderr)
    raise SystemExit(2)


if __name__ == "__main__":
    sys.exit(main())
