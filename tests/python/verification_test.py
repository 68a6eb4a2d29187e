"""The checks of docs/verification.md, with the limits that stand there, and the page lists them all."""


import pytest
import verification
from doors import ROOT

PAGE = (ROOT / "docs" / "verification.md").read_text()


@pytest.mark.parametrize("function, limit", verification.CHECKS, ids=[f.__doc__[:60] for f, _ in verification.CHECKS])
def test_check(function, limit):
    assert 0 <= function() <= limit
    what, against = function.__doc__.split(" | ")
    assert f"| {what} | {against} |" in PAGE
    assert f"| {limit:.0e} |" in PAGE
