"""What stands in blocks of the documents runs.

  python   each by itself, in the folder of the repository; where the next block stands behind "prints", that is what it
           prints
  sh       those of one page one after the other, in a scratch folder with `bentur` on the path
  toml     is TOML; a whole case is read without an error, with the records of data/ beside it
  none     each line that begins with `bentur ` is a command with options that it has; it runs where its files are there;
           each with `./dev ` one that it knows; any other command is run by what ELSEWHERE says

What stands in other blocks is run by other tests: ELSEWHERE says by which. A block or command of no kind is a failure.
"""

import contextlib
import io
import os
import re
import shutil
import subprocess
import tomllib

import docs
import pytest
from doors import ROOT

import bentur

DOCUMENTS = [ROOT / name for name in docs.documents_of(ROOT)]
FENCE = re.compile(r"^```([^`\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PRINTS = re.compile(r"\A\n+prints\n+```\n(.*?)^```$", re.MULTILINE | re.DOTALL)
# What another test or command runs, by language or by the first words of a command.
ELSEWHERE = {
    "cpp": "tests/consumer builds it",
    "json": "settings of an editor",
    "lua": "settings of an editor",
    "cmake": "tests/consumer",
    "console": "tests/worked",
    "console records": "tests/worked",
    "sh records": "./dev gallery, to draw its pictures",
    "git clone REPOSITORY": "tools/fresh.sh clones",
    "cmake --preset": "the tests' own build",
    "sudo cmake --install": "tests/consumer installs",
    "pip install .": "./dev wheels builds and installs",
    "build/release/apps/bentur/bentur run": "examples are run under the name bentur",
    "build/tsan/": "needs a oneTBB built with the thread sanitizer",
    ".venv-peers/bin/python": "./dev bench --peers, with OpenSees from PyPI",
    "python3 bench/houses.py": "takes minutes; tests/cli runs blocks of houses",
    "python3 bench/waits.py": "takes minutes, and another build to take turns with",
}
# What cannot run, by words in it, and why.
SKIPPED = {
    "my-case.toml": "a case that the reader has",
    "m12-gaps.nc": "results of a study of minutes; doors_test.py compares sweeps",
    "mpirun": "a cluster; tests/sweep runs it",
    "far-field": "needs the records of ./dev records; doors_test.py compares ida and fragility",
    "eight-and-six": "the same",
    "ida.nc": "results of the same",
    "records/": "needs the records of ./dev records",
}


def _blocks(language):
    for document in DOCUMENTS:
        text = document.read_text()
        number = 0
        for match in FENCE.finditer(text):
            if match[1] != language:
                continue
            number += 1
            prints = PRINTS.match(text[match.end() :])
            name = str(document.relative_to(ROOT))
            yield name, match[2], prints[1] if prints else None, f"{name}-{number}"


def skip(text):
    for words, why in SKIPPED.items():
        if words in text:
            pytest.skip(why)


@pytest.fixture
def bin_folder(program, tmp_path):
    folder = tmp_path / "bin"
    folder.mkdir()
    (folder / "bentur").symlink_to(program)
    return folder


def test_every_block_has_its_test():
    """No block is of a language that nothing runs, and no command in one is of nobody."""
    usage = subprocess.run(["bash", ROOT / "dev", "help"], capture_output=True, text=True, check=True).stdout
    known = set(re.findall(r"^\./dev (\w+)", usage, re.MULTILINE)) | {"help"}
    blocks = 0
    for document in DOCUMENTS:
        text = document.read_text()
        assert len(re.findall(r"^ *```", text, re.MULTILINE)) == 2 * len(FENCE.findall(text)), f"{document}: fences"
        for language, block in FENCE.findall(text):
            blocks += 1
            assert language in ("", "python", "sh", "toml") or language in ELSEWHERE, f"{document}: ```{language}"
            for line in block.splitlines() if language == "" else ():
                if command := re.match(r"\./dev\b *(\w*)", line):
                    assert command[1] in known, f"{document}: {line}"
                elif re.match(r"(\./|\.venv|build/|git |cmake |sudo |pip |npm |npx |node |python3? |apt)", line):
                    assert line.startswith(tuple(ELSEWHERE)), f"{document}: {line}"
    assert blocks > 80


PYTHON = list(_blocks("python"))


@pytest.mark.parametrize("code, printed", [b[1:3] for b in PYTHON], ids=[b[3] for b in PYTHON])
def test_python(code, printed, monkeypatch, tmp_path):
    """Run where what the repository has can be read, and what is written is not left in it."""
    skip(code)
    for one in ROOT.iterdir():
        (tmp_path / one.name).symlink_to(one)
    monkeypatch.chdir(tmp_path)
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(code, "block", "exec"), {"__name__": "block"})
    if printed is not None:
        assert out.getvalue() == printed
    assert os.getcwd() == str(tmp_path)


SHELL = sorted({b[0] for b in _blocks("sh")})


@pytest.mark.parametrize("page", SHELL)
def test_shell(page, tmp_path, bin_folder):
    """A TOML block of the page that says "Save it as `NAME`" stands there under that name."""
    if page == "docs/gallery.md":
        pytest.skip("`./dev gallery` runs its commands, to draw its pictures")
    text = (ROOT / page).read_text()
    work = tmp_path / "work"
    work.mkdir()
    for name in re.findall(r"Save it as\s+`([\w./-]+)`", text):
        (work / name).parent.mkdir(exist_ok=True)
        (work / name).write_text(re.search(r"^```toml\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)[1])
    script = "set -e\n" + "\n".join(b[1] for b in _blocks("sh") if b[0] == page)
    run = subprocess.run(["bash", "-c", script], cwd=work, capture_output=True, text=True,
                         env={**os.environ, "PATH": f"{bin_folder}:{os.environ['PATH']}"})
    assert run.returncode == 0, run.stdout[-2000:] + run.stderr


TOML = list(_blocks("toml"))


@pytest.mark.parametrize("text", [b[1] for b in TOML], ids=[b[3] for b in TOML])
def test_toml(text, tmp_path):
    if re.search(r"= \{ \.\. =|^# \.\.\.", text, re.MULTILINE):
        tomllib.loads(re.sub(r"\{ \.\. = \{ \.\. \} \}", "{}", text))
        return
    tables = tomllib.loads(text)
    if not {"building", "gap", "excitation"} <= set(tables):
        return
    for record in (ROOT / "data").glob("*.csv"):
        shutil.copy(record, tmp_path)
    bentur.Case.from_text(text, folder=tmp_path)


COMMANDS = [(b[0], line) for b in _blocks("") for line in b[1].splitlines() if line.startswith("bentur ")]


@pytest.mark.parametrize("line", [c[1] for c in COMMANDS], ids=[f"{c[0]}: {c[1]}" for c in COMMANDS])
def test_command(line, program, tmp_path, bin_folder):
    line = line.split("  #")[0]
    words = line.split()
    known = subprocess.run([program, words[1], "--help"], capture_output=True, text=True, check=True).stdout
    for option in re.findall(r"(?<=\s)--[\w-]+", line):
        assert option in known, f"bentur {words[1]} has no {option}"
    skip(line)
    inputs = [w for w in words[2:] if w.endswith((".toml", ".csv", ".AT2"))]
    if not inputs or not all((ROOT / w).exists() for w in inputs):
        pytest.skip("its files are the reader's")
    work = tmp_path / "work"
    work.mkdir()
    for name in ("examples", "data"):
        (work / name).symlink_to(ROOT / name)
    run = subprocess.run(["bash", "-c", line], cwd=work, capture_output=True, text=True,
                         env={**os.environ, "PATH": f"{bin_folder}:{os.environ['PATH']}"})
    assert run.returncode == 0, run.stderr
