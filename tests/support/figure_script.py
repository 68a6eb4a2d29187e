"""What stands in the script and the table that bentur writes beside a picture."""

import ast
import csv
import re


def figure_of(script):
    """What a script says of its figure; nothing of it runs."""
    return ast.literal_eval(re.search(r"^figure = (\{.*?^\]\})$", script.read_text(), re.M | re.S)[1])


def table_of(script):
    """The columns of its table, each without the empty cells below its last value."""
    with script.with_name(figure_of(script)["data"]).open(newline="", encoding="utf-8") as file:
        columns = list(zip(*list(csv.reader(file))[1:]))
    return [[float(cell) for cell in column if cell] for column in columns]


def blocks(script):
    """What is drawn, panel by panel: maps, curves, instants, each as a list of rows."""
    figure = figure_of(script)
    with script.with_name(figure["data"]).open(newline="") as file:
        columns = list(zip(*list(csv.reader(file))[1:]))
    groups = [group for panel in figure["panels"] for group in
              [*(one["columns"] for one in panel["map"]), *(one["columns"] for one in panel["curves"]),
               *([one["column"]] for one in panel["events"])]]
    return [[[float(cell) for cell in row] for row in zip(*(columns[k] for k in group)) if row[0] != ""] for group in groups]
