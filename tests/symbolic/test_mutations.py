"""Every step of every derivation holds, and whatever is changed in it is refuted."""

import ast
import random
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
import sympy as sp
from sympy import Rational

import symbolic
from symbolic import Refuted
from symbolic.dag import substitute
from symbolic.proofs.linear_text import linear_text
from symbolic.proofs.proof import prove_sides
from symbolic.proofs.side import evaluated, read_side
from symbolic.proofs.witness import free_symbols
from tests.symbolic.derivations import DERIVATIONS

every_derivation = pytest.mark.parametrize(
    ("name", "build"), DERIVATIONS, ids=[name for name, _ in DERIVATIONS]
)


@every_derivation
def test_every_step_is_proved(name, build):
    derivation = build()
    assert derivation.steps and derivation.source
    assert [verdict for verdict in derivation.verify() if not verdict] == []


@every_derivation
def test_no_step_says_the_same_twice(name, build):
    for step in build().steps:
        assert linear_text(step.left) != linear_text(step.right), step.because


@every_derivation
def test_every_corruption_of_every_step_is_refuted(name, build):
    chance = random.Random(name)
    for number, step in enumerate(build().steps, 1):
        sides = read_side(step.left), read_side(step.right)
        for how, left, right in corruptions(*sides, chance):
            verdict = prove_sides(left, right)
            assert isinstance(verdict, Refuted), f"step {number}, {how}: {verdict}"


def corruptions(left, right, chance):
    """Yield three changed versions of two sides, each told in a word."""
    sides = [left, right]
    which, place, term = nonzero_term(sides, chance)
    for how, change in {
        "a number added": lambda e: e + Rational(chance.randint(1, 9), 7),
        "a sign flipped": lambda e: e - 2 * term,
        "a coefficient changed": lambda e: e + term * Rational(chance.randint(1, 9), 10),
    }.items():
        changed = list(sides[which].scalars)
        changed[place] = change(changed[place])
        mutated = list(sides)
        mutated[which] = replace(sides[which], scalars=tuple(changed))
        yield how, *mutated


def nonzero_term(sides, chance):
    """Choose a term of an entry of a side that is not zero everywhere."""
    places = [(i, k) for i, side in enumerate(sides) for k in range(len(side.scalars))]
    for which, place in chance.sample(places, len(places)):
        terms = list(sp.Add.make_args(evaluated(sides[which].scalars[place])))
        for term in chance.sample(terms, len(terms)):
            if is_nonzero_somewhere(term, chance):
                return which, place, term
    return 1, chance.randrange(len(sides[1].scalars)), sp.Symbol("t")  # both sides are zero


def is_nonzero_somewhere(term, chance):
    term = term.doit()
    for _ in range(8):
        values = {s: Rational(chance.randint(1, 60), 16) for s in free_symbols([term])}
        (value,) = substitute([term], values)
        if value.is_number and value.is_finite and abs(value.evalf(30)) > Rational(1, 10**9):
            return True
    return False


TELL_MAKERS = """
import sys
from symbolic import Derivation
makers, make = set(), Derivation.__init__
def told(self, *arguments, **named):
    makers.add(sys._getframe(1).f_globals["__name__"])
    make(self, *arguments, **named)
Derivation.__init__ = told
from tests.symbolic.derivations import DERIVATIONS
for _, build in DERIVATIONS:
    build()
print(*makers)
"""


def test_every_module_that_makes_derivations_is_on_the_register():
    root = Path(symbolic.__file__).parent
    expected = {
        ".".join(path.relative_to(root.parent).with_suffix("").parts)
        for path in root.rglob("*.py")
        if any(isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Derivation"
               for node in ast.walk(ast.parse(path.read_text("utf-8"))))
    }  # fmt: skip
    # A process of its own: what this one remembers would not be made again.
    told = subprocess.run([sys.executable, "-c", TELL_MAKERS], cwd=root.parent, text=True,
                          capture_output=True, check=True)  # fmt: skip
    assert expected and expected <= set(told.stdout.split())
