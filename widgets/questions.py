"""Questions of a figure: the right answer and known mistakes, as tapes that the browser checks.

The browser runs them over exact rationals. Two expressions are compared on a grid of as many
values as their degrees ask for, which is a proof (see `front_end/check.js`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from numeric import compile_tape, flattened
from symbolic.errors import BadType, BadValue, shown

from .reading import text

HINT = "Not yet. Look at the figure again, or work it out on paper."


def question_data(
    prompt: str,
    answer: Any,
    inputs: Sequence[sp.Symbol],
    variables: Sequence[sp.Symbol],
    mistakes: Mapping[str, Any],
    hint: str,
) -> dict[str, Any]:
    """Return a question as JSON data.

    Raises
    ------
    BadValue
        If an answer is no rational expression with exact coefficients, or a mistake equals the
        right answer or has another size.
    """
    outputs = {"answer": _entries(answer)}
    texts = {f"mistake{k}": text(message, "mistake") for k, message in enumerate(mistakes)}
    for name, wrong in zip(texts, mistakes.values(), strict=True):
        outputs[name] = _entries(wrong)
        _refuse_alike(outputs["answer"], outputs[name], texts[name])
    if not all(_is_word(variable) for variable in variables):
        raise BadValue("variables that are words", shown(list(variables)), "Choose other letters.")
    typed = {variable.name for variable in variables}  # they hide inputs of the same name
    used = set().union(*(e.free_symbols for entries in outputs.values() for e in entries))
    own = [symbol for symbol in inputs if symbol in used and symbol.name not in typed]
    return {
        "prompt": text(prompt, "prompt"),
        "tape": exact_tape(outputs, [*own, *variables]),
        "variables": [variable.name for variable in variables],
        "mistakes": [{"output": name, "message": message} for name, message in texts.items()],
        "hint": text(hint, "hint"),
        "live": bool(own),
    }


def exact_tape(outputs: Mapping[str, Any], inputs: Sequence[sp.Symbol]) -> dict[str, Any]:
    """Return the tape, as JSON, of what the browser computes exactly.

    Raises
    ------
    BadValue
        For expressions that are no quotients of polynomials with exact coefficients.
    """
    entries = {name: _entries(output) for name, output in outputs.items()}
    used = set().union(*(e.free_symbols for listed in entries.values() for e in listed))
    return compile_tape(entries, [symbol for symbol in inputs if symbol in used]).to_json()


def _entries(answer: Any) -> list[sp.Expr]:
    entries = flattened(answer)[1]
    for entry in entries:
        if entry.has(sp.Float) or not entry.is_rational_function(*entry.free_symbols):
            raise BadValue(
                "an answer made of exact rational numbers, inputs and variables", shown(entry),
                "Ask for something that is a quotient of polynomials.",
            )  # fmt: skip
    return entries


def _refuse_alike(right: list[sp.Expr], wrong: list[sp.Expr], message: str) -> None:
    if len(right) != len(wrong):
        raise BadValue(
            f"mistakes of {len(right)} entries, as the answer has", f"{len(wrong)}: {message}",
            "Give the wrong answer as the learner would type it.",
        )  # fmt: skip
    if all(sp.cancel(a - b) == 0 for a, b in zip(right, wrong, strict=True)):
        raise BadValue(
            "mistakes that differ from the right answer", shown(message), "Leave it out."
        )


def _is_word(variable: Any) -> bool:
    if not isinstance(variable, sp.Symbol):
        raise BadType("symbols as variables", shown(variable), 'Write [Symbol("t")].')
    return variable.name.isidentifier()
