"""Start ``casteljau lab`` as a learner would, and wait until JupyterLab answers."""

import json
import os
import re
import socket
import subprocess
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import NamedTuple
from urllib.error import URLError
from urllib.request import urlopen

ADDRESS = re.compile(r"http://(?:localhost|127\.0\.0\.1):\d+/lab\S*token=\w+")

# No question about news, which would lie over the lesson, and no look for a newer JupyterLab.
QUIET = {
    "@jupyterlab/apputils-extension:notification": {"fetchNews": "false", "checkForUpdates": False}
}


class Lab(NamedTuple):
    """A JupyterLab that answers."""

    url: str  # as printed: opens the first lesson, has the token
    folder: Path  # of the working copies
    log: Path  # what the server printed
    seconds: float  # from the command to the first answer


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


@contextmanager
def running_lab(
    program: Sequence[str], folder: Path, home: Path, environment: dict[str, str] | None = None
) -> Iterator[Lab]:
    """Run ``PROGRAM lab FOLDER`` in the folder ``home``, which keeps the user's settings out."""
    kinds = ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR")
    own = {kind: str(home / kind.lower()) for kind in kinds}
    settings = home / "jupyter_config_dir" / "labconfig" / "default_setting_overrides.json"
    settings.parent.mkdir(parents=True)
    settings.write_text(json.dumps(QUIET))
    log = home / "jupyterlab.log"
    options = ["--no-browser", "--port", str(free_port())]
    started = time.monotonic()
    with log.open("w") as output:
        server = subprocess.Popen(
            [*program, "lab", str(folder), *options],
            cwd=home,
            env={**(environment or os.environ), **own},
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
        )
    try:
        url = address(server, log)
        yield Lab(url, folder, log, time.monotonic() - started)
    finally:
        code = stop(server)
    assert code == 0, log.read_text()


def stop(server: subprocess.Popen[bytes]) -> int:
    """End the server as a closed terminal does; JupyterLab may hang while a kernel starts."""
    server.terminate()
    try:
        return server.wait(timeout=30)
    except subprocess.TimeoutExpired:
        server.kill()
        return server.wait()


def address(server: subprocess.Popen[bytes], log: Path, patience: float = 120) -> str:
    """Return the printed address, as soon as it answers."""
    end = time.monotonic() + patience
    while server.poll() is None and time.monotonic() < end:
        found = ADDRESS.search(log.read_text())
        if found:  # JupyterLab prints its address before it listens there
            with suppress(URLError), urlopen(found[0], timeout=patience):
                return found[0]
        time.sleep(0.1)
    raise AssertionError(f"JupyterLab did not start:\n{log.read_text()}")
