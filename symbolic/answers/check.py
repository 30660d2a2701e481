"""Checking somebody's answer: the verdict, and the mistake named."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from ..errors import BadType, BadValue, NotExact, shown
from ..exact import as_list
from ..proofs.proof import prove_sides
from ..proofs.side import Side, read_side
from ..proofs.verdict import Proved, Refuted, Undecided, Verdict, shown_number
from .mistakes import typical_mistakes


def check(answer: Any, expected: Any, mistakes: Mapping[str, Any] | None = None) -> Verdict:
    """Decide whether an answer is right, and if it is wrong say what went wrong.

    A wrong answer is compared with what typical mistakes would have given: those of the
    question (`mistakes`) and the general ones (a transposed matrix, powers or points in the other
    order, a lost sign, t and 1 - t exchanged). A mistake is named only if it gives exactly this
    answer; where several do, the diagnosis says "one of these".

    Parameters
    ----------
    answer : expression, number, matrix, or list of points
        None or ... means "not answered yet".
    expected : the same kind of object
    mistakes : mapping of sentence to wrong answer, optional

    Returns
    -------
    Verdict
        Proved, Refuted or Undecided, with a `diagnosis` for the learner. Answers never raise;
        an `expected` or a mistake that cannot be read does.

    Examples
    --------
    >>> from symbolic import bezier, hermite
    >>> check(hermite().matrix, hermite().matrix).diagnosis
    'Right.'
    >>> print(check(hermite().matrix.T, hermite().matrix).diagnosis)
    This is the transpose: rows and columns are exchanged.
    >>> print(check(..., 1).diagnosis)
    Not answered yet: put your answer in place of the dots.
    """
    right, own = read_side(expected), _read(mistakes)
    if _is_open(answer):
        return Undecided(
            "there is no answer",
            diagnosis="Not answered yet: put your answer in place of the dots.",
        )
    try:
        given = read_side(answer)
        verdict = prove_sides(given, right)
    except NotExact as error:
        return Undecided("the answer is not exact", diagnosis=f"Use exact numbers. {error.remedy}")
    except (BadType, BadValue) as error:
        return Undecided("the answer cannot be compared", diagnosis=str(error))
    if isinstance(verdict, Undecided):
        return replace(verdict, diagnosis=f"This could not be decided: {verdict.why}.")
    if isinstance(verdict, Refuted):
        return replace(verdict, diagnosis=_diagnosis(given, expected, own, verdict))
    return replace(verdict, diagnosis="Right.")


def _is_open(answer: Any, depth: int = 0) -> bool:
    """Tell whether dots are left somewhere in an answer."""
    if answer is None or answer is ...:
        return True
    entries = as_list(answer) if depth < 3 else None
    return any(_is_open(entry, depth + 1) for entry in entries or ())


def _read(mistakes: Any) -> dict[str, Side]:
    """Read the question's own mistakes, whether the answer is wrong or not."""
    if mistakes is None:
        return {}
    if not isinstance(mistakes, Mapping) or not all(isinstance(s, str) for s in mistakes):
        raise BadType(
            "mistakes as {sentence: wrong answer}",
            shown(mistakes),
            'Write {"You forgot the factor 2.": t}.',
        )
    return {sentence: read_side(wrong) for sentence, wrong in mistakes.items()}


def _diagnosis(given: Side, expected: Any, mistakes: dict[str, Side], verdict: Refuted) -> str:
    for known in (mistakes, _read(typical_mistakes(expected))):
        found = [sentence for sentence, wrong in known.items() if _equal(given, wrong)]
        if len(found) == 1:
            return found[0]
        if found:
            return "One of these: " + " Or: ".join(found)
    where = f"In {verdict.where}: " if verdict.where else ""
    values = ", ".join(f"{name} = {value}" for name, value in verdict.witness.items())
    answer = f"at {values} your answer gives" if values else "your answer is"
    sentence = f"{where}{answer} {shown_number(verdict.left)}, which is not the right value."
    return f"Not yet. {sentence[0].upper()}{sentence[1:]}"


def _equal(given: Side, wrong: Side) -> bool:
    return given.shape == wrong.shape and isinstance(prove_sides(given, wrong), Proved)
