"""Checking somebody's answer: the verdict, and the mistake named."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from .errors import BadType, BadValue, NotExact
from .mistakes import typical_mistakes
from .proof import prove, shape
from .verdict import Proved, Refuted, Undecided, Verdict


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
        Proved, Refuted or Undecided, with a `diagnosis` for the learner. Answers never raise.

    Examples
    --------
    >>> from symbolic import bezier, hermite
    >>> check(hermite().matrix, hermite().matrix).diagnosis
    'Right.'
    >>> print(check(hermite().matrix.T, hermite().matrix).diagnosis)
    This is the transpose: rows belong to powers of t, columns to entries of the geometry vector.
    >>> print(check(..., 1).diagnosis)
    Not answered yet: put your answer in place of the dots.
    """
    if answer is None or answer is ...:
        return Undecided(
            "there is no answer",
            diagnosis="Not answered yet: put your answer in place of the dots.",
        )
    try:
        verdict = _compare(answer, expected)
    except NotExact as error:
        return Undecided("the answer is not exact", diagnosis=f"Use exact numbers. {error.remedy}")
    except (BadType, BadValue) as error:
        return Undecided("the answer cannot be read", diagnosis=str(error))
    if isinstance(verdict, Proved):
        return replace(verdict, diagnosis="Right.")
    if isinstance(verdict, Undecided):
        return replace(verdict, diagnosis="This could not be decided; write it as a polynomial.")
    return replace(verdict, diagnosis=_diagnosis(answer, expected, mistakes or {}, verdict))


def _compare(answer: Any, expected: Any) -> Verdict:
    if shape(answer) == shape(expected):
        return prove(answer, expected)
    raise BadType(
        f"{_in_words(shape(expected))}", _in_words(shape(answer)), "Bring it into this form."
    )


def _diagnosis(answer: Any, expected: Any, mistakes: Mapping[str, Any], verdict: Verdict) -> str:
    for known in (mistakes, typical_mistakes(expected)):
        found = [sentence for sentence, wrong in known.items() if _equal(answer, wrong)]
        if len(found) == 1:
            return found[0]
        if found:
            return "One of these: " + " Or: ".join(found)
    assert isinstance(verdict, Refuted)
    where = f"In {verdict.where}: " if verdict.where else ""
    values = ", ".join(f"{name} = {value}" for name, value in verdict.witness.items())
    at = f"at {values} " if values else ""
    return f"Not yet. {where}{at}your answer gives {verdict.left}, which is not the right value."


def _equal(answer: Any, wrong: Any) -> bool:
    return shape(answer) == shape(wrong) and isinstance(prove(answer, wrong), Proved)


def _in_words(size: tuple[int, ...]) -> str:
    if not size:
        return "one number or expression"
    return "x".join(map(str, size)) + (" entries" if len(size) > 1 else " entries in a list")
