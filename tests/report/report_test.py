#!/usr/bin/env python3
"""The report as its reader meets it: opened from disk in Chromium, played, scrubbed, sorted, downloaded, printed.

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE. `report_test.py --keep DIR` keeps
screenshots of every example at phone and A4 width and its pages as PDF in DIR, to be looked at.
"""

import base64
import csv
import json
import math
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import tomllib
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path[1:1] = [str(pathlib.Path(__file__).parents[1] / "support"), str(pathlib.Path(__file__).parents[1])]
import browser  # noqa: E402
from figure_script import blocks  # noqa: E402
from part import part  # noqa: E402

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
PHONE, A4 = 390, 794  # CSS pixels
AXE = SOURCE / "build" / "axe" / "node_modules" / "axe-core" / "axe.min.js"  # fetched by ./dev test --all
FONTS = "DejaVu Sans", "Liberation Sans"
# Sizes of the letters of figures that are shown [px]; a picture that is too low for its width is drawn smaller than that.
LETTERS = """[...document.querySelectorAll('figure svg')].flatMap(svg => {
    const shown = svg.getBoundingClientRect(), box = svg.viewBox.baseVal;
    const scale = Math.min(shown.width / box.width, shown.height / box.height);
    return [...svg.querySelectorAll('text')].filter(text => scale && text.textContent.trim())
      .map(text => parseFloat(getComputedStyle(text).fontSize) * scale); })"""
CUT = """[...document.querySelectorAll('.readout .wide')].flatMap(box => [...box.querySelectorAll('tr')].filter(row => {
    const end = box.getBoundingClientRect().top + box.clientHeight, place = row.getBoundingClientRect();
    return place.top < end - 2 && place.bottom > end + 2; }).map(row => row.textContent))"""
# Tables of which a part is out of sight, folded ones unfolded.
BEYOND = """(() => { const folded = [...document.querySelectorAll('details:not([open])')];
    for (const one of folded) one.open = true;
    const found = [...document.querySelectorAll('.wide > table')].filter(one => one.scrollWidth > one.parentElement.clientWidth + 1)
      .map(one => one.textContent.slice(0, 60));
    for (const one of folded) one.open = false;
    return found; })()"""
ASTRAY = """[...document.querySelectorAll('.figures figure')].filter((figure, k, all) => { if (!k) return false;
    const before = all[k - 1].getBoundingClientRect(), now = figure.getBoundingClientRect();
    return !(now.top >= before.bottom - 1 || (Math.abs(now.top - before.top) < 1 && now.left >= before.right));
    }).map(figure => figure.textContent)"""
# Texts that leave their picture, and pairs that lie on one another, of every figure of the page in one font.
MISPLACED = """(font => { const style = document.createElement('style');
    style.textContent = `figure svg text, figure svg tspan { font-family: '${font}' !important }`;
    document.head.append(style); const found = [];
    for (const svg of document.querySelectorAll('figure svg')) {
      const frame = svg.getBoundingClientRect(), scale = frame.width / svg.viewBox.baseVal.width, boxes = [];
      const name = svg.getAttribute('aria-label');
      for (const text of svg.querySelectorAll('text')) {
        const box = text.getBoundingClientRect(); if (!text.textContent.trim() || !box.width) continue;
        const slack = 1.5 * scale;
        if (box.left < frame.left - slack || box.right > frame.right + slack || box.top < frame.top - slack ||
            box.bottom > frame.bottom + slack) found.push(`${name}: "${text.textContent}" leaves it`);
        boxes.push([text.textContent, box]); }
      for (let i = 0; i < boxes.length; ++i) for (let j = 0; j < i; ++j) {
        const [a, b] = [boxes[i][1], boxes[j][1]], slack = 2.5 * scale;
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const along = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        if (across > slack && along > slack) found.push(`${name}: "${boxes[i][0]}" on "${boxes[j][0]}"`); } }
    style.remove(); return found; })"""


def leaves(table, key=""):
    """Key and texts of every text of the catalogue."""
    if "en" in table and isinstance(table["en"], str):
        yield key, {language: table[language] for language in ("en", "id")}
    for name, inner in table.items():
        if isinstance(inner, dict):
            yield from leaves(inner, f"{key}.{name}" if key else name)


PLAN = SOURCE / "examples" / "plan" / "twisting-pair.toml"


class Reports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="bentur-report-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.browser = browser.Browser(browser.find(), cls.folder)
        cls.addClassCleanup(cls.browser.close)

    def report(self, case, *options):
        output = self.folder / "report.html"
        result = subprocess.run([BENTUR, "report", str(case), "-o", str(output), *options], capture_output=True,
                                text=True, timeout=300)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, "")
        return output

    def example(self, name, *options):
        return self.report(SOURCE / "examples" / f"{name}.toml", *options)

    def block(self, count):
        """A case of this many houses, six in a street."""
        houses = []
        for n in range(count):
            storeys, stiffness = 1 + 5 * n % 4, 15000.0 + 4000 * (7 * n % 9)
            held = "".join(f"{key} = {by * stiffness * storeys}\n" for key, by in (("x", 1), ("y", 1), ("torsion", 40)))
            houses.append(f'[[building]]\nname = "H{n + 1}"\ndamping = 0.05\n[building.plan]\n'
                          f"corner = [{10.03 * (n % 6):.2f}, {12.03 * (n // 6):.2f}]\nsize = [10.0, 12.0]\n"
                          f"storey_heights = {[3.0] * storeys}\nmasses = {[120.0] * storeys}\n"
                          f"[building.rigidity]\ncentre = [4.0, 6.0]\n{held}")
        case = self.folder / "block.toml"
        case.write_text('units = { length = "m", force = "kN" }\nanalysis = { duration = 8.0 }\n'
                        'plan = { clearance = 0.1, contact = { law = "linear", stiffness = 4e5 } }\n'
                        'excitation = { kind = "harmonic", period = 0.9, displacement_amplitude = 0.04, angle = 30.0 }\n'
                        + "".join(houses))
        return case

    def opened(self, page, width=1000):
        self.browser.resize(width, 900)
        self.browser.open(page)
        self.assertTrue(self.js("document.documentElement.classList.contains('ready')"), self.browser.complaints())

    def js(self, expression):
        return self.browser.evaluate(expression)

    def click(self, selector):
        self.js(f"document.querySelector({json.dumps(selector)}).click()")

    def scrub(self, time_):
        self.js(f"(() => {{ const s = document.getElementById('scrub'); s.step = 'any'; s.value = {time_!r};"
                "s.dispatchEvent(new Event('input')); })()")

    def contacts(self):
        """Contact points whose flash is on."""
        return self.js("Array.from(document.querySelectorAll('#stage .hit')).filter(m => m.dataset.contact === '1')"
                       ".map(m => Number(m.dataset.point))")

    def until(self, holds):
        """Waits for it, however long it takes; what hangs ends here."""
        deadline = time.monotonic() + 300
        while not holds():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)

    def shown_time(self):
        return self.js("Number(document.getElementById('stage').dataset.time)")

    def impacts(self, case):
        """The impact list of the program itself."""
        folder = self.folder / "results"
        subprocess.run([BENTUR, "run", "-q", str(case), "-o", str(folder)], check=True, timeout=300)
        return folder / "impacts.csv"

    def clean(self, page):
        self.assertEqual(self.browser.complaints(), [])
        self.assertEqual(self.browser.requests(), [page.resolve().as_uri()], "the page asks for nothing but itself")


    def well_drawn(self):
        """Figures whose texts all stand where they can be read, in the widest and in the usual font."""
        for font in FONTS:
            self.assertEqual(self.js(f"{MISPLACED}({json.dumps(font)})"), [], font)

    def well_worded(self, page, language):
        """No word of the command line or of the other language."""
        text = page.read_text()
        self.assertNotIn("<title>", text.replace("<title>", "", 1), "that of the page alone")
        for word in "using 1:2", "Gnuplot", "--at", "--from":
            self.assertNotIn(word, text)
        if language == "en":
            return
        catalogue = tomllib.loads((SOURCE / "src/bentur/report/html/texts.toml").read_text())
        english = {texts["en"] for key, texts in leaves(catalogue) if texts["en"] != texts["id"] and "{" not in texts["en"]}
        shown = self.js("Array.from(document.querySelectorAll('figure text, th, h2, h3, figcaption, summary, button'))"
                        ".map(e => e.textContent.replace(/ \\[.*\\]$/, '').trim())")
        self.assertEqual(sorted(english & set(shown)), [])

    def accessible(self):
        if not AXE.exists():
            self.skipTest("axe-core is not installed: ./dev test --all fetches it where npm is")
        self.js(AXE.read_text() + ";0")
        found = self.js("axe.run(document, {resultTypes: ['violations']}).then(r => r.violations.map(v => v.id + ': ' +"
                        "v.nodes.slice(0, 3).map(n => n.html.slice(0, 120) + ' ' + (n.any[0] || n.all[0] || {}).message).join(' | ')))")
        self.assertEqual(found, [])


class Pages(Reports):
    def test_no_violation_of_accessibility(self):
        for name, language in ("m12-el-centro", "en"), ("row-of-three", "id"), ("yielding-pair", "en"):
            self.opened(self.example(name, "--lang", language))
            self.js("document.querySelectorAll('details').forEach(d => { d.open = true; })")
            self.accessible()
            self.browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])
            self.accessible()
            self.browser.call("Emulation.setEmulatedMedia", features=[])

    def test_the_report_of_buildings_in_plan_is_accessible_and_follows_the_dark(self):
        for scheme, language in ("light", "en"), ("dark", "id"):
            self.browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            self.opened(self.report(PLAN, "--lang", language), A4)
            self.clean(self.folder / "report.html")
            self.accessible()
            self.assertGreater(self.js("document.querySelectorAll('svg').length"), 7)
        self.browser.call("Emulation.setEmulatedMedia", features=[])

    def test_every_example_opens_without_a_complaint_and_fits_phone_and_a4(self):
        for case in [*part((SOURCE / "examples").glob("*.toml"), 10), PLAN]:
            for language in "en", "id":
                page = self.report(case, "--lang", language)
                for width in PHONE, A4:
                    with self.subTest(case=case.name, language=language, width=width):
                        self.opened(page, width)
                        self.assertLessEqual(self.js("document.documentElement.scrollWidth"), width)
                        self.assertEqual(self.js("document.documentElement.lang"), language)
                        self.clean(page)
                        self.assertGreaterEqual(min(self.js(LETTERS)), 8, "px of the smallest letter of a figure")
                        self.assertEqual(self.js(CUT), [], "lines of the read-out that are cut")
                        if width == PHONE:
                            self.assertEqual(self.js(BEYOND), [], "tables that run off a phone")
                        if width == A4:
                            self.assertEqual(self.js(ASTRAY), [], "figures that do not follow the one before")
                            self.well_drawn()
                            self.well_worded(page, language)

    def test_reports_of_results_open_as_well(self):
        results, sweep = self.folder / "results", self.folder / "sweep.nc"
        subprocess.run([BENTUR, "run", str(SOURCE / "examples" / "m12-el-centro.toml"), "-q", "-o", str(results)], check=True, timeout=300)
        study = SOURCE / "examples" / "studies" / "m12-gaps.toml"
        subprocess.run([BENTUR, "sweep", "-q", str(study), "-o", str(sweep)], check=True, timeout=300)
        page = self.report(results)
        self.opened(page)
        self.assertEqual(self.js("document.getElementById('impact-list').tBodies[0].rows.length"), 37)
        self.clean(page)
        page = self.report(sweep)
        for width in PHONE, A4:
            self.browser.resize(width, 900)
            self.browser.open(page)
            self.assertLessEqual(self.js("document.documentElement.scrollWidth"), width)
            self.assertIn("202", self.js("document.querySelector('.lead').textContent"))
            self.clean(page)
            self.accessible()
        self.well_drawn()
        self.well_worded(page, "en")

    def test_the_report_of_an_incremental_dynamic_analysis_answers(self):
        """On a study of three directions: levels, records and gaps."""
        for name in "one", "two":
            values = [3 * math.sin(0.31 * i + len(name)) + 2 * math.sin(0.13 * i * (i if name == "two" else 1)) for i in range(200)]
            (self.folder / f"{name}.txt").write_text("".join(f"{0.02 * i:.2f} {value:.6f}\n" for i, value in enumerate(values)))
        study = self.folder / "study.toml"
        study.write_text(f'''case = "{SOURCE / "examples" / "two-frames-si.toml"}"
[[vary]]
parameter = "excitation.file"
name = "record"
files = ["one.txt", "two.txt"]
unit = "m/s2"
[[vary]]
parameter = "gap[0].width"
values = [0.02, 0.1]
[ida]
intensity = "pga"
unit = "g"
levels = [0.1, 0.3, 0.6]
''')
        results = self.folder / "ida.nc"
        subprocess.run([BENTUR, "ida", "-q", str(study), "-o", str(results)], check=True, timeout=300)
        for language in "en", "id":
            page = self.report(results, "--lang", language)
            self.browser.resize(A4, 900)
            self.browser.open(page)
            self.clean(page)
            self.accessible()
            self.well_drawn()
            self.well_worded(page, language)
            text = self.js("document.getElementById('probability').textContent")
            for word in "θ", "β", "95 %", "10 %", "50 %":
                self.assertIn(word, text)
            self.assertGreaterEqual(self.js("document.querySelectorAll('figure svg').length"), 2)
            self.assertNotIn("M1", self.js("document.querySelector('h1').textContent"))

    def test_reports_by_a_spectrum_are_accessible(self):
        for scheme in "light", "dark":
            self.browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            self.browser.resize(A4, 900)
            page = self.report(SOURCE / "examples" / "gaps" / "design-spectrum.toml")
            self.browser.open(page)
            self.clean(page)
            self.accessible()
        self.browser.call("Emulation.setEmulatedMedia", features=[])

    def test_a_figure_that_stands_alone_takes_the_page_with_letters_no_larger(self):
        page = self.report(SOURCE / "examples" / "gaps" / "design-spectrum.toml")
        self.browser.resize(1000, 900)
        self.browser.open(page)
        self.assertEqual(self.js("document.querySelectorAll('.figures figure').length"), 1)
        alone, page_width = self.js("['.figures figure', 'main'].map(s => document.querySelector(s).clientWidth)")
        self.assertGreater(alone, 0.8 * page_width)
        drawn, units = self.js("(svg => [svg.clientWidth, svg.viewBox.baseVal.width])(document.querySelector('.figures svg'))")
        self.assertLess(drawn / units, 1.45)  # that of a figure in a column

    def test_sizes(self):
        page = self.example("m12-el-centro")
        self.assertLess(page.stat().st_size, 2e6)
        text = (SOURCE / "examples" / "two-frames-si.toml").read_text()
        self.assertEqual(text.count("duration = 20.0"), 1)
        case = self.folder / "long.toml"
        case.write_text(text.replace("duration = 20.0", "duration = 60.0").replace("../data", str(SOURCE / "data")))
        self.assertLess(self.report(case).stat().st_size, 10e6)

    def test_pages_print_on_a4(self):
        self.opened(self.example("m12-el-centro"))
        printed = self.folder / "report.pdf"
        self.browser.pdf(printed)
        boxes = set(re.findall(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", printed.read_bytes()))
        self.assertEqual({(round(float(w)), round(float(h))) for w, h in boxes}, {(595, 842)})

    def test_a_block_of_thirty_houses_prints_on_twelve_pages(self):
        """With the needs of all gaps, all floors, one row of all that each house has of the case, and the hardest sixty
        impacts."""
        page = self.report(self.block(30))
        self.opened(page, PHONE)
        self.assertEqual(self.js(BEYOND), [], "tables that run off a phone")
        self.opened(page)
        self.assertEqual(self.js(BEYOND), [], "tables that run off a page")
        printed = self.folder / "block.pdf"
        self.browser.pdf(printed)
        pages = len(re.findall(rb"/MediaBox \[", printed.read_bytes()))
        self.assertGreater(pages, 3)
        self.assertLessEqual(pages, 12)
        rows = self.js("[...document.querySelectorAll('#input .joined table')].map(one => one.querySelectorAll('tbody tr').length)")
        self.assertEqual(rows, [30, 30], "what is given and the first mode of each house")
        self.opened(page, A4 - 106)  # between the margins
        self.browser.call("Emulation.setEmulatedMedia", media="print")
        letters = """Math.min(...[...document.querySelectorAll('td, th, small')].map((one) =>
            one.offsetParent && one.textContent.trim() ? parseFloat(getComputedStyle(one).fontSize) : Infinity))"""
        self.assertGreaterEqual(self.js(letters) * 72 / 96, 7 - 0.01)
        self.assertLessEqual(self.js("document.documentElement.scrollWidth - document.documentElement.clientWidth"), 0)
        self.browser.call("Emulation.setEmulatedMedia", media="")

    @unittest.skipUnless(shutil.which("pdftotext"), "needs pdftotext")
    def test_pages_are_full_and_no_figure_stands_in_a_table(self):
        """No page but the last ends with more than a fifth of it empty, and both pictures of a verdict come before the
        remarks, or between them and the first table that pages part."""
        for page in self.report(self.block(30)), self.report(self.block(12)), self.example("hinged-frame"):
            self.opened(page)
            printed = page.with_suffix(".pdf")
            self.browser.pdf(printed)
            words = subprocess.run(["pdftotext", "-bbox", str(printed), "-"], check=True, capture_output=True, text=True)
            top, bottom = 842 * 18 / 297, 842 * (1 - 16 / 297)
            pages = words.stdout.split("<page ")[1:]
            empty = [1 - (max(low for low in map(float, re.findall(r'yMax="([\d.]+)"', one)) if low < bottom) - top) /
                     (bottom - top) for one in pages]
            self.assertLess(max(empty[:-1]), 0.2, f"{page.name}: {empty}")
            text = subprocess.run(["pdftotext", "-layout", str(printed), "-"], check=True, capture_output=True, text=True)
            instant = text.stdout.index("at the instant that the picture names")
            self.assertLess(instant, re.search("^Gap needed$", text.stdout, re.MULTILINE).start(), page.name)

    def test_letters_of_figures_have_seven_points_on_paper(self):
        """A page's width and a column's, one opening figure and two, frames and many houses."""
        for page in self.example("two-frames-si"), self.example("row-of-three"), self.report(self.block(12)):
            self.opened(page, A4 - 106)  # between the margins
            self.browser.call("Emulation.setEmulatedMedia", media="print")
            self.assertGreater(self.js("document.querySelectorAll('figure svg').length"), 3)
            letters = [72 / 96 * size for size in self.js(LETTERS)]
            self.assertGreaterEqual(min(letters), 7)
            self.assertLess(max(letters), 1.03 * min(letters), "of one size in all figures of a page")
            self.browser.call("Emulation.setEmulatedMedia", media="")

    def test_a_telephone_folds_details_away_and_scrolls_one_page(self):
        page = self.example("m12-el-centro")
        rows = ("[...document.querySelectorAll('#impact-list tbody tr')].filter(row => row.offsetHeight).length")
        folded = "[...document.querySelectorAll('details.fold')].map(one => one.open)"
        self.opened(page)
        in_sight = "document.getElementById('in-sight').innerText"
        self.assertEqual(self.js(rows), 15)
        said = re.match(r"15 of (\d+) impacts, the hardest Show all", self.js(in_sight))
        self.click("#impact-list th:nth-child(4) .sorter")
        self.assertIn("the first in this order", self.js(in_sight))
        self.click("#in-sight button")
        everything = self.js(rows)
        self.assertEqual(everything, int(said[1]))
        self.assertGreater(everything, 20)
        self.assertGreater(len(self.js(folded)), 8)
        self.assertTrue(all(self.js(folded)))
        self.assertTrue(self.js("document.getElementById('in-sight').hidden"))
        self.opened(page, PHONE)
        self.assertFalse(any(self.js(folded)))
        self.assertLess(self.js("document.documentElement.scrollHeight"), 20 * 844, "of a telephone's screens")
        self.assertEqual(self.js(rows), 8)
        self.click("#in-sight button")
        self.assertEqual(self.js(rows), everything)
        self.assertLessEqual(*self.js("(one => [one.scrollHeight, one.clientHeight + 1])(document.querySelector('#impacts .wide'))"))
        self.clean(page)
        self.accessible()

    def test_cards_of_a_telephone_have_titles_of_their_own(self):
        """Such as hinges, of which many are of columns, and contacts in plan, of which many are at one level."""
        for page in self.example("hinged-frame"), self.report(self.block(3)):
            self.opened(page, PHONE)
            titles = self.js("""[...document.querySelectorAll('.cards')].map((table) =>
                [...table.querySelectorAll('tbody td:first-child')].map((cell) =>
                    cell.textContent + getComputedStyle(cell, '::after').content))""")
            self.assertGreater(len(titles), 3)
            for of_table in titles:
                self.assertEqual(len(of_table), len(set(of_table)), of_table)

    def test_figures_with_many_panels_are_drawn_for_a_telephone(self):
        for page in self.example("two-frames-si"), self.report(self.block(12)):
            self.opened(page, PHONE)
            self.assertGreater(self.js("document.querySelectorAll('.figures .broad').length"), 1)
            beyond = ("[...document.querySelectorAll('figure svg')].filter(svg => !svg.parentNode.closest('svg'))"
                      ".map(svg => svg.getBoundingClientRect().right)")
            self.assertLessEqual(max(self.js(beyond)), PHONE, "a figure runs off a phone")

    def test_text_of_a_case_runs_nothing(self):
        hostile = ["<script>window.pwned = 1</script>", "</script><script>window.pwned = 2</script>",
                   "\"><img src=x onerror=window.pwned=3>", "`${window.pwned = 4}`", "\"; system('touch pwned'); \"",
                   "</title></style><svg onload=window.pwned=5>"]
        text = (SOURCE / "examples" / "m12-el-centro.toml").read_text().replace("../data", str(SOURCE / "data"))
        for name in hostile:
            with self.subTest(name):
                case = self.folder / "hostile.toml"
                quoted = json.dumps(name)
                case.write_text(text.replace('"Model 1"', quoted).replace('"Monograph M1-2, El Centro"', quoted))
                page = self.report(case)
                self.opened(page)
                self.click("#hardest")
                self.click("#impact-list .sorter")
                self.assertIsNone(self.js("window.pwned"))
                self.assertEqual(self.js("document.querySelector('h1').textContent"), name)
                self.assertEqual(self.js("document.title"), name)
                self.assertIn(self.js("document.querySelector('#stage .name').textContent"), (name, "1"))
                self.assertIn(name, self.js("document.getElementById('building-key').textContent"))
                self.clean(page)

    def test_a_script_that_came_in_would_not_run_and_nothing_can_be_fetched(self):
        page = self.example("free-impact")
        text = page.read_text()
        page.write_text(text.replace("<header>", "<script>window.pwned = 1</script>"
                                     "<img src=\"https://example.invalid/x.png\" onerror=\"window.pwned = 2\"><header>"))
        self.opened(page)
        self.assertIsNone(self.js("window.pwned"))
        self.assertTrue(any("Content Security Policy" in complaint for complaint in self.browser.complaints()))


LOGO = """<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 120 40">
  <title>Office</title>
  <defs><linearGradient id="data"><stop offset="0" style="stop-color:#1b5e9b"/><stop offset="1" stop-color="#7fd196"/></linearGradient></defs>
  <rect width="40" height="40" rx="6" style="fill:url(#data);stroke:none"/>
  <path id="stage" d="M8 32V12h10v20M22 32V6h10v26" fill="none" stroke="#fff" stroke-width="3"/>
  <text x="48" y="25" font-family="Arial" font-size="14">Wirawan</text>
</svg>
"""
PROJECT = """
[project]
name = "Extension of Hotel Harapan"
number = "24-117"
engineer = "Ir. S. Wirawan"
date = "14 March 2026"
revision = "B"
code_basis = "SNI 1726:2019"
assumptions = ["Infill is separated from the frames."]
sources = ["Sections: drawings S-101 to S-108 of 2019."]
logo = "logo.svg"
"""


class HandIn(Reports):
    def written(self, example="m12-el-centro", logo=LOGO, project=PROJECT):
        text = (SOURCE / "examples" / f"{example}.toml").read_text().replace("../data", str(SOURCE / "data"))
        (self.folder / "logo.svg").write_text(logo)
        case = self.folder / "project.toml"
        case.write_text(text + project)
        return case

    def test_it_has_what_is_handed_in(self):
        case = self.written()
        for language in "en", "id":
            with self.subTest(language):
                page = self.report(case, "--lang", language)
                for width in PHONE, A4:
                    self.opened(page, width)
                    self.assertLessEqual(self.js("document.documentElement.scrollWidth"), width)
                    self.clean(page)
                self.accessible()
                self.well_drawn()
                self.well_worded(page, language)
                self.assertEqual(self.js("document.querySelectorAll('h1').length"), 1)
                header = self.js("document.querySelector('header').textContent")
                for text in "Extension of Hotel Harapan", "24-117", "B":
                    self.assertIn(text, header)
                self.assertEqual(self.js("document.querySelector('.logo').naturalWidth / "
                                         "document.querySelector('.logo').naturalHeight"), 3)
                self.assertGreater(self.js("document.querySelector('.logo').getBoundingClientRect().width"), 40)
                # The ids of the logo are its own: the page's script finds its data.
                self.click("#hardest")
                self.assertEqual(self.js("document.getElementById('data').tagName"), "SCRIPT")
                self.browser.call("Emulation.setEmulatedMedia", media="print")
                self.assertNotEqual(self.js("getComputedStyle(document.querySelector('nav')).display"), "none")
                self.assertEqual(self.js("getComputedStyle(document.querySelector('.controls')).display"), "none")
                self.browser.call("Emulation.setEmulatedMedia", media="")
                printed = self.folder / "report.pdf"
                self.browser.pdf(printed)
                self.assertIn(b"/MediaBox [0 0 59", printed.read_bytes())

    def test_a_logo_runs_nothing_and_loads_nothing(self):
        inner = ("<script>window.pwned = 1</script>", '<image href="https://example.invalid/x.png"/>',
                 '<rect width="9" height="9" onclick="window.pwned = 2"/>',
                 "<foreignObject><img src='x' onerror='window.pwned = 3'/></foreignObject>")
        page = self.report(self.written(logo=LOGO.replace("<title>", "".join(inner) + "<title>")))
        self.opened(page)
        self.click(".logo")
        self.assertGreater(self.js("document.querySelector('.logo').naturalWidth"), 0)
        self.assertIsNone(self.js("window.pwned"))
        self.clean(page)

    def test_results_have_it_without_the_logo_that_stands_elsewhere(self):
        results = self.folder / "handed"
        subprocess.run([BENTUR, "run", "-q", str(self.written()), "-o", str(results)], check=True, timeout=300)
        page = self.report(results)
        self.opened(page)
        self.assertIn("24-117", self.js("document.querySelector('header').textContent"))
        self.assertEqual(self.js("document.querySelectorAll('.logo').length"), 0)
        self.assertIn("checks", self.js("[...document.querySelectorAll('section')].map(s => s.id)"))


UNMODELLED = """
units = { length = "m", force = "kN" }
gap = [{ between = ["A", "B"], width = 0.01, elevations = [] }]
excitation = { kind = "harmonic", period = 0.7, displacement_amplitude = 0.03 }
analysis = { duration = 2.0 }
[[building]]
name = "A"
damping = 0.05
stick = { storey_heights = [3, 3, 3, 3], masses = [100, 100, 100, 90], stiffnesses = [9e4, 8e4, 8e4, 7e4] }
[[building]]
name = "B"
damping = 0.05
stick = { storey_heights = [4, 4], masses = [80, 70], stiffnesses = [1.5e5, 1.3e5] }
"""


class Motion(Reports):
    def test_flashes_when_and_where_the_impact_list_says(self):
        for name in "m12-el-centro", "row-of-three", "restitution-asked":
            case = SOURCE / "examples" / f"{name}.toml"
            with self.impacts(case).open() as file:
                impacts = list(csv.DictReader(file))
            self.opened(self.report(case))
            data = json.loads(self.js("document.getElementById('data').textContent"))
            points = {(data["buildings"][p["left"]]["name"], p["elevation"]): i for i, p in enumerate(data["points"])}

            def at(impact):
                level = next(float(value) for key, value in impact.items() if key.startswith("elevation"))
                return points[impact["left"], level]

            for impact in impacts[::max(1, len(impacts) // 25)]:
                start, end = float(impact["start [s]"]), float(impact["end [s]"])
                with self.subTest(name, start=start):
                    for moment in (start + end) / 2, start + 1e-9, end - 1e-9, start - 1e-6, end + 1e-6:
                        if not 0 <= moment <= data["duration"]:
                            continue
                        expected = sorted({at(other) for other in impacts
                                           if float(other["start [s]"]) <= moment <= float(other["end [s]"])})
                        if end - start < 1e-8 and moment != (start + end) / 2:
                            continue  # an impact without duration has no inside
                        self.scrub(moment)
                        self.assertEqual(self.contacts(), expected, moment)
                        self.assertAlmostEqual(self.shown_time(), moment, delta=1e-12)

    def test_openings_shown_are_those_of_the_histories(self):
        """At an impact's start the opening is zero, at its peak force minus the penetration."""
        case = SOURCE / "examples" / "m12-el-centro.toml"
        with self.impacts(case).open() as file:
            impacts = list(csv.DictReader(file))
        self.opened(self.report(case))
        for impact in impacts[:10]:
            row = round(3 - float(impact["elevation [cm]"]) / 100)
            cell = f"document.getElementById('live').rows[{row}].cells[1].textContent"
            shown = f"Number({cell}.replace('\\u2212', '-'))"
            depth = float(impact["peak_penetration [cm]"])
            self.scrub(float(impact["start [s]"]))
            # Samples of 16 bits every 0.5 ms, between which the picture interpolates: a few percent of a penetration.
            self.assertAlmostEqual(self.js(shown), 0, delta=0.05 * max(depth, 0.005))
            self.scrub(float(impact["peak_force_time [s]"]))
            self.assertAlmostEqual(self.js(shown), -depth, delta=0.05 * max(depth, 0.005))

    def test_starts_at_the_hardest_impact(self):
        case = SOURCE / "examples" / "m12-el-centro.toml"
        with self.impacts(case).open() as file:
            hardest = max(csv.DictReader(file), key=lambda impact: float(impact["peak_force [kgf]"]))
        self.opened(self.report(case))
        self.assertAlmostEqual(self.shown_time(), float(hardest["peak_force_time [s]"]), delta=1e-12)
        self.assertEqual(len(self.contacts()), 1)

    def test_on_a_telephone_the_caption_names_the_level_too(self):
        self.opened(self.example("row-of-three"))
        event = self.js("document.getElementById('event').textContent").split("; ")[0]
        self.assertRegex(event, "level [0-9.]+ m$")
        self.browser.resize(PHONE, 844)
        told = "[...document.querySelectorAll('#stage .caption.fill-red')].map(line => line.textContent).join(' ')"
        inside = ("(edge => [...document.querySelectorAll('#stage .caption')].every(line => line.getBoundingClientRect().right <="
                  " edge))(document.getElementById('stage').getBoundingClientRect().right)")
        self.until(lambda: event in self.js(told) and self.js(inside))

    def test_plays_in_real_time_pauses_and_goes_on(self):
        self.opened(self.example("m12-el-centro"))
        moved = self.js("document.querySelector('#stage .column').getAttribute('d')")
        begun, begin = 0, time.monotonic()  # it begins at the start
        self.click("#play")
        # Frames without a window come as the machine can; time never runs ahead of the clock by more than the frame that is
        # being drawn, whose time is that of its showing.
        self.until(lambda: self.shown_time() > begun + 0.2)
        shown, passed = self.shown_time(), time.monotonic() - begin
        self.assertLess(shown - begun, passed + 1 / 60)
        self.click("#play")
        stopped = self.shown_time()
        time.sleep(0.3)
        self.assertEqual(self.shown_time(), stopped)
        self.assertNotEqual(self.js("document.querySelector('#stage .column').getAttribute('d')"), moved)
        self.click("#play")
        self.until(lambda: self.shown_time() > stopped)

    def test_floors_inside_what_they_face_are_hatched_and_listed(self):
        """The roof of B and the floor below it face columns of A, where no contact is modelled."""
        case = self.folder / "unmodelled.toml"
        case.write_text(UNMODELLED)
        self.opened(self.report(case))
        data = json.loads(self.js("document.getElementById('data').textContent"))
        hatched = "[...document.querySelectorAll('#stage .inside')].map(line => line.getAttribute('d') !== '')"
        self.assertEqual(self.shown_time(), data["shown"])
        self.assertTrue(self.js(hatched)[-1])  # the deepest, at its deepest
        self.assertIn("roof of B", self.js("document.getElementById('event').textContent"))
        rows = self.js("[...document.getElementById('live').rows].map(row => [row.cells[0].textContent,"
                       " row.cells[1].textContent, row.cells[1].className])")
        listed = [(float(value.replace("\N{MINUS SIGN}", "-")), tone) for name, value, tone in rows if name.endswith("not modelled")]
        self.assertEqual(len(listed), len(data["watched"]))
        for value, tone in listed:
            self.assertEqual(tone == "marked", value < 0)
        self.scrub(0)
        self.assertFalse(any(self.js(hatched)))
        self.assertEqual(self.js("document.getElementById('event').textContent"), "")

    def test_every_impact_that_is_played_over_flashes(self):
        """However few frames there are, no impact of 2 ms falls between two of them."""
        case = SOURCE / "examples" / "m12-el-centro.toml"
        with self.impacts(case).open() as file:
            impacts = list(csv.DictReader(file))
        self.opened(self.report(case))
        self.js("""(() => { window.flashes = 0; new MutationObserver(list => { for (const m of list)
            if (m.oldValue === '0' && m.target.dataset.contact === '1') ++window.flashes; })
            .observe(document.getElementById('stage'),
                     {subtree: true, attributeFilter: ['data-contact'], attributeOldValue: true}); })()""")
        self.scrub(1.2)
        self.js("document.getElementById('speed').value = '0.5'")
        self.click("#play")
        while self.shown_time() < 2.0:
            time.sleep(0.1)
        self.click("#play")
        end = self.shown_time()
        within = [impact for impact in impacts if 1.2 <= float(impact["start [s]"]) <= end]
        self.assertGreater(len(within), 1)
        self.assertEqual(self.js("window.flashes"), len(within))

    def test_slow_motion_around_an_impact(self):
        self.opened(self.example("m12-el-centro"))
        first = self.js("JSON.parse(document.getElementById('data').textContent).impacts[0]")
        self.scrub(first[1] - 0.05)
        self.click("#slow")
        # Each time that is shown, and when by the page's clock.
        self.js("""(() => { window.frames_ = []; new MutationObserver(() => window.frames_.push(
            [Number(document.getElementById('stage').dataset.time), performance.now() / 1000]))
            .observe(document.getElementById('stage'), {attributeFilter: ['data-time']}); })()""")
        self.click("#play")
        self.until(lambda: self.shown_time() > first[2])
        self.click("#play")
        within = [frame for frame in self.js("window.frames_") if first[1] <= frame[0] <= first[2]]
        self.assertGreater(len(within), 1)  # 2.4 ms at a hundredth of the speed; a frame is 0.1 s of the clock at most
        # Frames are told of a little after the time that they are for.
        self.assertGreater(within[-1][1] - within[0][1] + 0.05, 100 * (within[-1][0] - within[0][0]))

    def test_hardest_impact_slowly(self):
        self.opened(self.example("m12-el-centro"))
        hardest = max(self.js("JSON.parse(document.getElementById('data').textContent).impacts"), key=lambda i: i[3])
        self.click("#hardest")
        self.assertLess(self.shown_time(), hardest[1])
        self.until(lambda: self.js("document.getElementById('play').getAttribute('aria-pressed')") == "false")
        self.assertGreater(self.shown_time(), hardest[2])
        self.assertLess(self.shown_time(), hardest[2] + 2 * (hardest[2] - hardest[1]))

    def test_steps_from_impact_to_impact(self):
        self.opened(self.example("m12-el-centro"))
        starts = [i[1] for i in self.js("JSON.parse(document.getElementById('data').textContent).impacts")]
        self.scrub(0)
        for start in starts[:3]:
            self.click("#next")
            self.assertAlmostEqual(self.shown_time(), start, delta=1e-12)
        self.click("#previous")
        self.assertAlmostEqual(self.shown_time(), starts[1], delta=1e-12)

    def test_touching_floors_touch_in_the_picture_at_every_magnification(self):
        self.opened(self.example("m12-el-centro"))
        first = self.js("JSON.parse(document.getElementById('data').textContent).impacts[0]")
        self.scrub(first[1])
        faces = """(() => { const at = b => document.querySelectorAll('#stage .slab')[b].getAttribute('d').match(/M[^M]*/g)[2];
            return [Number(at(0).match(/L([-.0-9]+)/)[1]), Number(at(1).match(/M([-.0-9]+)/)[1])]; })()"""
        for zoom in -1, 0, 1:
            self.js(f"(() => {{ const m = document.getElementById('magnify'); m.value = {zoom};"
                    "m.dispatchEvent(new Event('input')); })()")
            left, right = self.js(faces)
            self.assertAlmostEqual(left, right, delta=0.02 + 0.25 * 10 ** zoom)  # 1e-4 cm, 50 times as large


class Stills(Reports):
    """The figure "scene" beside what the page draws of the same description."""

    def still(self, case):
        """Its lines, those at rest first, as lists of points."""
        folder = self.folder / "results"
        subprocess.run([BENTUR, "run", "-q", str(case), "-o", str(folder), "--figures", "svg"], check=True, timeout=300)
        drawn = []
        for table in blocks(folder / "figures/scene.py"):
            lines = [[]]
            for point in table:
                if math.isnan(point[0]):
                    lines.append([])
                else:
                    lines[-1].append(point)
            drawn.append(lines)
        return drawn

    def drawn(self, data, motion):
        return self.js(f"(() => {{ const scene = {json.dumps(data['scene'])}, place = benturPlaces(scene, scene.magnification,"
                       f"{json.dumps(motion)}); return scene.shapes.map(({{ lines }}) => lines.map((line) =>"
                       "line.map((point) => [place(point), point[0]]))); })()")

    def assert_alike(self, one, other, delta):
        self.assertEqual([list(map(len, lines)) for lines in one], [list(map(len, lines)) for lines in other])
        for a, b in zip((p for lines in one for line in lines for p in line), (p for lines in other for line in lines for p in line)):
            self.assertAlmostEqual(a[0], b[0], delta=delta)
            self.assertAlmostEqual(a[1], b[1], delta=delta)

    def test_hinges_show_from_when_they_form_and_warn_as_they_turn(self):
        self.opened(self.example("hinged-frame"))
        data = json.loads(self.js("document.getElementById('data').textContent"))
        dots = data["hinges"]["dots"]
        tones = [level["tone"] for level in data["hinges"]["levels"]]
        self.assertGreater(len(dots), 5)
        self.assertEqual(tones, ["ink", "teal", "amber", "red"][:len(tones)])
        reached = [[time for time in dot["reached"] if time is not None] for dot in dots]
        some = sorted(time for times in reached for time in times)
        for at in 0, some[0], some[len(some) // 2], data["duration"]:
            self.scrub(at)
            now = self.shown_time()
            wanted = [sum(time <= now for time in times) for times in reached]
            shown = self.js("[...document.querySelectorAll('#stage .hinge')].map(dot => dot.getAttribute('opacity') === '0'"
                            " ? 0 : Number(dot.dataset.level))")
            self.assertEqual(shown, wanted, at)
            colours = self.js("[...document.querySelectorAll('#stage .hinge')].map(dot => getComputedStyle(dot)[dot.dataset.level"
                              " > 1 ? 'fill' : 'stroke'])")
            for level in range(1, 5):
                self.assertLessEqual(len({colour for colour, of in zip(colours, shown) if of == level}), 1)
        key = self.js("[...document.querySelectorAll('#stage .caption')].map(line => line.textContent).filter(text => /[○●■◆]/.test(text))")
        self.assertEqual([line[2:] for line in key], [level["text"] for level in data["hinges"]["levels"]])
        self.opened(self.example("two-frames-si"))
        self.assertEqual(self.js("document.querySelectorAll('#stage .hinge').length"), 0)

    def test_a_still_is_what_the_page_shows_at_that_time(self):
        for case in part((SOURCE / "examples").glob("*.toml"), 10):
            with self.subTest(case.stem):
                still = self.still(case)
                self.opened(self.report(case))
                data = json.loads(self.js("document.getElementById('data').textContent"))
                self.assertAlmostEqual(self.shown_time(), data["shown"], delta=1e-12)
                scene, wide = data["scene"], sum(data["scene"]["breadths"])
                rest = [[0] * building["rows"] for building in data["buildings"]]
                of_buildings = [k for k, shape in enumerate(scene["shapes"]) if shape["role"] in ("wall", "column", "slab")]
                self.assert_alike([self.drawn(data, rest)[k] for k in of_buildings], still[:len(of_buildings)], 1e-9 * wide)
                # Displacements at that time are kept as whole parts of 32767 of the largest.
                key = min(range(len(data["keys"])), key=lambda k: abs(data["keys"][k] - data["shown"]))
                motion = []
                for building in data["buildings"]:
                    kept = base64.b64decode(building["keys"])
                    values = struct.unpack(f"<{len(kept) // 2}h", kept)
                    motion.append([building["scale"] * v for v in values[key * building["rows"]:(key + 1) * building["rows"]]])
                coarse = 0.5 * scene["magnification"] * max(building["scale"] for building in data["buildings"])
                now = self.drawn(data, motion)
                self.assert_alike(now, still[len(of_buildings):][:len(now)], 1.001 * coarse + 1e-9 * wide)


class List(Reports):
    def column(self, number):
        return self.js("Array.from(document.getElementById('impact-list').tBodies[0].rows)"
                       f".map(row => row.cells[{number}].textContent)")

    def test_sorts_by_every_column_both_ways(self):
        for page in "row-of-three", "plan/twisting-pair":
            self.opened(self.example(page))
            self.sorts()

    def sorts(self):
        count = self.js("document.getElementById('impact-list').tHead.lastElementChild.cells.length")
        for number in range(count):
            for sign in 1, -1:
                self.js(f"document.querySelectorAll('#impact-list .sorter')[{number}].click()")
                order = self.js(f"document.querySelectorAll('#impact-list tr:last-child th')[{number}].getAttribute('aria-sort')")
                values = [value.replace("−", "-") for value in self.column(number) if value != "–"]
                try:
                    values = list(map(float, values))
                except ValueError:
                    pass
                self.assertEqual(values, sorted(values, reverse=order == "descending"), number)
                self.assertEqual(self.js("document.querySelectorAll('#impact-list [aria-sort]').length"), 1)

    def test_hardest_first(self):
        self.opened(self.example("m12-el-centro"))
        heads = self.js("Array.from(document.querySelectorAll('#impact-list tr:last-child th')).map(h => h.textContent)")
        forces = list(map(float, self.column(next(i for i, h in enumerate(heads) if h.startswith("Peak force")))))
        self.assertEqual(forces, sorted(forces, reverse=True))
        self.browser.call("Emulation.setEmulatedMedia", media="print")
        title = "document.querySelector('#impact-list tr').offsetHeight"
        self.assertGreater(self.js(title), 0, "paper says the order")
        self.js("document.querySelectorAll('#impact-list .sorter')[0].click()")
        self.assertEqual(self.js(title), 0, "that of no other one")
        self.browser.call("Emulation.setEmulatedMedia", media="")
        self.assertEqual(len(forces), 37)

    def test_download_is_the_file_of_bentur_run(self):
        for case in SOURCE / "examples" / "m12-el-centro.toml", PLAN:
            expected = self.impacts(case).read_bytes()
            self.opened(self.report(case))
            saved = self.folder / "impacts.csv"
            saved.unlink(missing_ok=True)
            self.click("#download")
            self.browser.wait_for("Browser.downloadWillBegin")
            self.until(lambda: saved.exists() and saved.stat().st_size == len(expected))
            self.assertEqual(saved.read_bytes(), expected)
            self.assertEqual(self.browser.complaints(), [])

    def test_a_number_shows_its_impact(self):
        self.opened(self.example("m12-el-centro"))
        self.js("Array.from(document.querySelectorAll('#impact-list td button')).find(b => b.textContent === '3').click()")
        third = self.js("JSON.parse(document.getElementById('data').textContent).impacts[2]")
        self.assertLess(abs(self.shown_time() - third[1]), 2 * (third[2] - third[1]))


def keep(folder):
    """Pictures to look at."""
    folder.mkdir(parents=True, exist_ok=True)
    page = browser.Browser(browser.find(), folder)
    for case in sorted((SOURCE / "examples").glob("*.toml")):
        for language in "en", "id":
            report = folder / f"{case.stem}-{language}.html"
            subprocess.run([BENTUR, "report", str(case), "-o", str(report), "--lang", language], check=True)
            for width in PHONE, A4:
                page.resize(width, 900)
                page.open(report)
                page.screenshot(folder / f"{report.stem}-{width}.png")
            page.pdf(folder / f"{report.stem}.pdf")
    page.close()


if __name__ == "__main__":
    if browser.find() is None:
        print("skipped: chromium is not installed")
        sys.exit(77)
    if sys.argv[1:2] == ["--keep"]:
        keep(pathlib.Path(sys.argv[2]))
    else:
        unittest.main()
