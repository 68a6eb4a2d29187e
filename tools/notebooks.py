#!/usr/bin/env python3
"""notebooks.py FOLDER [SCRIPT...]: writes examples/python/SCRIPT.py, cells of `# %%`, as Jupyter notebooks into FOLDER.

Without scripts all of them. A cell `# %% [markdown]` is text. Nothing is run, so a notebook has no output: the same script
gives the same bytes.
"""

import json
import pathlib
import re
import sys

SCRIPTS = pathlib.Path(__file__).resolve().parent.parent / "examples" / "python"


def cells_of(text: str) -> list[dict[str, object]]:
    """The cells of a script as nbformat 4.5 has them."""
    cells: list[dict[str, object]] = []
    for n, part in enumerate(re.split(r"^# %%", text, flags=re.MULTILINE)[1:]):
        heading, _, body = part.partition("\n")
        body = body.strip("\n")
        is_text = heading.strip() == "[markdown]"
        if is_text:
            body = re.sub(r"^# ?", "", body, flags=re.MULTILINE)
        cell: dict[str, object] = {"cell_type": "markdown" if is_text else "code", "id": f"cell-{n:02d}", "metadata": {}}
        if not is_text:
            cell |= {"execution_count": None, "outputs": []}
        cells.append(cell | {"source": body.splitlines(keepends=True)})
    return cells


def notebook(text: str) -> str:
    """The notebook of a script."""
    metadata = {
        "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }
    whole = {"cells": cells_of(text), "metadata": metadata, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(whole, indent=1, ensure_ascii=False) + "\n"


def main(folder: str, *names: str) -> None:
    into = pathlib.Path(folder)
    into.mkdir(parents=True, exist_ok=True)
    for script in sorted(SCRIPTS.glob("*.py")):
        if not names or script.stem in names:
            (into / f"{script.stem}.ipynb").write_text(notebook(script.read_text()))


if __name__ == "__main__":
    main(*sys.argv[1:])
