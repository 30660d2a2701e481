"""What a figure shows and is given, as tests of explorers read it."""

from numeric import Tape
from widgets.extent import evaluate


def outputs(fig):
    """Return the values of all outputs of the figure's tape, by name."""
    return evaluate(fig.scene, fig.values, Tape.from_json(fig.scene["tape"]))


def shown_marks(fig):
    """Return every mark with the values of its output."""
    found = outputs(fig)
    return [(mark, found[mark["output"]]) for mark in fig.scene["marks"]]


def inputs(fig):
    """Return the figure's inputs by the names of the tape."""
    named = {s["name"]: fig[s["name"]] for s in fig.scene["sliders"]}
    for group in fig.scene["points"]:
        for i, (x, y) in enumerate(fig[group["name"]]):
            named |= {f"{group['name']}{i}_x": x, f"{group['name']}{i}_y": y}
    return {name: float(value) for name, value in named.items()}


def verdicts(fig, checker):
    """Return {label: whether its residuals are zero}, as the browser computes them."""
    told = {}
    for mark in fig.scene["marks"]:
        if mark["kind"] == "statement":
            outputs = {"answer": mark["tape"]["outputs"]["residuals"]}
            question = {"tape": {**mark["tape"], "outputs": outputs}, "variables": [],
                        "mistakes": [], "hint": ""}  # fmt: skip
            told[mark["label"]] = checker(question, "0, 0", inputs(fig))["right"]
    return told
