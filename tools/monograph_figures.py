"""Figures of docs/monograph that `bentur plot` does not offer: described in JSON, drawn by it."""

import json
import subprocess

TONES = [("black", "solid"), ("teal", "dashed"), ("purple", "dash-dot"), ("grey", "dotted")]


class Panel:
    """Curves (label, [(x, y), ...]) in one frame; x_range and y_range None: from the data. `solid`: long histories, where dashes
    would blur; the first curve then lies on top. `band`: what a claim says of x, shaded, with a mark at the largest value of
    each curve; `rule`: a line at this y, where nothing changes."""

    def __init__(self, curves, x, y, title="", x_range=None, y_range=None, solid=False, band=None, rule=None):
        self.band, self.rule = band, rule
        self.curves, self.x, self.y, self.title, self.solid = curves, x, y, title, solid
        self.x_range = x_range or bounds([p[0] for _, c in curves for p in c], 0)
        self.y_range = y_range or bounds([p[1] for _, c in curves for p in c], 0.06)

    def described(self, height):
        curves = []
        for (label, points), (tone, line) in zip(self.curves, TONES):
            xs, ys = zip(*points)
            curves.append({"label": label, "x": xs, "y": ys, "tone": tone, "line": "solid" if self.solid else line})
        if self.solid:
            curves.reverse()
        if self.band:
            for curve in list(curves):
                at = max(range(len(curve["y"])), key=curve["y"].__getitem__)
                curves.append({"x": [curve["x"][at]], "y": [curve["y"][at]], "tone": curve["tone"], "line": "none", "mark": "disc"})
            curves.insert(0, {"x": self.band, "y": [self.y_range[0]] * 2, "top": [self.y_range[1]] * 2, "tone": "pale-orange"})
        return {"title": self.title, "height": height, "curves": curves,
                "x": {"label": self.x, "from": self.x_range[0], "to": self.x_range[1]},
                "y": {"label": self.y, "from": self.y_range[0], "to": self.y_range[1]},
                "rules": [] if self.rule is None else [{"at": self.rule}]}


def bounds(values, margin):
    low, high = min(values), max(values)
    low = 0 if 0 <= low < 0.5 * high else low
    room = margin * (high - low)
    return (low if low == 0 else low - room), high + room


def draw(program, file, panels, columns=1, width=17.0):
    """FILE, an SVG, by PROGRAM, of panels as docs/figures.md has them, its description beside it; WIDTH of all in cm."""
    description = file.with_suffix(".json")
    description.write_text(json.dumps({"panels": panels, "columns": columns, "width": width, "shared_legend": True}))
    subprocess.run([program, "plot", description, "-o", file, "--force"], check=True, capture_output=True)
