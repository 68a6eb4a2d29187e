#!/usr/bin/env python3
"""bentur run --figures, bentur plot and bentur spectrum -o as a user meets them.

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE.
"""

import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
sys.path[:0] = [str(SOURCE / "tests"), str(SOURCE / "tests/support")]
from figure_script import blocks  # noqa: E402
from part import part  # noqa: E402

EL_CENTRO = SOURCE / "examples/m12-el-centro.toml"
SVG = "{http://www.w3.org/2000/svg}"
WITH_AXES = ["displacement", "opening", "force", "impact", "loop", "forces", "envelope", "amplification", "drift", "modes", "spectrum",
             "floor-spectrum"]
WITH_IMPACTS = ["overview", "scene", "frame-forces", "frame-envelope", "frame-moment", "frame-shear", "frame-axial", *WITH_AXES]
NASTY = ["<script>alert(1)</script>", "\"; system('touch pwned') #", "'; system('touch pwned') #", "`touch pwned`",
         "$(touch pwned)", "@touch ^a _b {/Bold c} \\042 %s", "]]></text><script/>", "a !touch pwned", "'.system('touch pwned').'"]


NOTHING = {"PATH": "/nonexistent"}  # no other program can be started


class Figures(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="bentur-plot-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def bentur(self, status, *arguments, env=None):
        result = subprocess.run([BENTUR, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder, env=env,
                                timeout=120)
        self.assertEqual(result.returncode, status, f"{arguments}\n{result.stdout}\n{result.stderr}")
        return result

    def needs(self, program):
        if shutil.which(program) is None:
            self.skipTest(f"{program} is not installed")

    def texts(self, file):
        return ["".join(text.itertext()) for text in xml.fromstring(file.read_text()).iter(SVG + "text")]


class Run(Figures):
    def test_all_figures_with_data_and_scripts(self):
        self.needs("rsvg-convert")
        self.bentur(0, "run", "--figures", "svg,pdf", "-o", "out", SOURCE / "examples/m12-el-centro.toml")
        names = {file.name for file in (self.folder / "out/figures").iterdir()}
        self.assertEqual(names, {f"{kind}{ending}" for kind in WITH_IMPACTS for ending in ("-data.csv", ".py", ".svg", ".pdf")})
        for kind in WITH_AXES:
            texts = self.texts(self.folder / f"out/figures/{kind}.svg")
            self.assertGreaterEqual(len([text for text in texts if re.search(r"\[.+\]$", text)]), 2, f"{kind}: {texts}")

    def test_no_other_program_is_needed(self):
        self.bentur(0, "run", "-o", "out", "--figures", "svg", EL_CENTRO, env=NOTHING)
        self.bentur(0, "run", "-o", "again", "--figures", "svg", EL_CENTRO)
        for kind in WITH_IMPACTS:
            self.assertEqual((self.folder / f"out/figures/{kind}.svg").read_bytes(),
                             (self.folder / f"again/figures/{kind}.svg").read_bytes(), kind)

    def test_texts_are_in_the_language_that_is_asked_for(self):
        for language in "en", "id":
            self.bentur(0, "run", "-o", language, "--lang", language, "--figures", "svg", EL_CENTRO)
            self.bentur(0, "plot", language, "force", "--lang", language, "-o", f"{language}/alone.svg")
            alone = self.texts(self.folder / f"{language}/alone.svg")
            self.assertEqual(alone, self.texts(self.folder / f"{language}/figures/force.svg"))
        for kind, word in ("overview", "tertutup"), ("force", "Gaya kontak"), ("displacement", "Perpindahan"):
            english, indonesian = (" ".join(self.texts(self.folder / f"{one}/figures/{kind}.svg")) for one in ("en", "id"))
            self.assertIn(word, indonesian, kind)
            self.assertNotIn(word, english, kind)

    def test_peaks_of_the_summary_are_in_the_data(self):
        summary = json.loads(self.bentur(0, "run", EL_CENTRO, "-o", "out", "--figures", "svg", "--json").stdout)
        folder = self.folder / "out/figures"
        points = summary["gaps"][0]["points"]
        hardest = max(points, key=lambda point: point["peak_force"])
        force = blocks(folder / "force.py")[0]
        self.assertEqual(max(row[1] for row in force), hardest["peak_force"])
        self.assertIn([hardest["peak_force_time"], hardest["peak_force"]], force)
        contacts = blocks(folder / "displacement.py")[1]
        self.assertEqual(len(contacts), hardest["impacts"])
        building = summary["buildings"][0]
        for block, key in (0, "peak_displacement"), (1, "peak_displacement_no_contact"):
            rows = blocks(folder / "envelope.py")[block]
            self.assertEqual(rows, [[0, 0]] + [list(row) for row in zip(building[key], building["elevations"])])
        amplification = blocks(folder / "amplification.py")[0]
        for row, value in zip(amplification, building["amplification"]):
            self.assertAlmostEqual(row[0], value, delta=1e-12)
        (force,), (loop,) = blocks(folder / "impact.py"), blocks(folder / "loop.py")
        self.assertAlmostEqual(max(row[0] for row in loop), hardest["peak_penetration"],
                               delta=1e-3 * hardest["peak_penetration"])
        self.assertAlmostEqual(max(row[1] for row in force), hardest["peak_force"], delta=1e-3 * hardest["peak_force"])

    def test_letters_that_the_font_has_not_are_said(self):
        text = (SOURCE / "examples/free-impact.toml").read_text().replace('"Left"', "Left").replace("Left", '"北の建物"')
        (self.folder / "case.toml").write_text(text)
        said = self.bentur(0, "run", "case.toml", "-o", "out", "--figures", "svg").stderr
        self.assertIn('has no "北の建物"', said)
        self.assertIn("北の建物", (self.folder / "out/figures/envelope.svg").read_text())
        self.assertIn('has no "北の建物"', self.bentur(0, "plot", "out", "envelope").stderr)
        self.bentur(0, "run", SOURCE / "examples/m12-el-centro.toml", "-o", "usual", "--figures", "svg")
        self.assertNotIn("has no", self.bentur(0, "plot", "usual", "envelope").stderr)

    def test_the_area_under_every_force_is_the_impulse(self):
        """Of every impact that is drawn, of laws with short and with long contacts, in the whole run and in a part of it."""
        for name in "m12-el-centro", "kelvin-voigt-pair", "restitution-asked", "yielding-pair", "isolated-moat":
            self.bentur(0, "run", SOURCE / f"examples/{name}.toml", "-q", "-o", name, "--figures", "svg")
            with (self.folder / name / "impacts.csv").open() as file:
                impacts = list(csv.DictReader(file))
            pick = lambda impact, key: float(next(v for k, v in impact.items() if k.split(" ")[0] == key))
            forced = [impact for impact in impacts if pick(impact, "peak_force") > 0]
            hardest = max(forced, key=lambda impact: pick(impact, "peak_force"))
            drawn_in = (self.folder / name / "figures/force.py").read_text()
            in_the_figure = 1e-3 if "peak_force [N]" in impacts[0] and "F [kN]" in drawn_in else 1
            place = ("left", "elevation")
            shown = [i for i in forced if all(i[k] == hardest[k] for k in i if k.split(" ")[0] in place)]
            for table in blocks(self.folder / name / "figures/force.py"):
                checked = 0
                for impact in shown:
                    start, end, slack = pick(impact, "start"), pick(impact, "end"), 1e-9
                    if start < table[0][0] or end > table[-1][0] - slack:
                        continue
                    inside = [row for row in table if start - slack <= row[0] <= end + slack]
                    area = sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(inside, inside[1:]))
                    impulse = pick(impact, "impulse") * in_the_figure
                    self.assertAlmostEqual(area, impulse, delta=1e-3 * impulse, msg=f"{name} at {start}")
                    checked += 1
                self.assertGreater(checked, 0, name)

    def test_without_a_converter_everything_else_is_there(self):
        result = self.bentur(0, "run", EL_CENTRO, "-o", "out", "--figures", "pdf,svg", env=NOTHING)
        self.assertIn("rsvg-convert is not installed", result.stderr)
        self.assertIn("librsvg2-bin", result.stderr)
        self.assertIn("POUNDING", result.stdout)
        self.assertTrue((self.folder / "out/summary.json").exists())
        names = {file.name for file in (self.folder / "out/figures").iterdir()}
        self.assertEqual(names, {f"{kind}{ending}" for kind in WITH_IMPACTS for ending in ("-data.csv", ".py", ".svg")})

    def test_figures_of_an_earlier_run_go(self):
        self.needs("rsvg-convert")
        self.bentur(0, "run", EL_CENTRO, "-o", "out", "--figures", "svg,pdf")
        (self.folder / "out/figures/mine.svg").touch()
        self.bentur(0, "example", "m12-el-centro", "-o", ".")
        case = self.folder / "m12-el-centro.toml"
        case.write_text(case.read_text().replace("width = 0.2 ", "width = 5.0 "))
        self.bentur(0, "run", case, "-o", "out", "--figures", "svg")
        quiet = ["overview", "scene", "displacement", "opening", "envelope", "drift", "modes", "spectrum",
                 "floor-spectrum", "frame-forces", "frame-envelope", "frame-moment", "frame-shear", "frame-axial"]
        names = {file.name for file in (self.folder / "out/figures").iterdir()}
        self.assertEqual(names, {f"{kind}{ending}" for kind in quiet for ending in ("-data.csv", ".py", ".svg")} | {"mine.svg"})

    def test_wrong_usage(self):
        self.assertIn("--output", self.bentur(2, "run", EL_CENTRO, "--figures", "svg").stderr)
        self.bentur(2, "run", EL_CENTRO, "-o", "out", "--figures", "gif")
        self.assertFalse((self.folder / "out").exists())

    def test_texts_of_a_case_are_shown_and_do_nothing(self):
        self.needs("rsvg-convert")
        self.bentur(0, "example", "m12-el-centro", "-o", ".")
        case = self.folder / "m12-el-centro.toml"
        plain = case.read_text()
        for name in part(NASTY, 3):
            case.write_text(plain.replace('"Model 1"', json.dumps(name)).replace("title = ", "title = " + json.dumps(name) + " # "))
            self.bentur(0, "run", case, "-o", "out", "--figures", "svg,pdf,png")
            for file in (self.folder / "out/figures").glob("*.svg"):
                root = xml.fromstring(file.read_text())
                self.assertEqual([e for e in root.iter() if "script" in e.tag.lower()], [], f"{name}: {file}")
            shown = name.replace("]]>", "]] >")
            self.assertIn(shown, self.texts(self.folder / "out/figures/displacement.svg"))
            self.assertEqual(list(self.folder.rglob("pwned")), [], name)


class Plot(Figures):
    def run_of(self, name, *arguments):
        self.bentur(0, "run", SOURCE / "examples" / f"{name}.toml", "-o", name, "-q", *arguments)
        return f"{name}/histories.nc"

    def test_the_same_figure_as_run_draws(self):
        """And as the report of the case shows, but for title and style, which are the page's, and where it is lower there
        for paper, or in two pictures: with the same words. The opening figure stands above the others."""
        def words(svg):
            return sorted(set(re.findall("<text[^>]*>([^<]*[A-Za-z]{2}[^<]*)</text>", svg)))

        for name in part(["m12-el-centro", "linked-pair", "isolated-moat", "generic-neighbour", "struck-column",
                          "breaking-column", "hinged-frame", "kelvin-voigt-pair"], 3):
            results = self.run_of(name, "--figures", "svg")
            page = self.bentur(0, "report", SOURCE / f"examples/{name}.toml", "-o", "-").stdout
            page = re.sub('<section id="sensitivity">.*?</section>', "", page, flags=re.DOTALL)  # which no results have
            above, figures = page.split('<section id="figures">')
            page = above + re.sub('<div class="slim">.*?</div>', "", figures, flags=re.DOTALL)  # for telephones
            there = [words(svg) for svg in above.split('class="bentur" width=')[1:]]
            there += [words(one.split("</figure>")[0]) for one in page[len(above):].split("<figure")[1:]]
            shown = 0
            for drawn in (self.folder / name / "figures").glob("*.svg"):
                self.bentur(0, "plot", results, drawn.stem, "--force")
                svg = drawn.read_text()
                self.assertEqual((self.folder / drawn.name).read_text(), svg, f"{name}: {drawn.stem}")
                shown += svg[svg.index('<rect class="fill-paper"'):].rstrip() in page or words(svg) in there
            self.assertEqual(shown, 1 + page[len(above):].count("<figure"), name)
            self.assertGreater(shown, 2)

    def test_list_and_suggestion(self):
        results = self.run_of("kelvin-voigt-pair")
        listed = [line.split()[0] for line in self.bentur(0, "plot", results, "--list").stdout.splitlines()]
        self.assertEqual(listed, ["overview", "scene", "displacement", "opening", "force", "forces", "envelope", "amplification", "drift", "modes", "energy"])
        message = self.bentur(2, "plot", results, "enrgy").stderr
        self.assertIn('did you mean "energy"?', message)
        self.assertIn("--figures", self.bentur(2, "plot", results, "impact").stderr)
        self.assertIn("KIND", self.bentur(2, "plot", results).stderr)
        self.assertIn("energy_audit", self.bentur(2, "plot", self.run_of("m12-harmonic"), "energy").stderr)

    def test_options_of_histories(self):
        self.needs("rsvg-convert")
        results = self.run_of("m12-el-centro")
        self.bentur(0, "plot", results, "displacement", "--from", 2, "--to", 3, "--elevation", 200, "-o", "a.pdf")
        rows = blocks(self.folder / "a.py")[0]
        self.assertAlmostEqual(rows[0][0], 2, delta=0.0051)
        self.assertAlmostEqual(rows[-1][0], 3, delta=0.0051)
        self.assertTrue((self.folder / "a.pdf").read_bytes().startswith(b"%PDF"))
        # As wide as is asked for, also what stands on a page's width else.
        for width, pixels in ((8.8, "332.6"), (14, "529.13")):
            for kind in "forces", "envelope", "displacement":
                told = self.bentur(0, "plot", results, kind, "--width", width, "-o", f"{kind}.svg", "--force").stderr
                self.assertNotIn("cm wide", told)
                self.assertIn(f'width="{pixels}"', (self.folder / f"{kind}.svg").read_text())
        self.assertIn("100, 200, 300", self.bentur(2, "plot", results, "opening", "--elevation", 150).stderr)
        self.assertIn("gap 3", self.bentur(2, "plot", results, "opening", "--gap", 3).stderr)
        self.assertIn("--from", self.bentur(2, "plot", results, "opening", "--from", 3, "--to", 2).stderr)
        self.assertIn("--from", self.bentur(2, "plot", results, "opening", "--from", 30).stderr)
        for kind in "opening", "displacement", "force":
            message = self.bentur(2, "plot", results, kind, "--from", 4.999, "--to", 4.9990001).stderr
            self.assertIn("too near to one another", message)
        for width in 1e-3, 1e-4, 1e-5:  # narrow, and still a picture
            self.bentur(0, "plot", results, "opening", "--from", 4.999, "--to", 4.999 + width)

    def test_wrong_files(self):
        self.bentur(2, "plot", "nothing.nc", "opening")
        (self.folder / "text.nc").write_text("no results")
        self.assertIn("NetCDF", self.bentur(2, "plot", "text.nc", "opening").stderr)
        results = self.run_of("free-impact")
        self.assertIn(".svg, .pdf or .png", self.bentur(2, "plot", results, "opening", "-o", "a.gif").stderr)
        self.bentur(1, "plot", results, "opening", "-o", "/proc/none/a.svg")

    def test_without_a_converter(self):
        results = self.run_of("free-impact")
        result = self.bentur(1, "plot", results, "opening", "-o", "opening.pdf", env=NOTHING)
        self.assertIn("rsvg-convert is not installed", result.stderr)
        self.assertFalse((self.folder / "opening.pdf").exists())
        self.bentur(0, "plot", results, "opening", env=NOTHING)

    def test_a_file_name_is_a_name(self):
        results = self.run_of("free-impact")
        for name in "it's.svg", "'a'.svg", "`touch pwned`.svg", "| touch pwned.svg", "-e.svg", "~.svg", "$(x).svg":
            self.bentur(0, "plot", results, "opening", "-o", "./" + name)
            xml.fromstring((self.folder / name).read_text())
            self.assertEqual(list(self.folder.rglob("pwned*")), [])

    def test_long_histories_make_small_pictures_with_their_peaks(self):
        self.bentur(0, "example", "m12-el-centro", "-o", ".")
        case = self.folder / "m12-el-centro.toml"
        text = re.sub(r"output_step = \S+", "output_step = 0.0001", case.read_text())
        self.assertIn("output_step = 0.0001", text)
        case.write_text(text)
        summary = json.loads(self.bentur(0, "run", case, "-o", "out", "--figures", "svg", "--json").stdout)
        # The exact course, whatever the samples are: some 70 points a vibration.
        self.assertLess((self.folder / "out/figures/displacement.svg").stat().st_size, 250_000)
        peak = summary["buildings"][0]["peak_displacement"][-1]
        seen = max(abs(row[1]) for row in blocks(self.folder / "out/figures/displacement.py")[0])
        self.assertAlmostEqual(seen, peak, delta=1e-4 * peak)


class Own(Figures):
    CURVE = {"label": "mine", "x": [0, 1, 2], "y": [0, 1, 4]}

    def figure(self, **members):
        (self.folder / "own.json").write_text(json.dumps({"panels": [{"curves": [self.CURVE], **members}]}))

    def test_a_figure_of_ones_own(self):
        self.figure(x={"label": "Stiffness [kN/m]"}, y={"label": "Force [kN]"}, rules=[{"at": 2, "label": "limit"}])
        self.bentur(0, "plot", "own.json")
        self.assertLessEqual({"Stiffness [kN/m]", "Force [kN]", "mine", "limit"}, {*self.texts(self.folder / "own.svg")})
        self.assertEqual(blocks(self.folder / "own.py"), [[[0, 0], [1, 1], [2, 4]]])
        self.bentur(0, "plot", "own.json", "--width", 14, "--force")
        self.assertIn('width="529.13"', (self.folder / "own.svg").read_text())

    def test_mistakes_are_told_and_nothing_is_drawn(self):
        self.figure(curvse=[])
        self.assertIn('own.json: error: panels[0].curvse is not a known key, did you mean "curves"?', self.bentur(2, "plot", "own.json").stderr)
        self.figure(curves=[{"x": [1], "y": [1, 2]}])
        self.assertIn("own.json: error: ", self.bentur(2, "plot", "own.json").stderr)
        self.figure()
        self.assertIn("without kinds", self.bentur(2, "plot", "own.json", "force").stderr)
        self.assertIn("no such file", self.bentur(2, "plot", "none.json").stderr)
        self.assertEqual([file.name for file in self.folder.iterdir()], ["own.json"])


class Sweep(Figures):
    STUDY = 'case = "{}"\n'.format(SOURCE / "examples/m12-el-centro.toml")

    def sweep(self, name, *varies, head=""):
        (self.folder / f"{name}.toml").write_text(self.STUDY + head + "".join(f"[[vary]]\n{vary}\n" for vary in varies))
        self.bentur(0, "sweep", f"{name}.toml", "-o", f"{name}.nc", "-q")
        return f"{name}.nc"

    GAPS = 'parameter = "gap[0].width"\nfrom = 0.1\nto = 0.5\ncount = 5'
    DAMPING = 'parameter = "building[0].damping"\nvalues = [0.02, 0.05]'
    PERIODS = 'parameter = "building[1].calibrate_period"\nfrom = 0.1\nto = 0.3\ncount = 6'

    def forces_of_runs(self, widths):
        self.bentur(0, "example", "m12-el-centro", "-o", ".")
        case = self.folder / "m12-el-centro.toml"
        plain = case.read_text()
        for width in widths:
            case.write_text(plain.replace("width = 0.2 ", f"width = {width} "))
            summary = json.loads(self.bentur(0, "run", case, "--json").stdout)
            yield [point["peak_force"] for point in summary["gaps"][0]["points"]]

    def test_one_parameter_gives_a_curve_per_point(self):
        self.bentur(0, "plot", self.sweep("one", self.GAPS), "peak-force", "-o", "f.svg")
        curves = blocks(self.folder / "f.py")
        widths = [0.1, 0.2, 0.3, 0.4, 0.5]
        for i, forces in enumerate(self.forces_of_runs(widths)):
            for curve, force in zip(curves, forces):
                self.assertEqual(curve[i], [widths[i], force])
        self.assertIn("Gap width w [cm]", self.texts(self.folder / "f.svg"))
        self.assertIn("Peak contact force F [kgf]", self.texts(self.folder / "f.svg"))

    def test_two_parameters_give_curves_or_a_map(self):
        results = self.sweep("two", self.GAPS, self.DAMPING)
        self.bentur(0, "plot", results, "contact-duration", "-o", "f.svg")
        self.assertEqual(len(blocks(self.folder / "f.py")), 2)
        self.assertIn("damping 0.02", self.texts(self.folder / "f.svg"))
        self.bentur(0, "plot", results, "contact-duration", "--at", "damping=0.05", "-o", "g.svg")
        points = blocks(self.folder / "g.py")
        sums = [sum(curve[i][1] for curve in points) for i in range(5)]
        for row, expected in zip(blocks(self.folder / "f.py")[1], sums):
            self.assertAlmostEqual(row[1], expected, delta=1e-12)
        cells = self.sweep("map", self.GAPS, self.PERIODS)
        self.bentur(0, "plot", cells, "peak-force", "-o", "h.svg")
        rows = blocks(self.folder / "h.py")[0]
        self.assertEqual(len(rows), 30)
        self.assertEqual(len(rows[0]), 7)

    def test_too_much_varies(self):
        results = self.sweep("three", self.GAPS, self.DAMPING, self.PERIODS)
        self.assertIn("--at", self.bentur(2, "plot", results, "impacts").stderr)
        self.assertIn("0.02, 0.05", self.bentur(2, "plot", results, "impacts", "--at", "damping=0.03").stderr)
        self.assertIn("width", self.bentur(2, "plot", results, "impacts", "--at", "height=1").stderr)
        self.bentur(2, "plot", results, "impacts", "--at", "damping")
        self.bentur(0, "plot", "--at", "damping=0.05", results, "impacts")

    def test_samples_are_marks(self):
        head = '[sampling]\nmethod = "sobol"\ncount = 8\n'
        results = self.sweep("samples", 'parameter = "gap[0].width"\nfrom = 0.1\nto = 0.5', head=head)
        self.bentur(0, "plot", results, "amplification")
        self.assertEqual(len(blocks(self.folder / "amplification.py")[0]), 8)
        self.assertIn("width", self.bentur(2, "plot", results, "amplification", "--against", "height").stderr)

    def test_names_of_values_are_shown_and_do_nothing(self):
        labels = ["'; system('touch pwned') #", "<script>"]
        vary = f'parameter = "gap[0].contact.stiffness"\nvalues = [[1e5, 1e5, 1e5], [2e5, 2e5, 2e5]]\nlabels = {json.dumps(labels)}'
        results = self.sweep("names", self.GAPS, vary)
        self.bentur(0, "plot", results, "peak-force")
        texts = self.texts(self.folder / "peak-force.svg")
        for label in labels:
            self.assertIn(label, texts)
        self.assertEqual(list(self.folder.rglob("pwned")), [])


class Spectrum(Figures):
    def test_a_picture_of_the_same_numbers(self):
        record = SOURCE / "data/el-centro-1940-ns.csv"
        self.bentur(0, "spectrum", record, "--unit", "g", "-o", "s.svg")
        self.assertGreaterEqual(len(blocks(self.folder / "s.py")[0]), 201, "a curve")
        for name in "s.csv", "s.svg":
            self.bentur(0, "spectrum", record, "--unit", "g", "--periods", "0.05:5:41", "-o", name, "--force")
        with open(self.folder / "s.csv", newline="") as stream:
            rows = list(csv.DictReader(stream))
        acceleration, displacement = blocks(self.folder / "s.py")
        self.assertEqual([row[0] for row in acceleration], [float(row["period [s]"]) for row in rows])
        self.assertEqual([row[1] for row in displacement], [float(row["displacement [m]"]) for row in rows])
        self.assertIn("Acceleration Sa [g]", self.texts(self.folder / "s.svg"))
        self.bentur(0, "spectrum", record, "--unit", "g", "--lang", "id", "-o", "s.svg", "--force")
        self.assertIn("Periode T [s]", self.texts(self.folder / "s.svg"))


if __name__ == "__main__":
    unittest.main()
