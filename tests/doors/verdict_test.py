"""What is said of a run is the same at every door: terminal, report, Python; web/test has the studio.

Every eighth example (tests/part.py), in English and Indonesian. The statements of summary.json, numbers and names without
words, are held against
the sentences kind by kind and value by value, by the texts that translators have; the sentences of one door against those of
another letter by letter, with ordinary spaces and wrapped lines joined. Environment as tests/python.
"""

import html.parser
import json
import os
import re
import pathlib
import subprocess
import sys
import tomllib

import doors
import pytest

import bentur

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
from part import part  # noqa: E402

PROGRAM = os.environ.get("BENTUR_PROGRAM", "")
TEXTS = tomllib.loads((doors.ROOT / "src/bentur/report/html/texts.toml").read_text(encoding="utf-8"))
LANGUAGES = TEXTS["languages"]
GRAVE = ["danger", "warning", "finding", "remark"]
CASES = part([*doors.EXAMPLES, *doors.CASES, *doors.PLANS], 12)

pytestmark = pytest.mark.skipif(not PROGRAM, reason="BENTUR_PROGRAM does not name the command line to compare with")


@pytest.fixture(scope="module", params=CASES, ids=lambda case: case.stem)
def case(request):
    return request.param


@pytest.fixture(scope="module")
def summary(case):
    return doors.command_line(PROGRAM, case)


def output(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True, encoding="utf-8").stdout


def spaced(text):
    return text.replace("\u00a0", " ")


def text_of(key, language):
    """The text of a key of the catalogue, None where it has none."""
    table = TEXTS
    for part in key.split("."):
        table = table.get(part, {}) if isinstance(table, dict) else {}
    return table.get(language) if isinstance(table, dict) else None


# Statements against sentences.


def counted(name, n, language):
    form = text_of(f"story.count.{name}.{'one' if n == 1 else 'many'}", language)
    return str(n) if form is None else form.replace("{n}", str(n))


NUMBER = "(-?[0-9.]+(?:e[-+]?[0-9]+| × 10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?|–)"
SUPERSCRIPT = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def as_number(text):
    return float(text.replace(" × 10", "e").translate(SUPERSCRIPT))


def pattern(key, statement, language, numbers):
    """A regular expression of the text of a key filled with values, whose groups are the given numbers, in order."""
    template = text_of(key, language)
    assert template is not None, f"{key} has no text in {language}"
    if key.endswith(".row"):
        template = in_words(template.split("|"))
    found = ""
    for literal, name, one, many in re.findall(r"([^{]*)(?:\{(\w+)(?::([^|}]*)\|([^}]*))?\})?", template):
        found += re.escape(spaced(literal))
        value = statement["values"].get(name)
        if one or many:
            n = value["value"] if isinstance(value, dict) else value
            found += re.escape(spaced(one if n == 1 else many))
        elif name == "items":
            all_items = [pattern(f"{key}.item", {"values": one}, language, numbers) for one in statement["items"]]
            last = f" {text_of('word.and', language)} "
            found += re.escape(last).join([", ".join(all_items[:-1]), all_items[-1]] if len(all_items) > 1 else all_items)
        elif isinstance(value, dict):
            numbers.append((name, value))
            found += NUMBER + (re.escape(" " + value["unit"]) if value["unit"] else "")
        elif isinstance(value, int):
            found += re.escape(counted(name, value, language))
        elif isinstance(value, str):
            found += pattern(value, statement, language, numbers) if text_of(value, language) else re.escape(spaced(value))
    return found


def agrees(statement, sentence, language, of=""):
    """Fails where a sentence does not say what a statement has: its kind by its words, its values by their digits.
    @param of the kind's text, as `.row`."""
    kind, numbers = statement["kind"], []
    expected = pattern((kind if kind.startswith("remark.") else f"story.{kind}") + of, statement, language, numbers)
    if "subject" in statement:
        more = statement["values"].get("more")
        after = text_of("remark.more", language).replace("{n}", str(more)) if more else ""
        expected = re.escape(statement["subject"] + after + ": ") + expected
    found = re.fullmatch(expected, sentence)
    assert found, f"{kind}: {sentence!r} is not {expected!r}"
    for (name, value), text in zip(numbers, found.groups(), strict=True):
        if value["value"] is None:
            assert text == "–", f"{kind}, {name}"
            continue
        digits = 4 if value["unit"] else 3  # a ratio has three
        assert as_number(text) == pytest.approx(value["value"], rel=0.51 * 10 ** (1 - digits), abs=1e-12), f"{kind}, {name}: {sentence}"
    return len(numbers)


def badge_of(statement, language):
    if statement["kind"].startswith("remark."):  # a doubt has one
        return text_of("remark.doubted", language) if statement["severity"] != "remark" else None
    return text_of(f"story.{statement['kind']}.badge", language)


# Doors: each gives (gap or None, badge or None, sentence) of every statement that is no remark, and the remarks' sentences.


def line_parts(line, summary, language):
    """A line of a terminal apart: "Gap: BADGE: text"."""
    names = [gap_name(gap) for gap in summary["gaps"]] if len(summary["gaps"]) > 1 else []
    gap = next((name for name in names if line.startswith(name + ": ")), None)
    line = line[len(gap) + 2 :] if gap else line
    badges = {badge_of(one, language).upper() for one in summary["statements"] if badge_of(one, language)}
    badge = next((one for one in sorted(badges, key=len, reverse=True) if line.startswith(one + ": ")), None)
    return gap, badge, line[len(badge) + 2 :] if badge else line


def gap_name(gap):
    return " | ".join(gap["between"])


def terminal(case, summary, language):
    said = output("run", case, "--lang", language)
    assert "\u00a0" not in said
    paragraphs = [part.replace("\n  ", " ").splitlines() for part in said.split("\n\n")]
    after = paragraphs.index([text_of("cli.storeys", language)]) + 1
    before = text_of("cli.remark", language).replace("{text}", "")
    remarks = [line.removeprefix(before) for line in paragraphs[after]]
    return [line_parts(line, summary, language) for line in paragraphs[1]], remarks


def in_words(cells):
    """A row as a sentence, "what: how much, where, more", without empty cells."""
    what, *others = [cell.strip() for cell in cells if cell.strip()]
    return f"{what}: {', '.join(others)}"


def known(case, language):
    """The rows of what else is known at a terminal, as sentences; where the table would be too wide they are sentences there too."""
    blocks = output("run", case, "--lang", language).split("\n\n")
    heading = text_of("story.table.known", language)
    if heading not in blocks:
        return []
    lines = blocks[blocks.index(heading) + 1].splitlines()
    if "──" not in lines[1]:
        return "\n".join(lines).replace("\n  ", " ").splitlines()
    rows = []
    for line in lines[2:]:
        if line.startswith("   "):  # goes on
            rows[-1][-1] += " " + line.strip()
        else:
            rows.append(re.split(" {2,}", line.strip()))
    return [in_words(row) for row in rows]


def rows_of(summary):
    """Statements that are rows, one for each of their items."""
    for one in summary["statements"]:
        if one["shown"] == "row":
            for item in one.get("items", [{}]):
                yield {**one, "values": {**one["values"], **item}}


def holds_rows(case, summary, language):
    """Fails where a row does not say what its statement has. @return how many numbers were compared"""
    lines, compared = known(case, language), 0
    names = [gap_name(gap) for gap in summary["gaps"]]
    for statement, line in zip(rows_of(summary), lines, strict=True):
        for name in names if len(names) > 1 else []:
            line = line.replace(f", {name},", ",")
        compared += agrees(statement, line, language, ".row")
    return compared


def python(case, result, summary, language):
    """The sentences; the lines after them are the rows of what else is known."""
    lines = result.verdict(language)
    assert not any("\u00a0" in line for line in lines)
    rows = known(case, language)
    sentences, others = lines[: len(lines) - len(rows)], lines[len(lines) - len(rows) :]
    assert others == rows
    return [line_parts(line, summary, language) for line in sentences]


class Page(html.parser.HTMLParser):
    """Paragraphs of the verdict and the remarks of a report: (gap, class, text)."""

    def __init__(self, text):
        super().__init__()
        self.section, self.gap, self.open, self.found = None, None, None, {"verdict": [], "remarks": []}
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "section":
            self.section = attributes.get("id")
        elif self.section in self.found and tag in ("p", "li", "summary"):
            self.open = [tag, attributes.get("class", ""), ""]

    def handle_data(self, text):
        if self.open:
            self.open[2] += text

    def handle_endtag(self, tag):
        if tag in ("section", "details"):
            self.gap = None
            self.section = None if tag == "section" else self.section
        elif self.open and tag == self.open[0]:
            text = spaced(self.open[2])
            if tag == "summary":
                self.gap = text
            elif self.open[1] != "note":
                self.found[self.section].append((self.gap, self.open[1], text))
            self.open = None


def report(text, summary, language):
    """A badge stands once above what it is of."""
    page, told, badges, row = Page(text), [], {}, len(summary["gaps"]) > 1
    for gap, style, line in page.found["verdict"]:
        if style == "badge":
            badges[gap] = line.upper()
            continue
        inner, none, sentence = line_parts(line, summary, language) if row and gap is None else (gap, None, line)
        assert none is None
        told.append((inner, badges.get(gap) if style == "lead" else None, sentence))
    return told, [line for _, _, line in page.found["remarks"]]


# What is to be told.


def outcome(summary):
    return [one for one in summary["statements"] if one["severity"] != "remark" and one["shown"] == "sentence"]


def remarks(summary):
    return [one for one in summary["statements"] if one["severity"] == "remark"]


def test_statements_are_ordered_and_whole(summary):
    grades = [GRAVE.index(one["severity"]) for one in summary["statements"]]
    dangers = grades.count(0)
    assert grades[:dangers] == [0] * dangers
    assert outcome(summary) and remarks(summary)
    for one in summary["statements"]:
        for language in LANGUAGES:
            assert text_of(one["kind"] if one["kind"].startswith("remark.") else "story." + one["kind"], language)


@pytest.mark.parametrize("language", LANGUAGES)
def test_terminal_says_the_statements(case, summary, language):
    told, noted = terminal(case, summary, language)
    compared = 0
    for statement, (gap, badge, sentence) in zip(outcome(summary), told, strict=True):
        compared += agrees(statement, sentence, language)
        assert (badge or "") == (badge_of(statement, language) or "").upper()
        if "left" in statement["values"] and len(summary["gaps"]) > 1:
            left, right = statement["values"]["left"], statement["values"]["right"]
            # What names both has no name of their gap before it.
            assert gap is None if left in sentence and right in sentence else gap == f"{left} | {right}"
    for statement, sentence in zip(remarks(summary), noted, strict=True):
        compared += agrees(statement, sentence, language)
    compared += holds_rows(case, summary, language)
    assert compared > 5


@pytest.mark.parametrize("language", LANGUAGES)
def test_python_says_what_the_terminal_says(case, summary, language):
    result = bentur.run(case)
    assert list(doors.differences(summary["statements"], result.summary["statements"])) == []
    assert python(case, result, summary, language) == terminal(case, summary, language)[0]


def says(statement, sentence, language):
    try:
        agrees(statement, sentence, language)
    except AssertionError:
        return False
    return True


def holds_page(told, case, summary, language):
    """A report has the terminal's sentences. In a row each gap has what is of it folded away below what is of the whole
    row and below all dangers, with what the terminal leaves to tables."""
    sentences, _ = terminal(case, summary, language)
    first = [one for one in told if one[0] is None or one in sentences]
    assert sorted((one for one in told if one in sentences), key=str) == sorted(sentences, key=str) if len(summary["gaps"]) > 1 else told == sentences
    others = [one for one in told if one not in first]
    left = [one for one in summary["statements"] if one["shown"] == "table" and one["severity"] != "remark"]
    for statement in left if len(summary["gaps"]) > 1 else []:
        assert sum(says(statement, sentence, language) for _, _, sentence in others) >= 1, statement
    return True


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("source", ["case", "results"])
def test_report_says_what_the_terminal_says(source, case, summary, language, tmp_path):
    if source == "results":
        subprocess.run([PROGRAM, "run", case, "-q", "-o", tmp_path / "results"], check=True)
    page = output("report", tmp_path / "results" if source == "results" else case, "-o", "-", "--lang", language)
    told, noted = report(page, summary, language)
    _, expected_notes = terminal(case, summary, language)
    assert holds_page(told, case, summary, language)
    assert noted == expected_notes


@pytest.mark.parametrize("language", LANGUAGES)
def test_python_makes_the_page_that_says_so(case, summary, language):
    told, noted = report(bentur.run(case).report(language), summary, language)
    _, expected_notes = terminal(case, summary, language)
    assert holds_page(told, case, summary, language)
    assert noted == expected_notes


def suite_of_one(case, folder):
    """The case with its record as the only one of a suite, unscaled; None where it has no record of its own that has times."""
    given = tomllib.loads(case.read_text(encoding="utf-8"))
    excitation = given["excitation"]
    if excitation.get("kind") != "record" or "time_step" in excitation or any("plan" in one for one in given["building"]):
        return None
    taken = {key: excitation[key] for key in ("format", "unit", "column", "channel", "component") if key in excitation}
    entry = ", ".join(f"{key} = {value!r}" for key, value in
                      {"file": str((case.parent / excitation["file"]).resolve()), **taken}.items())
    kept = [line for line in re.search(r"^\[excitation\]\n(.*?)(?=^\[|\Z)", case.read_text(encoding="utf-8"), re.M | re.S)[1].splitlines()
            if line.split("=")[0].strip() in ("delays", "distances", "wave_speed")]
    section = "\n".join(["[excitation]", 'kind = "suite"', f"files = [{{ {entry} }}]", "scale = { factors = [1.0] }",
                         'target = { shape = "en-1998-1", ground_acceleration = "0.3 g", ground_type = "B", spectrum_type = 1 }', *kept])
    text = re.sub(r"^\[excitation\]\n.*?(?=^\[|\Z)", lambda _: section + "\n\n", case.read_text(encoding="utf-8"), flags=re.M | re.S)
    made = folder / "suite.toml"
    made.write_text(text, encoding="utf-8")
    return made


def test_a_suite_of_one_says_what_its_record_says(case, tmp_path):
    suite = suite_of_one(case, tmp_path)
    if suite is None:
        pytest.skip("no record of a row")
    of_suite, of_record = (json.loads(output("run", suite, "--json", *more))["statements"] for more in ([], ["--record", "1"]))
    said = [one for one in of_suite if one["kind"] not in ("suite", "suite_alike", "suite_mean", "suite_target_not_known")]  # how it was chosen and scaled
    assert list(doors.differences(of_record, [{k: v for k, v in one.items() if k != "many"} for one in said])) == []


# A row of three, the plan that stands for it, and a suite of its one record.

BUILDINGS = {  # masses [t], stiffnesses along x [kN/m], from the lowest storey up
    "West": ([200.0, 180.0], [2.0e5, 1.6e5]),
    "Middle": ([300.0, 250.0], [0.7e5, 0.6e5]),
    "East": ([220.0, 200.0], [1.5e5, 1.4e5]),
}
GAPS = {("West", "Middle"): 0.02, ("Middle", "East"): 0.03}
CONTACT = '{ law = "linear", stiffness = 4e5 }'
UNITS = 'title = "Row of three"\n[units]\nlength = "m"\nforce = "kN"\n'
MOTION = (f'[excitation]\nkind = "record"\nfile = "{(doors.ROOT / "data/el-centro-1940-ns.csv").as_posix()}"\nunit = "g"\n'
          "[analysis]\nduration = 10.0\n")


def as_row():
    text = UNITS
    for name, (masses, stiffnesses) in BUILDINGS.items():
        text += f'[[building]]\nname = "{name}"\ndamping = 0.05\n[building.stick]\nstorey_heights = [3.5, 3.2]\n'
        text += f"masses = {masses}\nstiffnesses = {stiffnesses}\n"
    for (left, right), width in GAPS.items():
        text += f'[[gap]]\nbetween = ["{left}", "{right}"]\nwidth = {width}\ncontact = {CONTACT}\n'
    return text + MOTION


def as_plan():
    text, x = UNITS + f"[plan]\nclearance = 0.1\ncontact = {CONTACT}\n", 0.0
    for (name, (masses, stiffnesses)), width in zip(BUILDINGS.items(), [*GAPS.values(), 0.0], strict=True):
        text += f'[[building]]\nname = "{name}"\ndamping = 0.05\n[building.plan]\ncorner = [{x!r}, 0.0]\nsize = [8.0, 10.0]\n'
        text += f"storey_heights = [3.5, 3.2]\nmasses = {masses}\n"
        for axis, places in (("x", (1.0, 9.0)), ("y", (1.0, 7.0))):
            for at in places:
                text += f'[[building.plane]]\nname = "{axis} at {at}"\nalong = "{axis}"\nat = {at}\n'
                text += f"stiffnesses = {[one / 2 for one in stiffnesses]}\n"
        x += 8.0 + width
    return text + MOTION


@pytest.fixture(scope="module")
def triplets(tmp_path_factory):
    """The same buildings and motion three times: a row, a plan, a row under a suite of one."""
    folder = tmp_path_factory.mktemp("triplets")
    made = {"row": folder / "row.toml", "plan": folder / "plan.toml"}
    made["row"].write_text(as_row(), encoding="utf-8")
    made["plan"].write_text(as_plan(), encoding="utf-8")
    made["suite"] = suite_of_one(made["row"], folder)
    return made


def what_is_said(statements):
    """Kinds with gaps, and by name the numbers that do not hang on how many places a joint has. Not of rules, as DDC has no
    period of floors that could turn, nor of the suite itself."""
    said = []
    for one in statements:
        if one["severity"] == "remark" or one["kind"].startswith(("rules", "suite")):
            continue
        kind = {"pga_along": "pga"}.get(one["kind"], one["kind"])
        numbers = {name: one["values"][name]["value"] for name in ("needed", "given", "short", "factor", "with", "without", "acceleration", "pga")
                   if isinstance(one["values"].get(name), dict)}
        said.append((kind, one.get("gap"), one.get("buildings"), numbers))
    return said


def test_a_row_a_plan_and_a_suite_of_one_say_the_same(triplets):
    row, plan, suite = (json.loads(output("run", triplets[kind], "--json"))["statements"] for kind in ("row", "plan", "suite"))
    expected = what_is_said(row)
    assert {kind for kind, *_ in expected} >= {"pounding", "gap_short_alone", "amplified", "acceleration_ratio", "storey_shear_ratio"}
    for other in (what_is_said(plan), what_is_said(suite)):
        assert [one[:3] for one in other] == [one[:3] for one in expected]
        for (kind, _, _, numbers), (_, _, _, given) in zip(other, expected, strict=True):
            assert numbers == pytest.approx(given, rel=1e-9), kind


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("kind", ["row", "plan"])
def test_every_door_says_so_of_rows_and_plans(kind, language, triplets):
    case, told = triplets[kind], doors.command_line(PROGRAM, triplets[kind])
    sentences, noted = terminal(case, told, language)
    for statement, (gap, badge, sentence) in zip(outcome(told), sentences, strict=True):
        agrees(statement, sentence, language)
        assert (badge or "") == (badge_of(statement, language) or "").upper()
    assert python(case, bentur.run(case), told, language) == sentences
    on_page, notes = report(output("report", case, "-o", "-", "--lang", language), told, language)
    assert holds_page(on_page, case, told, language) and notes == noted
    holds_rows(case, told, language)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_column_that_fails_is_told_first(language):
    case = doors.ROOT / "examples" / "struck-column.toml"
    summary = doors.command_line(PROGRAM, case)
    first = summary["statements"][0]
    assert first["kind"] == "column_shear" and first["severity"] == "danger"
    assert (first["values"]["building"], first["values"]["level"]["value"]) == ("Office", 19.4)
    told = [
        terminal(case, summary, language)[0],
        report(output("report", case, "-o", "-", "--lang", language), summary, language)[0],
        python(case, bentur.run(case), summary, language),
    ]
    column = {"en": "column of Office at level 19.4 m", "id": "kolom Office di elevasi 19.4 m"}[language]
    for door in told:
        _, badge, sentence = door[0]
        assert badge == text_of("story.column_shear.badge", language).upper()
        assert column in sentence and "2.416" in sentence
