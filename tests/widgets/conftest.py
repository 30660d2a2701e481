"""The browser's check of answers, for all tests of figures."""

import json
import subprocess
from pathlib import Path

import pytest


class Checker:
    """The browser's check, run by Node."""

    def __init__(self, node):
        script = Path(__file__).parents[1] / "front_end" / "check_answers.mjs"
        self.process = subprocess.Popen(
            [node, str(script)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def __call__(self, question, text, inputs=None):
        request = {"question": question, "text": text, "inputs": inputs or {}}
        self.process.stdin.write(json.dumps(request) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())


@pytest.fixture(scope="session")
def checker(node):
    found = Checker(node)
    yield found
    found.process.communicate(timeout=10)
