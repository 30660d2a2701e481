"""The length of a curve."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from symbolic.errors import BadValue, shown

from ..points import real_number
from .speed import speed, stretches

if TYPE_CHECKING:
    from ..curve import Curve

LENGTH = 1e-9  # the default tolerance


def length(curve: Curve, tolerance: Any = LENGTH) -> float:
    """Return the length of the curve, the integral of |c'(t)|.

    Jumps between segments do not count.

    Parameters
    ----------
    tolerance : number > 0
        Largest error, as a fraction of the length. What is below 1e-14 is lost in rounding.
        The error is estimated, not proved, from Gauss's rule on a part of a segment and on both
        its halves; it is bounded where the velocity may vanish, at cusps and turns.

    Raises
    ------
    BadValue, BadType
        Unless tolerance is a number above zero.

    Notes
    -----
    Parts are halved until their estimates fit, at a cusp as often as a float can be; see Gravesen,
    *Adaptive subdivision and the length and energy of Bezier curves*, Computational Geometry 8,
    1997, for bounds that can be proved and need more parts.

    Examples
    --------
    >>> from math import pi
    >>> from numeric import Curve
    >>> from symbolic import circle
    >>> abs(Curve.from_nurbs(circle()).length() - 2 * pi) < 1e-12
    True
    """
    number = real_number(tolerance, "a tolerance")
    if not number > 0:
        raise BadValue("a tolerance above 0", shown(tolerance), "1e-9 is the default.")
    speeds = speed(curve)
    return float(stretches(speeds, number).length.sum() * speeds.scale)
