"""Every Python block of the documents runs, each by itself and in order, in the folder of the repository; where the next
block has no language and stands behind "prints", that is what it prints."""

import contextlib
import io
import os
import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).parents[2]
BLOCK = re.compile(r"^```python\n(.*?)^```$(?:\n+prints\n+```\n(.*?)^```$)?", re.MULTILINE | re.DOTALL)
# What cannot run, by words in it, and why.
SKIPPED = {
    "my-case.toml": "a case that the reader has",
    "m12-gaps.nc": "results of a study of minutes; test of bentur.sweep: doors_test.py",
}


def _blocks():
    for document in sorted([ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]):
        for number, match in enumerate(BLOCK.finditer(document.read_text()), 1):
            yield pytest.param(match[1], match[2], id=f"{document.relative_to(ROOT)}-{number}")


@pytest.mark.parametrize("code, printed", list(_blocks()))
def test_block(code, printed, monkeypatch):
    for words, why in SKIPPED.items():
        if words in code:
            pytest.skip(why)
    monkeypatch.chdir(ROOT)
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(code, "block", "exec"), {"__name__": "block"})
    if printed is not None:
        assert out.getvalue() == printed
    assert os.getcwd() == str(ROOT)
