"""How a printed value is compared with ours: proved, or refuted if the print is wrong."""

from symbolic import Proved, Refuted, prove


def column(points):
    return [[p] for p in points]


def assert_proved(ours, printed):
    assert isinstance(prove(ours, printed), Proved)


def assert_refuted(ours, printed):
    verdict = prove(ours, printed)
    assert isinstance(verdict, Refuted)
    assert verdict.left != verdict.right
