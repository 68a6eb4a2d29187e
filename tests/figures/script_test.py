#!/usr/bin/env python3
"""The script beside each figure draws by matplotlib what the figure shows: its data, lines, marks, texts and legend.

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE. The texts are held against those of the
SVG, data and styles against what the script says of its figure (tests/support/figure_script.py).
"""

import csv
import os
import pathlib
import runpy
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from collections import Counter

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
sys.path.insert(0, str(SOURCE / "tests/support"))
from figure_script import figure_of, table_of  # noqa: E402

try:
    import matplotlib

    matplotlib.use("agg")
    import matplotlib.pyplot as plt
    from matplotlib.collections import PatchCollection, PolyCollection
except ImportError:
    plt = None

SVG = "{http://www.w3.org/2000/svg}"
DASHES = {"long-dash": "--", "dash-dot-dot": "--"}  # as matplotlib calls what has lengths of its own
RUNS = ["hinged-frame", "m12-el-centro", "plan/corner", "row-of-three"]
STUDIES = {"m12-gap-period": ("sweep", [["displacement"], ["peak-force"], ["acceleration-ratio"]]),
           "twisting-pair-ida": ("ida", [["ida", "--at", "corner=12.02"], ["fragility"]])}


def spaced(text):
    return " ".join(text.replace("\u00a0", " ").split())


def plain(text):
    """Without what the SVG has set lower or higher, as matplotlib's texts have it in letters of their own."""
    return text.translate(str.maketrans("₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "01234567890123456789-")).replace("−", "-").replace("_", "")


def texts_of_svg(file):
    """Each text once for every time that it stands there."""
    found = Counter()
    for text in xml.fromstring(file.read_text(encoding="utf-8")).iter(SVG + "text"):
        found["".join(spaced("".join(text.itertext())).split())] += 1
    return found


@unittest.skipIf(plt is None, "matplotlib is not installed")
class Scripts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="bentur-scripts-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        for run in RUNS:
            cls.bentur("run", SOURCE / f"examples/{run}.toml", "-q", "-o", cls.folder / run, "--figures", "svg")
        for study, (command, kinds) in STUDIES.items():
            results = cls.folder / f"{study}.nc"
            cls.bentur(command, SOURCE / f"examples/studies/{study}.toml", "-q", "-o", results)
            for kind in kinds:
                cls.bentur("plot", results, *kind, "-o", cls.folder / f"{study}-{kind[0]}.svg")
        cls.scripts = sorted(cls.folder.rglob("*.py"))

    @classmethod
    def bentur(cls, *arguments):
        subprocess.run([BENTUR, *map(str, arguments)], check=True, capture_output=True, text=True, timeout=300)

    def setUp(self):
        self.assertGreater(len(self.scripts), 40)

    @staticmethod
    def drawn(script):
        """The figure as the script draws it."""
        before = sys.argv, sys.path[:]
        sys.argv = [str(script), str(script.with_name(script.stem + "-drawn.svg"))]
        plt.close("all")
        try:
            runpy.run_path(str(script), run_name="__main__")
        finally:
            sys.argv, sys.path[:] = before
        return plt.gcf()

    def test_scripts_draw_what_the_picture_shows(self):
        for script in self.scripts:
            with self.subTest(script=str(script.relative_to(self.folder))):
                figure, sheet, table = figure_of(script), self.drawn(script), table_of(script)
                frames = [ax for ax in sheet.axes if ax.get_label() != "<colorbar>"]
                self.assertEqual(len(frames), len(figure["panels"]))
                for ax, panel in zip(frames, figure["panels"]):
                    self.curves(ax, panel, table)
                    for name, axis in ("x", ax.xaxis), ("y", ax.yaxis):
                        self.assertEqual(axis.get_label_text(), panel[name]["label"])
                        self.assertEqual(list(axis.get_view_interval()), panel[name]["range"])
                        self.assertEqual(list(axis.get_majorticklocs()), panel[name]["ticks"])
                        self.assertEqual(list(axis.get_minorticklocs()), panel[name]["minor"])
                self.size(script, sheet)
                self.legend(sheet, figure)
                self.texts(script, sheet)

    def test_no_two_columns_have_one_name(self):
        """Each says of what it is, and its unit: of a picture to scale too."""
        for script in self.scripts:
            with script.with_name(figure_of(script)["data"]).open(newline="", encoding="utf-8") as file:
                names = next(csv.reader(file))
            self.assertEqual([name for name, count in Counter(names).items() if count > 1], [], script)
            if script.stem.startswith("frame-"):
                for name in names:
                    self.assertRegex(name, r"^[^:]+, .*\b[MVN] \[.+\].*: [xy] \[c?m\] \(.+\)(, from|, to)?(, \d+)?$", script)

    def size(self, script, sheet):
        """Of the file that is the picture's, with all texts on it."""
        of = lambda file, unit: [float(xml.parse(file).getroot().get(side).removesuffix(unit)) for side in ("width", "height")]
        drawn, shown = of(script.with_name(script.stem + "-drawn.svg"), "pt"), of(script.with_suffix(".svg"), "")
        for points, pixels in zip(drawn, shown):
            self.assertAlmostEqual(points / 72, pixels / 96, delta=0.002)  # [inch]
        renderer = sheet.canvas.get_renderer()
        for text in sheet.findobj(matplotlib.text.Text):
            if not text.get_visible() or not text.get_text().strip():
                continue
            box = text.get_window_extent(renderer)
            self.assertTrue(box.x0 > -2 and box.y0 > -2 and box.x1 < sheet.bbox.width + 2 and box.y1 < sheet.bbox.height + 2,
                            f"{text.get_text()} is cut off")

    def curves(self, ax, panel, table):
        given = [curve for curve in panel["curves"]]
        lines = [line for line in ax.lines if len(line.get_xdata()) and line.get_transform() == ax.transData]
        areas = [one for one in ax.collections if isinstance(one, PolyCollection)]
        rows = [[table[column] for column in curve["columns"]] for curve in given]
        self.assertEqual(len(areas), sum(len(data) == 3 for data in rows))
        parts = {"line": iter(line for line in lines if line.get_linestyle() != "None"),
                 "mark": iter(line for line in lines if line.get_marker() != "None")}
        areas, orders = iter(areas), {"line": [0.5], "mark": [2]}  # over rules, and over all lines
        for curve, data in zip(given, rows):
            if len(data) == 3:
                orders["line"].append(next(areas).get_zorder())
                continue
            self.assertTrue(curve["line"] != "None" or curve["mark"] != "None", "a curve that cannot be seen")
            for part in parts:
                if curve[part] == "None" or not data[0]:
                    continue
                line = next(parts[part])
                orders[part].append(line.get_zorder())
                self.assertEqual(Counter(map(str, line.get_xdata())), Counter(map(str, data[0])))
                self.assertEqual(Counter(map(str, line.get_ydata())), Counter(map(str, data[1])))
                if part == "line":
                    self.assertEqual(line.get_linestyle(), DASHES.get(curve["line"], curve["line"]))
                else:
                    self.assertEqual(line.get_marker(), curve["mark"])
                    if not curve["filled"]:
                        self.assertIn(line.get_markerfacecolor(), ("none", "white"))
        for order in orders.values():
            self.assertEqual(order, sorted(order), "each curve lies over those before it, as in the picture")
        for scale, boxes in zip(panel["map"], [one for one in ax.collections if isinstance(one, PatchCollection)], strict=True):
            self.assertEqual(list(boxes.get_array()), list(table[scale["columns"][-1]]))

    def legend(self, sheet, figure):
        """Of each entry a text and what stands before it; no text lies on another."""
        entries = [entry for panel in figure["panels"] for entry in panel["legend"]]
        part = [figure["part"]] if figure["part"] else []  # what of many it shows, below all
        beside = [scale["label"] for panel in figure["panels"] for scale in panel["map"]]  # scales of colours
        self.assertEqual(sorted(text.get_text() for text in sheet.texts),
                         sorted([entry["label"] for entry in entries] + part + beside))
        renderer = sheet.canvas.get_renderer()
        titles = [ax.title for ax in sheet.axes if ax.title.get_text()]
        boxes = [text.get_window_extent(renderer) for text in [*sheet.texts, *titles]]
        for i, one in enumerate(boxes):
            for other in boxes[:i]:
                across = min(one.x1, other.x1) - max(one.x0, other.x0)
                up = min(one.y1, other.y1) - max(one.y0, other.y0)
                self.assertFalse(across > 1 and up > 0.25 * min(one.height, other.height), "texts on one another")

    def texts(self, script, sheet):
        shown = Counter()
        sheet.canvas.draw()
        for text in sheet.findobj(matplotlib.text.Text):
            if text.get_visible() and text.get_text():
                shown["".join(spaced(text.get_text()).split())] += 1
        self.assertFalse([text for text in shown if "$" in text or "mathdefault" in text])
        wanted = texts_of_svg(script.with_suffix(".svg"))
        joined = plain("".join(sorted(shown)))
        for text in wanted:
            # A title or label of several lines is one text there.
            self.assertIn(plain(text), joined)


if __name__ == "__main__":
    unittest.main()
