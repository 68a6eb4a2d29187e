"""Every example in examples/python runs, in a folder of its own, and what it asserts holds."""

import importlib.util
import runpy

import pytest
from doors import ROOT

FOLDER = ROOT / "examples" / "python"


@pytest.mark.parametrize("file", sorted(FOLDER.glob("*.py")), ids=lambda file: file.stem)
def test_example(file, tmp_path, monkeypatch):
    text = file.read_text()
    assert text.startswith("# %% [markdown]\n# # ")
    if "openseespy" in text and not any(importlib.util.find_spec(n) for n in ("openseespy", "openseespylinux")):
        pytest.skip("openseespy is not installed")
    for name in ("scipy", "matplotlib"):
        if name in text or (name == "matplotlib" and "bentur.plot" in text):
            pytest.importorskip(name)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    runpy.run_path(str(file), run_name="__main__")
