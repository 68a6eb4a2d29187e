"""check_sources.py RULE ROOT: one rule of the house over the sources under ROOT; every breach is printed, status 1."""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tools"))
import wrap  # noqa: E402

# What the sources of a module may include besides their own module: docs/architecture.md.
ALLOWED = {"core": set(), "elements": {"core"}}
for name in ("structure", "excitation", "contact"):
    ALLOWED[name] = {"core", "elements"}
for name in ("solve", "pounding", "model", "io", "study", "files"):
    ALLOWED[name] = set(ALLOWED)
for name in ("runner", "report"):
    ALLOWED[name] = set(ALLOWED) - {"runner"}
# What its tests may include besides, because that is how what it takes is made.
TESTS_USE = {"solve": {"pounding"}}
# Headers that only some modules know: a case is solved where there are no files; it is read, written as text and studied
# where there is no NetCDF, and anything but a sweep runs without threads and MPI.
OUTSIDE = {
    r"fstream|iostream|cstdio|stdio\.h|filesystem|toml\+\+/.*|nlohmann/.*":
        {"io", "study", "files", "runner", "report"},
    r"netcdf.*": {"files"},
    r"tbb/.*|thread|mpi\.h": {"runner"},
}
# What stands outside the modules, and which of them it does without.
DOORS = {"apps": set(), "bindings": {"runner"}, "web/wasm": {"files", "runner"}}
# Libraries that one source alone includes, tests among them: what uses them, does so through that one.
ONE_SOURCE = ("toml++", "netcdf")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def sources(root, *folders):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                yield path


def includes(root):
    sources_of = {library: set() for library in ONE_SOURCE}
    for path in sources(root, "src/bentur"):
        module = path.relative_to(root / "src/bentur").parts[0]
        if module not in ALLOWED:
            yield f"{path}: unknown module '{module}'"
            continue
        is_test = path.name.endswith("_test.cpp")
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            name = match[1]
            parts = name.split("/")
            known = ALLOWED[module] | {module} | (TESTS_USE.get(module, set()) if is_test else set())
            if parts[0] == "bentur" and parts[1] not in known:
                yield f"{path}:{number}: {module} must not include {name}"
            if match[0].rstrip().endswith('"') and parts[0] not in ("bentur", "tests"):
                yield f'{path}:{number}: write "bentur/<module>/<file>.h", not "{name}"'
            if name.endswith(".cpp"):
                yield f"{path}:{number}: {name} is no header"
            if parts[0] == "tests" and not is_test:
                yield f"{path}:{number}: only tests include {name}"
            if parts[0] == "bentur" and parts[1] != module and {"engine", "internal"} & set(parts):
                yield f"{path}:{number}: {name} is private to its module"
            if not is_test and any(module not in who and re.fullmatch(headers, name) for headers, who in OUTSIDE.items()):
                yield f"{path}:{number}: {module} must not include <{name}>"
            for library in ONE_SOURCE:
                if name.startswith(library):
                    sources_of[library].add(str(path))
    for door, without in DOORS.items():
        for path in sources(root, door):
            for number, line in enumerate(path.read_text().splitlines(), 1):
                match = INCLUDE.match(line)
                parts = match[1].split("/") if match else [""]
                if parts[0] != "bentur":
                    continue
                if {"engine", "internal"} & set(parts):
                    yield f"{path}:{number}: {match[1]} is private to its module"
                if parts[1] in without:
                    yield f"{path}:{number}: {door} must not include {match[1]}"
    for library, found in sources_of.items():
        if len(found) > 1:
            yield f"more than one source includes {library}: " + ", ".join(sorted(found))


def sizes(root):
    for path in sources(root, "src", "apps", "tests", "bench", "bindings"):
        lines = len(path.read_text().splitlines())
        limit = 250 if path.suffix == ".h" else 500
        if lines > limit:
            yield f"{path}: {lines} lines, at most {limit}"
    for folder in {path.parent for path in sources(root, "src", "apps", "tests", "bench", "bindings")}:
        files = sum(1 for path in folder.iterdir() if path.is_file())
        if files > 25:
            yield f"{folder}: {files} files, at most 25"


def output(root):
    """The library neither prints nor ends the process: that is the program's."""
    forbidden = re.compile(r"std::(cout|cerr|clog)\b|\b(f?printf|puts|fmt::print|exit|abort)\s*\(")
    for path in sources(root, "src"):
        if path.name.endswith("_test.cpp"):
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            code = re.sub(r'"(\\.|[^"\\])*"', '""', line).split("//")[0]
            if match := forbidden.search(code):
                yield f"{path}:{number}: {match[0].strip()} in the library"


def headers(root):
    for path in sources(root, "src", "apps", "tests"):
        text = path.read_text()
        if path.suffix == ".h" and "#pragma once" not in text:
            yield f"{path}: no #pragma once"
        if path.suffix == ".h" and re.search(r"^\s*using namespace", text, re.MULTILINE):
            yield f"{path}: using namespace in a header"


def readme(root):
    """The commands, files and headers the documents name exist, the README's first two commands are the ones promised, and
    its case stands in the example it is taken from."""
    text = (root / "README.md").read_text()
    commands = re.findall(r"^(\./dev \S+)", text, re.MULTILINE)
    if commands[:2] != ["./dev run", "./dev test"]:
        yield f"README.md: the first commands are {commands[:2]}, not ./dev run and ./dev test"
    known = re.findall(r"^  (\w+)\)", (root / "dev").read_text(), re.MULTILINE)
    for command in commands:
        if command.split()[1] not in known:
            yield f"README.md: {command} is not a command of ./dev"
    example = (root / "examples/m12-el-centro.toml").read_text()
    given = {line.split("#")[0].strip() for line in example.splitlines()}
    for line in re.search(r"```toml\n(.*?)```", text, re.DOTALL)[1].splitlines():
        if line.split("#")[0].strip() not in given:
            yield f"README.md: '{line}' is not in examples/m12-el-centro.toml"
    for header in re.findall(r"`([\w/]+\.h)`", (root / "docs/notation.md").read_text()):
        if not (root / "src/bentur" / header).exists():
            yield f"docs/notation.md: no {header}"
    for document in [*root.glob("*.md"), *root.glob("bench/*.md"), *sorted((root / "docs").rglob("*.md"))]:
        for target in re.findall(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)", document.read_text()):
            if not (document.parent / target).exists():
                yield f"{document}: no {target}"


def prose(root):
    """Prose of documents is wrapped: `./dev format`."""
    for path in sorted(root.rglob("*.md")):
        if {"build", "node_modules", ".venv", ".venv-peers"} & set(path.relative_to(root).parts):
            continue
        text = path.read_text()
        if wrap.wrapped(text) != text:
            yield f"{path}: lines of prose over {wrap.WIDTH} characters; ./dev format wraps them"


def alone(root):
    """What is cloned works by itself: only tests name files beside the repository, and they are skipped without them."""
    beside = re.compile(r"\.\./shared\b")
    folder = re.compile(r"""(SOURCE|parent|\.\.").*\bshared\b""")  # in a test, which asks for it by its one name
    asked = {"shared_folder.h", "shared_folder.py", "check_sources.py"}
    for path in sorted([*(root / "tests").rglob("*"), *(root / "src").rglob("*_test.cpp")]):
        if path.suffix not in (".cpp", ".h", ".py") or path.name in asked or "__pycache__" in path.parts:
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if folder.search(line) and not line.lstrip().startswith(("//", "#", "again =")):
                yield f"{path}:{number}: names the folder beside the repository, which shared_folder.h and .py do"
    left_out = {"build", "node_modules", ".venv", ".venv-peers", ".git", "tests", "records", "__pycache__"}
    for path in sorted(root.rglob("*")):
        if left_out & set(path.relative_to(root).parts) or not path.is_file() or "_test." in path.name:
            continue
        if path.suffix not in (".md", ".py", ".sh", ".toml", ".txt", ".cmake", ".cpp", ".h", ".mjs", ".ts", ".tsx", ".slurm", ""):
            continue
        for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
            if beside.search(line):
                yield f"{path}:{number}: names a file beside the repository"


def colours(root):
    """One palette: figures and pages name its colours, and none is written anywhere else."""
    palette = root / "src/bentur/report/figures/internal/colours.h"
    written = re.compile(r"""["':\s(,]#(?:[0-9a-fA-F]{3,4}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})\b(?!\()|\b(?:rgb|hsl)a?\(""")
    named = re.compile(r"""\b(?:color|background|fill|stroke|stop-color)["']?\s*[:=]\s*["']?(?!none|inherit|transparent|var\b)"""
                       r"(?:black|white|red|green|blue|grey|gray|orange|yellow|purple)\b")
    for folder in ("src", "apps", "bindings", "web", "tools"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp", ".css", ".js", ".mjs", ".ts", ".tsx", ".html", ".py") or path == palette:
                continue
            if "_test." in path.name or {"node_modules", "test"} & set(path.relative_to(root).parts):
                continue
            for number, line in enumerate(path.read_text().splitlines(), 1):
                # The script for matplotlib is for those who restyle; comments show what is read.
                if (written.search(line) or named.search(line)) and not line.lstrip().startswith("//") and path.name != "script.cpp":
                    yield f"{path}:{number}: a colour that is not of {palette.name}: {line.strip()[:80]}"


def judgement(root):
    """What is needed of a gap is held against what is given by judge() and by those who find its facts, and nowhere else."""
    need, width = r"(?:gap_)?need(?:ed|s)?(?:_reversed)?\w*|simulated|asked", r"width|given|narrowest"
    between = r"[^;<>=!?{}]{0,30}"
    compared = re.compile(rf"\b(?:{need})\b{between}\s[<>]=?\s{between}\b(?:{width})\b|"
                          rf"\b(?:{width})\b{between}\s[<>]=?\s{between}\b(?:{need})\b")
    finders = ("src/bentur/model/judgement/", "src/bentur/model/gap/", "src/bentur/study/gap/gap_study.cpp",
               "src/bentur/study/gap/record_need.cpp")
    solver = ("src/bentur/pounding/",)  # which runs the motion reversed where a gap of several closes
    for path in sources(root, "src", "apps", "bindings", "web"):
        name = str(path.relative_to(root))
        if path.name.endswith("_test.cpp") or name.startswith(finders):
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            code = re.sub(r'"(\\.|[^"\\])*"', '""', line).split("//")[0]
            if "falls_short(" in code or (compared.search(code) and not name.startswith(solver)):
                yield f"{path}:{number}: compares what is needed with what is given, which judge() does: {code.strip()[:80]}"


def version(root):
    """One version: that of CMakeLists.txt, with which CHANGELOG.md begins. CITATION.cff repeats it, with its date once it has one."""
    told = re.search(r"^project\(bentur VERSION ([0-9.]+) ", (root / "CMakeLists.txt").read_text(), re.MULTILINE)[1]
    citation = (root / "CITATION.cff").read_text()
    cited = re.search(r"^version: (.*)$", citation, re.MULTILINE)[1]
    if cited != told:
        yield f"CITATION.cff: version {cited}, but CMakeLists.txt has {told}; ./dev release writes both"
    first, when = re.search(r"^## ([0-9.]+) \((.*)\)$", (root / "CHANGELOG.md").read_text(), re.MULTILINE).groups()
    if first != told:
        yield f"CHANGELOG.md: begins with {first}, but CMakeLists.txt has {told}"
    dated = re.search(r"^date-released: (.*)$", citation, re.MULTILINE)
    if (dated[1] if dated else "unreleased") != when:
        yield f"CITATION.cff: {dated[0] if dated else 'no date-released'}, but CHANGELOG.md has {first} ({when})"


OLD_WORDS = re.compile(r"\b(?:(?:one|other|both|either|which) ways? round|told(?! apart)|tells?(?![^.]*\b(?:apart|from)\b)|"
                       r"bears?|bore)\b")


def words(root):
    """One word for one thing, in plain order: what a reader of results and documents sees says "reports", "carries" and
    "reversed", not "tells", "bears" and "the other way round"; so do the comments of headers."""
    catalogue = root / "src/bentur/report/html/texts.toml"
    lines = [(catalogue, number, line) for number, line in enumerate(catalogue.read_text().splitlines(), 1) if line.startswith("en = ")]
    for path in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
        lines += [(path, number, line) for number, line in enumerate(path.read_text().splitlines(), 1)]
    for path in sorted((root / "src/bentur/io/schema").glob("*.cpp")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            lines += [(path, number, text) for text in re.findall(r'"((?:\\.|[^"\\])*)"', line)]
    for path in sorted(path for folder in ("src", "apps", "bindings", "web/wasm") for path in (root / folder).rglob("*.h")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            comment = line.partition("//")[2]
            if re.search(r"\b(told|bears|ways? round)\b", re.sub(r"`[^`]*`", "", comment)):
                yield f"{path}:{number}: {comment.strip()!r}: use the glossary's word (reported, carries, reversed)"
    for path, number, line in lines:
        if found := OLD_WORDS.search(line):
            yield f'{path}:{number}: "{found[0]}": use the glossary\'s word (reports, shows, carries, reversed)'


RULES = {rule.__name__: rule for rule in (includes, sizes, output, headers, readme, prose, alone, colours,
                                        judgement, version, words)}


def main():
    rule, root = RULES[sys.argv[1]], pathlib.Path(sys.argv[2]).resolve()
    if not any(sources(root, "src/bentur")):
        sys.exit(f"no sources under {root}")
    breaches = list(rule(root))
    print("\n".join(breaches))
    sys.exit(1 if breaches else 0)


main()
