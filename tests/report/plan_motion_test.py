#!/usr/bin/env python3
"""Buildings in plan in motion, as the reader of their report meets them: what report_test.py is for those of a row.

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE.
"""

import csv
import json
import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(1, str(pathlib.Path(__file__).parents[1] / "support"))
import browser  # noqa: E402
import report_test  # noqa: E402
from figure_script import blocks  # noqa: E402
from report_test import BENTUR, PHONE, PLAN, SOURCE  # noqa: E402

WALL = """
[[building]]
name = "W"
rigid = true
elevations = [3.5]
plan = { corner = [-0.52, 0], size = [0.5, 18] }
"""


class PlanMotion(report_test.Reports):
    def case(self, more="", **changes):
        """The example with these changes, beside its record."""
        text = PLAN.read_text().replace("../../data", str(SOURCE / "data"))
        for before, after in changes.items():
            text = text.replace(before, after)
        path = self.folder / "plan.toml"
        path.write_text(text + more)
        return path

    def told(self, case):
        with self.impacts(case).open() as file:
            return list(csv.DictReader(file))

    def data(self):
        return json.loads(self.js("document.getElementById('data').textContent"))

    def magnify(self, zoom):
        self.js(f"(() => {{ const m = document.getElementById('magnify'); m.value = {zoom};"
                "m.dispatchEvent(new Event('input')); })()")

    def choose(self, level):
        self.js(f"(() => {{ const s = document.getElementById('level'); s.value = {level};"
                "s.dispatchEvent(new Event('change')); })()")

    def openings(self):
        """Name and opening of each contact point in the table."""
        rows = self.js("[...document.getElementById('live').rows].map(row => [...row.cells].map(cell => cell.textContent))")
        return {name: float(value.replace("\N{MINUS SIGN}", "-")) for name, value in rows}

    def faces(self):
        """Where both faces of each contact point are drawn that is seen."""
        circles = self.js("[...document.querySelectorAll('#stage .contact')].map(one => one.getAttribute('opacity') === '1'"
                          " ? [Number(one.getAttribute('cx')), Number(one.getAttribute('cy'))] : null)")
        pairs = list(zip(circles[::2], circles[1::2]))
        return {i: pair for i, pair in enumerate(pairs) if pair[0] is not None}

    def caption(self):
        return self.js("document.querySelector('#stage .caption').textContent")

    def test_starts_at_the_hardest_impact_and_says_so(self):
        page = self.report(PLAN)
        self.opened(page)
        hardest = max(self.told(PLAN), key=lambda impact: float(impact["peak_force [kN]"]))
        data = self.data()
        self.assertAlmostEqual(self.shown_time(), float(hardest["peak_force_time [s]"]), delta=1e-9)
        [point] = self.contacts()
        self.assertEqual(data["points"][point]["elevation"], float(hardest["elevation [m]"]))
        self.assertEqual(data["points"][point]["along"], f"y = {hardest['y [m]']} m")
        self.assertIn(f"magnified {data['scene']['magnification']:g} times, level 6.7 m", self.caption())
        self.assertIn("level 6.7 m, y = 18 m", self.js("document.getElementById('event').textContent"))
        self.clean(page)

    def test_contact_points_flash_from_start_to_end_of_each_impact(self):
        self.opened(self.report(PLAN))
        points = self.data()["points"]
        for impact in self.told(PLAN):
            start, end = float(impact["start [s]"]), float(impact["end [s]"])
            place = float(impact["elevation [m]"]), f"y = {impact['y [m]']} m"
            for moment, on in ((start + end) / 2, True), (start + 1e-9, True), (start - 1e-6, False), (end + 1e-6, False):
                self.scrub(moment)
                flashing = [(points[i]["elevation"], points[i]["along"]) for i in self.contacts()]
                self.assertEqual(place in flashing, on, (impact, moment))

    def test_openings_shown_are_those_of_the_impacts(self):
        self.opened(self.report(PLAN))
        elevations = [level["elevation"] for level in self.data()["scene"]["levels"]]
        for impact in self.told(PLAN):
            self.choose(elevations.index(float(impact["elevation [m]"])))
            depth, at = float(impact["peak_penetration [m]"]), f"y = {impact['y [m]']} m"
            # Samples of 16 bits every millisecond, between which the picture interpolates.
            self.scrub(float(impact["start [s]"]))
            self.assertAlmostEqual(self.openings()[at], 0, delta=2e-5)
            self.scrub(float(impact["peak_force_time [s]"]))
            self.assertAlmostEqual(self.openings()[at], -depth, delta=2e-5)

    def test_corners_that_touch_touch_in_the_picture_at_every_magnification(self):
        self.opened(self.report(PLAN))
        data = self.data()
        for impact in data["impacts"]:
            self.scrub(impact[1])
            self.choose(data["points"][impact[0]]["level"])
            for zoom in -1, 0, 1:
                self.magnify(zoom)
                left, right = self.faces()[impact[0]]
                self.assertAlmostEqual(left[0], right[0], delta=0.02 + 0.01 * 10 ** zoom)

    def test_a_level_is_chosen_with_its_floors_and_points(self):
        self.opened(self.report(PLAN))
        self.assertEqual(self.js("[...document.getElementById('level').options].map(o => o.textContent)"), ["6.7 m", "3.5 m"])
        thick = "document.querySelector('#stage .footprint').getAttribute('d')"
        thin = "[...document.querySelectorAll('#stage .floor')].map(line => line.getAttribute('d'))"
        self.assertEqual(self.js(thick), self.js(thin)[1])
        self.assertEqual(set(self.faces()), {2, 3})
        self.choose(1)
        self.assertEqual(self.js(thick), self.js(thin)[0])
        self.assertEqual(set(self.faces()), {0, 1})
        self.assertIn("level 3.5 m", self.caption())
        self.assertEqual(set(self.openings()), {"y = 0 m", "y = 18 m"})
        self.click("#hardest")  # shows its own level
        self.click("#play")
        self.assertIn("level 6.7 m", self.caption())

    def test_plays_flashes_and_pauses(self):
        told = self.told(PLAN)
        self.opened(self.report(PLAN))
        self.js("""(() => { window.flashes = 0; new MutationObserver(list => { for (const m of list)
            if (m.oldValue === '0' && m.target.dataset.contact === '1') ++window.flashes; })
            .observe(document.getElementById('stage'),
                     {subtree: true, attributeFilter: ['data-contact'], attributeOldValue: true}); })()""")
        self.scrub(2.0)
        drawn = "document.querySelector('#stage .footprint').getAttribute('d')"
        before = self.js(drawn)
        self.click("#play")
        self.until(lambda: self.shown_time() > 2.7)
        self.click("#play")
        end = self.shown_time()
        self.assertNotEqual(self.js(drawn), before)
        within = [impact for impact in told if 2.0 <= float(impact["start [s]"]) <= end]
        self.assertGreater(len(within), 1)
        self.assertEqual(self.js("window.flashes"), len(within))
        self.assertEqual(self.shown_time(), end)

    def test_a_still_is_what_the_page_shows_at_that_time(self):
        case = self.case(**{"duration = 15.0": "duration = 15.0\noutput_step = 0.001"})
        folder = self.folder / "results"
        subprocess.run([BENTUR, "run", "-q", str(case), "-o", str(folder), "--figures", "svg"], check=True, timeout=300)
        still = [[tuple(point) for point in table] for table in blocks(folder / "figures/scene.py")]
        self.opened(self.report(case))
        data = self.data()
        drawn = self.js("(() => { const data = JSON.parse(document.getElementById('data').textContent), { scene } = data;"
                        "const { buildings, motionAt } = benturSamples(data), motion = motionAt(data.shown);"
                        "const now = benturPlanPlaces(scene, scene.magnification, motion);"
                        "const rest = benturPlanPlaces(scene, scene.magnification, buildings.map(() => []));"
                        "const { floors } = scene.levels[scene.level];"
                        "const outlines = (place) => scene.outlines.map((line, b) => line.map((at) => place(b, floors[b], at)));"
                        "const marks = (cross) => scene.marks.filter((m) => m.cross === cross && m.floor === floors[m.building])"
                        ".map((m) => now(m.building, m.floor, m.at));"
                        "return [...outlines(rest), ...outlines(now), marks(true), marks(false)]; })()")
        self.assertEqual(len(data["buildings"]), 2)
        delta = 1e-3 * data["scene"]["magnification"] * data["scene"]["largest"]  # of the still's straight lines
        for line in drawn:
            closest = min((max(abs(a - b) for one, other in zip(line, table) for a, b in zip(one, other))
                           for table in still if len(table) == len(line)), default=None)
            self.assertIsNotNone(closest, line)
            self.assertLess(closest, delta)

    def test_a_wall_among_them_stands_still_and_gaps_have_their_names(self):
        page = self.report(self.case(WALL))
        for width in 1000, PHONE:
            self.opened(page, width)
            self.assertLessEqual(self.js("document.documentElement.scrollWidth"), width)
            wall = "document.querySelectorAll('#stage .footprint')[2].getAttribute('d')"
            at_rest = self.js(wall)
            self.scrub(5.0)
            self.assertEqual(self.js(wall), at_rest)
            self.choose(1)
            self.assertEqual({name.split(",")[0] for name in self.openings()}, {"Walled | Frame", "W | Walled"})
            self.clean(page)

    def test_corner_to_corner_has_one_opening_and_below_zero_only_in_contact(self):
        self.opened(self.report(self.block(12)))
        data = self.data()
        places = {(point["gap"], point["along"]) for point in data["points"] if point["level"] == 0}
        self.assertLess(len(places), sum(point["level"] == 0 for point in data["points"]), "a corner has two normals")
        shown = ("[...document.getElementById('live').rows].map(row => [row.cells[0].textContent,"
                 " row.cells[1].textContent, row.cells[1].className])")
        for impact in sorted(data["impacts"], key=lambda one: -one[3])[:40]:
            level = data["points"][impact[0]]["level"]
            self.choose(level)
            for moment in impact[4], impact[2] + 0.02, impact[1] - 0.02:
                self.scrub(moment)
                rows = self.js(shown)
                self.assertEqual(len({name for name, _, _ in rows}), len(rows))
                under_way = {data["points"][one[0]]["gap"] for one in data["impacts"] if one[1] <= moment <= one[2]
                             and data["points"][one[0]]["level"] == level}
                for name, value, tone in rows:
                    if tone != "marked":
                        self.assertGreater(float(value.replace("\N{MINUS SIGN}", "-")), -1e-4, (name, moment))
                marked = {name.split(",")[0] for name, _, tone in rows if tone == "marked"}
                self.assertLessEqual(marked, {" | ".join(data["names"]["short"][point[side]] for side in ("left", "right"))
                                              for point in data["points"] if point["gap"] in under_way})
                for _, value, tone in rows:  # what has just met is no fault
                    self.assertTrue(tone != "marked" or value.startswith("\N{MINUS SIGN}"), value)
                apart = [value for _, value, _ in rows if not value.startswith("\N{MINUS SIGN}") and float(value) > 1e-4]
                self.assertEqual(apart, sorted(apart, key=float))  # what is least open first

    def test_names_lie_within_outlines_that_turn_inwards(self):
        """Both ends of each, on a telephone of all but the small workshop; and no numbers in their place."""
        page = self.report(SOURCE / "examples" / "plan" / "crossroads.toml")
        for width in 1000, PHONE:
            self.opened(page, width)
            self.scrub(0.0)
            names = self.js("""[...document.querySelectorAll('#stage .name')].map((name, b) => {
              const { x, y, width, height } = name.getBBox(), path = document.querySelectorAll('#stage .footprint')[b];
              return [name.textContent, [0.02, 0.5, 0.98].every((part) =>
                path.isPointInFill(new DOMPoint(x + part * width, y + height / 2)))];
            })""")
            self.assertEqual([name for name, _ in names], ["Corner", "East", "North", "Workshop"])
            for name, within in names[:3] if width == PHONE else names:
                self.assertTrue(within, (name, width))
            self.clean(page)

    def test_speaks_indonesian(self):
        page = self.report(PLAN, "--lang", "id")
        self.opened(page)
        self.assertIn("elevasi 6.7 m", self.caption())
        self.assertIn("pusat kekakuan", self.js("document.getElementById('stage').textContent"))
        self.assertEqual(self.js("document.getElementById('level-choice').textContent").strip()[:7], "Elevasi")
        self.assertIn("Dilihat dari atas", self.js("document.querySelector('#motion > .note:last-child').textContent"))

    def test_a_number_of_the_list_shows_its_impact(self):
        self.opened(self.report(PLAN))
        self.js("[...document.querySelectorAll('#impact-list td button')].find(b => b.textContent === '2').click()")
        second = self.data()["impacts"][1]
        self.assertLess(abs(self.shown_time() - second[1]), 2 * (second[2] - second[1]))


if __name__ == "__main__":
    if browser.find() is None:
        print("skipped: chromium is not installed")
        sys.exit(77)
    unittest.main()
