"""Every example in examples/python runs, in a folder of its own, and what it asserts holds."""

import importlib.util
import json
import re
import runpy
import sys
import tomllib

import pytest
from doors import ROOT

FOLDER = ROOT / "examples" / "python"
NOTEBOOKS = sorted((ROOT / "examples" / "notebooks").glob("*.ipynb"))


def skip_without_packages(text):
    for name in ("scipy", "matplotlib", "SALib", "UQpy"):
        if name in text or (name == "matplotlib" and "bentur.plot" in text):
            pytest.importorskip(name)


@pytest.mark.parametrize("file", sorted(FOLDER.glob("*.py")), ids=lambda file: file.stem)
def test_example(file, tmp_path, monkeypatch):
    text = file.read_text()
    assert text.startswith("# %% [markdown]\n# # ")
    if "openseespy" in text and not any(importlib.util.find_spec(n) for n in ("openseespy", "openseespylinux")):
        pytest.skip("openseespy is not installed")
    skip_without_packages(text)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    runpy.run_path(str(file), run_name="__main__")


def test_notebooks_are_their_scripts(tmp_path):
    tool = runpy.run_path(str(ROOT / "tools" / "notebooks.py"))
    assert {file.stem for file in NOTEBOOKS} >= {"risk_of_two_frames", "design_by_scipy", "sensitivity_by_salib"}
    for file in NOTEBOOKS:
        assert file.read_text() == tool["notebook"]((FOLDER / f"{file.stem}.py").read_text()), f"python3 tools/notebooks.py {file.parent}"


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_notebook(file, tmp_path, monkeypatch):
    """In a kernel where there are nbclient and one; else its cells one after the other."""
    cells = ["".join(cell["source"]) for cell in json.loads(file.read_text())["cells"] if cell["cell_type"] == "code"]
    skip_without_packages("\n".join(cells))
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    if importlib.util.find_spec("nbclient") and importlib.util.find_spec("ipykernel"):
        import nbclient
        import nbformat

        monkeypatch.delenv("MPLBACKEND")
        notebook = nbformat.read(file, as_version=4)
        nbformat.validate(notebook)
        nbclient.NotebookClient(notebook, timeout=200, resources={"metadata": {"path": str(tmp_path)}}).execute()
        outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
        assert outputs and all(output.output_type != "error" for output in outputs)
        if "bentur.plot" in "".join(cells):
            assert any("image/png" in output.get("data", {}) for output in outputs)
        return
    names = {"__name__": "__main__"}
    for cell in cells:
        exec(compile(cell, str(file), "exec"), names)  # noqa: S102


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
