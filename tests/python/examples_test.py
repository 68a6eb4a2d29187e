"""Every example in examples/python runs, in a folder of its own, and what it asserts holds."""

import importlib.util
import re
import runpy
import sys
import tomllib

import pytest
from doors import ROOT

FOLDER = ROOT / "examples" / "python"


@pytest.mark.parametrize("file", sorted(FOLDER.glob("*.py")), ids=lambda file: file.stem)
def test_example(file, tmp_path, monkeypatch):
    text = file.read_text()
    assert text.startswith("# %% [markdown]\n# # ")
    if "openseespy" in text and not any(importlib.util.find_spec(n) for n in ("openseespy", "openseespylinux")):
        pytest.skip("openseespy is not installed")
    for name in ("scipy", "matplotlib", "SALib", "UQpy"):
        if name in text or (name == "matplotlib" and "bentur.plot" in text):
            pytest.importorskip(name)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    runpy.run_path(str(file), run_name="__main__")


def test_all_brings_what_documents_and_examples_import():
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    brought = {"bentur", *(re.match(r"\w+", name)[0] for name in [*extras["dependencies"], *extras["optional-dependencies"]["all"]])}
    texts = [file.read_text() for file in (ROOT / "examples/python").glob("*.py")]
    for page in ROOT.glob("docs/**/*.md"):
        texts += re.findall(r"^```python\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL)
    found = {name for text in texts for name in re.findall(r"^ *(?:import|from) (\w+)", text, re.MULTILINE)}
    assert "numpy" in found
    # opensees_model.py, sensitivity_by_salib.py and reliability_by_uqpy.py are for who has these
    assert found - sys.stdlib_module_names - {"openseespy", "openseespylinux", "SALib", "UQpy"} <= brought
