"""Every step of every derivation holds, and no corrupted step does."""

import pytest

from tests.symbolic.derivations import DERIVATIONS


@pytest.mark.parametrize(("name", "build"), DERIVATIONS, ids=[name for name, _ in DERIVATIONS])
def test_every_step_is_proved(name, build):
    derivation = build()
    assert derivation.steps
    assert [verdict for verdict in derivation.verify() if not verdict] == []
