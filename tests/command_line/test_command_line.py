"""The command line as it is typed: what it prints, how it ends, how JupyterLab starts."""

import json
import os
import socket
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from urllib.request import urlopen

import pytest

import casteljau
from serving import Lab, free_port

CASTELJAU = str(Path(sys.executable).with_name("casteljau"))
ROOT = Path(__file__).parents[2]


def run(
    *arguments: str, cwd: Path | None = None, limit: Callable[[], None] | None = None
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [CASTELJAU, *arguments],
        cwd=cwd,
        preexec_fn=limit,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=60,
    )


def refusal(*arguments: str, cwd: Path, limit: Callable[[], None] | None = None) -> str:
    """Return the one sentence that the command is refused with."""
    done = run("lab", *arguments, cwd=cwd, limit=limit)
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr.startswith("casteljau: expected ") and done.stderr.count("\n") == 1
    return done.stderr


def test_version_and_help() -> None:
    assert run("--version").stdout == "casteljau 0.1.0\n"
    assert "open the course in JupyterLab" in run().stdout
    assert run().stdout == run("--help").stdout
    assert "[FOLDER] [--no-browser] [--port N]" in run("lab", "--help").stdout
    assert run("--no-browser").returncode == 2


@pytest.mark.parametrize("arguments", [["--help"], ["lab", "--help"], ["--version"]])
def test_help_imports_nothing_heavy(arguments: list[str]) -> None:
    code = (
        "import sys, casteljau\n"
        "try: casteljau.main(sys.argv[1:])\n"
        "except SystemExit: pass\n"
        "print(*sys.modules, sep='\\n', file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=True
    )
    modules = set(done.stderr.split())
    assert "casteljau" in modules
    assert not modules & {"sympy", "numpy", "matplotlib", "jupytext", "jupyterlab", "widgets"}


@pytest.mark.parametrize("port", ["http", "70000", "-5", "9000.5", "٣٤٥٦"])
def test_what_is_no_port(port: str, tmp_path: Path) -> None:
    sentence = refusal(f"--port={port}", cwd=tmp_path)
    assert "a port from 1 to 65535" in sentence and repr(port) in sentence
    assert list(tmp_path.iterdir()) == []


def test_a_port_in_use(tmp_path: Path) -> None:
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = str(other.getsockname()[1])
        sentence = refusal("--no-browser", "--port", port, cwd=tmp_path)
    assert port in sentence and "in use" in sentence and "choose another" in sentence


def test_a_file_in_the_place_of_the_folder(tmp_path: Path) -> None:
    (tmp_path / "notes").write_text("mine")
    sentence = refusal("notes", cwd=tmp_path)
    assert str(tmp_path / "notes") in sentence and "is a file" in sentence
    assert "name another one" in refusal("notes/lessons", cwd=tmp_path)


def test_a_folder_that_cannot_be_written(tmp_path: Path) -> None:
    def full() -> None:  # holds for root too, whom permissions do not stop
        import resource

        resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))

    sentence = refusal("mine", cwd=tmp_path, limit=full)
    assert str(tmp_path / "mine") in sentence and "cannot be written" in sentence
    assert list((tmp_path / "mine").iterdir()) == []


def test_two_folders(tmp_path: Path) -> None:
    assert "got 'My' and 'Course'; quote" in refusal("My", "Course", cwd=tmp_path)


def test_the_lab_answers_and_opens_the_first_lesson(
    jupyterlab: Lab, record_property: Callable[[str, object], None]
) -> None:
    assert "/lab/tree/01_" in jupyterlab.url
    root, _, query = jupyterlab.url.partition("/lab/tree/")
    token = query.partition("?")[2]
    with urlopen(f"{root}/api/contents?{token}", timeout=30) as answer:
        listing = answer.read().decode()
    copies = {f"{path.stem}.ipynb" for path in (ROOT / "lessons").glob("[0-9][0-9]_*.md")}
    assert copies and all(name in listing for name in copies)
    first_line = jupyterlab.log.read_text().splitlines()[0]
    assert first_line == f"{len(copies)} lessons in {jupyterlab.folder}: {len(copies)} written."
    record_property("casteljau lab to JupyterLab's answer", f"{jupyterlab.seconds:.1f} s")


def test_other_options_are_understood_by_jupyterlab(tmp_path: Path) -> None:
    done = run("lab", "mine", "--ip", "0.0.0.0", "--show-config-json", cwd=tmp_path)
    assert done.returncode == 0
    config = json.loads(done.stdout.partition("\n")[2])["ServerApp"]
    assert config["ip"] == "0.0.0.0" and config["root_dir"] == str(tmp_path / "mine")


@pytest.fixture
def handed_over(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., list[str]]:
    """Return a function that runs ``casteljau lab`` and returns JupyterLab's arguments."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("JUPYTER_PREFER_ENV_PATH", "")
    monkeypatch.setattr(os, "execv", lambda program, command: sys.exit(command))

    def hand_over(*arguments: str) -> list[str]:
        with pytest.raises(SystemExit) as ended:
            casteljau.main(["lab", *arguments])
        program, *command = ended.value.code
        assert program == sys.executable and os.environ["JUPYTER_PREFER_ENV_PATH"] == "1"
        return command

    return hand_over


def test_without_a_display_the_address_is_printed(
    handed_over: Callable[..., list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    for variable in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"):
        monkeypatch.delenv(variable, raising=False)
    assert ("--no-browser" in handed_over()) == sys.platform.startswith("linux")
    monkeypatch.setenv("DISPLAY", ":0")
    assert "--no-browser" not in handed_over()
    assert "--no-browser" in handed_over("--no-browser")


def test_only_root_needs_leave_to_be_root(
    handed_over: Callable[..., list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    for user in (0, 1000):
        monkeypatch.setattr(os, "geteuid", lambda user=user: user)
        assert ("--allow-root" in handed_over()) == (user == 0)


def test_the_folder_may_be_named_or_not(handed_over: Callable[..., list[str]]) -> None:
    default, mine = Path("casteljau-lessons").absolute(), Path("mine").absolute()
    port = str(free_port())
    assert f"--ServerApp.root_dir={default}" in handed_over("--ip", "0.0.0.0")
    for arguments in (["mine", "--port", port, "--debug"], [f"--port={port}", "mine", "--debug"]):
        command = handed_over(*arguments)
        assert f"--ServerApp.root_dir={mine}" in command
        assert f"--port={port}" in command and "--debug" in command and "mine" not in command
