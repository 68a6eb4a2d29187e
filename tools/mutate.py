#!/usr/bin/env python3
"""Mutation testing: mutate.py ROOT [--count N] [--seed S] [--minutes M] [--jobs J].

Some statements of the library are changed, one at a time: a comparison, an operator, a number, a condition, or the
statement is left out. All changes are compiled into one build, in build/mutate, beside what they change:
`if (mutant(7)) { CHANGED } else { ORIGINAL }`; BENTUR_MUTANT chooses one as a program starts. Objects of build/release
are linked with the changed libraries, so that only these are compiled anew.

Each test is first run alone, to see which changes it comes by and how long it takes. Then each change is tried with the
tests that come by it, the quick ones first, until one fails: it is noticed. What none of these notices is tried with 1,000 random
cases (tests/mutation/answers.cpp); where they answer the same to the bit, it counts for nothing, but in `study`, which
these cases do not use. What is left is tried with the tests of the command line. Results are kept in
build/mutate/results.json and gone on with.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import random
import re
import shlex
import signal
import subprocess
import sys
import time

SHARES = {"elements": 50, "contact": 45, "solve": 90, "model": 45, "study": 40}  # of 270
TESTS = ["elements_test", "contact_test", "structure_test", "solve_test", "pounding_test", "model_test", "io_test",
         "study_test", "files_test", "runner_test", "system_test"]
SUITES = ["reported/reported", "sweep/exchange", "suite/suite", "sweep/ida", "sweep/remedy", "cli/cli"]  # quick ones first
LONGEST = 20  # [s] of a test that is used
SWAPS = [(" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "), (" != ", " == "),
         (" && ", " || "), (" || ", " && "), (" + ", " - "), (" - ", " + "), ("std::min(", "std::max("),
         ("std::max(", "std::min("), (" * ", " / ")]
NUMBER = re.compile(r"(?<![\w.\]\"'])(\d+(?:\.\d+)?(?:e-?\d+)?)(?![\w.'])")
ASSIGNED = re.compile(r"[A-Za-z_][\w.\->()\[\]]*(?:\([^;{}]*?\))? (?:=|\+=|-=|\*=) ")
DECLARED = re.compile(r"(?:const )?(?:double|bool|int|std::size_t|Eigen::Index) \w+ = ")
MUTANT_H = """#pragma once
namespace bentur { extern int mutant_chosen; extern unsigned char mutant_reached[];
inline bool mutant(int m) { mutant_reached[m] = 1; return m == mutant_chosen; } }
"""
MUTANT_CPP = """#include "mutant.h"
#include <cstdio>
#include <cstdlib>
namespace bentur { unsigned char mutant_reached[%d];
int mutant_chosen = std::getenv("BENTUR_MUTANT") ? std::atoi(std::getenv("BENTUR_MUTANT")) : -1;
static const struct Trace { ~Trace() {
  if (const char* name = std::getenv("BENTUR_MUTANT_TRACE")) if (std::FILE* file = std::fopen(name, "wb")) {
    std::fwrite(mutant_reached, 1, sizeof mutant_reached, file); std::fclose(file); } } } trace; }
"""


def blanked(text):
    """The text with comments and what is in quotes replaced by blanks, of the same length."""
    pattern = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])\''
    return re.sub(pattern, lambda m: re.sub(r"[^\n]", "\0", m.group()), text, flags=re.S)


def closing(text, at):
    """Where the parenthesis closes that opens at `at`."""
    depth = 0
    for i in range(at, len(text)):
        depth += {"(": 1, ")": -1}.get(text[i], 0)
        if depth == 0:
            return i
    return len(text)


def changes(plain, original, scalar):
    """Each way to change one token of an expression: (what, changed text)."""
    found = []
    for old, new in SWAPS:
        if old == " * " and not scalar or old in (" + ", " - ") and ("\0" in plain or re.search("text|name|say", plain)):
            continue
        for m in re.finditer(re.escape(old), plain):
            found.append((f"{old.strip(' (')} is {new.strip(' (')}", original[:m.start()] + new + original[m.end():]))
    for m in NUMBER.finditer(plain):
        new = {"0": "1", "0.0": "1.0", "1": "2", "2": "3"}.get(m.group(), m.group() + "*1.25" if "." in m.group() else None)
        if new and not plain[:m.start()].rstrip().endswith(("<", "[")):
            found.append((f"{m.group()} is {new}", original[:m.start()] + new + original[m.end():]))
    return found


def sites(text):
    """Statements that may be changed: (begin, end, [(what, replacement with {m} for the number)])."""
    plain = blanked(text)
    for m in re.finditer(r"(?<=[;{})])\s+(?=[A-Za-z_(])", plain):
        at = m.end()
        rest = plain[at:]
        if rest.startswith("if (") and not rest.startswith("if constexpr"):
            end = closing(plain, at + 3)
            inside, source = plain[at + 4:end], text[at + 4:end]
            if re.search(r"[;\[{]", inside) or re.search(r"[^=<>!]=[^=]", inside):
                continue
            ways = changes(inside, source, False) + [("the condition is turned round", f"!({source})")]
            yield at + 4, end, [(w, f"(mutant({{m}}) ? bool({new}) : bool({source}))") for w, new in ways]
            if (then := re.match(r"\s+(return\b[^;{}]*);", plain[end + 1:])) is None:
                continue
            at, rest = end + 1 + then.start(1), then.group(1) + ";"
        end = at + rest.find(";") + 1
        if end == at:
            continue
        statement, source = plain[at:end], text[at:end]
        if "\n\n" in statement or re.search(r"\[[&=\]]|[{}]|constexpr|static|case ", statement):
            continue
        if statement.startswith("return ") and len(statement) > 9:
            ways = changes(statement, source, False)
            yield at, end, [(w, f"{{ if (mutant({{m}})) {new} {source} }}") for w, new in ways]
        elif declared := DECLARED.match(statement):
            start = declared.end()
            value = source[start:-1]
            ways = changes(statement[start:-1], value, "double" in declared.group())
            yield at + start, end - 1, [(w, f"(mutant({{m}}) ? ({new}) : ({value}))") for w, new in ways]
        elif ASSIGNED.match(statement):
            ways = changes(statement, source, False) + [("left out", ";")]
            for old, new in ((" += ", " -= "), (" -= ", " += ")):
                if old in statement and "\0" not in statement:
                    ways.append((f"{old.strip()} is {new.strip()}", source.replace(old, new, 1)))
            yield at, end, [(w, f"{{ if (mutant({{m}})) {{ {new} }} else {{ {source} }} }}")
                            for w, new in ways]


def drawn(root, count, seed, refused):
    """Mutants by a seed: at most one for a statement, of each module its share. Without those that do not compile."""
    chance = random.Random(seed)
    mutants = []
    for module, share in SHARES.items():
        places = []
        for file in sorted((root / "src/bentur" / module).rglob("*.cpp")):
            if file.name.endswith("_test.cpp"):
                continue
            text = file.read_text()
            for begin, end, ways in sites(text):
                line = text.count("\n", 0, begin) + 1
                ways = [w for w in ways if f"{file.relative_to(root)}:{line}: {w[0]}" not in refused]
                if ways:
                    places.append((str(file.relative_to(root)), begin, end, line, ways))
        chance.shuffle(places)
        # A return behind an if is found from both: once each.
        places = list({place[:2]: place for place in places}.values())
        for file, begin, end, line, ways in places[:max(1, round(count * share / sum(SHARES.values())))]:
            what, new = chance.choice(ways)
            mutants.append({"module": module, "file": file, "begin": begin, "end": end, "line": line, "what": what,
                            "new": new, "id": f"{file}:{line}: {what}"})
    return mutants


class Build:
    def __init__(self, root):
        self.root, self.release, self.out = root, root / "build/release", root / "build/mutate"
        self.out.mkdir(parents=True, exist_ok=True)
        ran = self.ninja("-t", "compdb").stdout
        self.commands = {c["output"]: c for c in json.loads(ran)
                         if c["output"].endswith(".o") and "/bentur_" in c["output"]}

    def ninja(self, *arguments):
        return subprocess.run(["ninja", "-C", self.release, *arguments], capture_output=True, text=True, check=True)

    def write(self, mutants):
        """The changed sources; each file of a library's build that includes one, as a copy that includes it changed."""
        copies = {}
        for number, mutant in enumerate(mutants):
            copies.setdefault(mutant["file"], []).append((number, mutant))
        self.changed = {}
        for name, of_file in copies.items():
            text = (self.root / name).read_text()
            for number, mutant in sorted(of_file, key=lambda one: -one[1]["begin"]):
                new = mutant["new"].replace("{m}", str(number))
                lines = text.count("\n", mutant["begin"], mutant["end"])  # numbers of lines stay as they are
                text = text[:mutant["begin"]] + " ".join(new.split("\n")) + "\n" * lines + text[mutant["end"]:]
            file = self.out / name
            file.parent.mkdir(parents=True, exist_ok=True)
            self.put(file, f'#include "{self.out}/mutant.h"\n#line 1 "{self.root / name}"\n' + text)
            self.changed[str(self.root / name)] = str(file)
        self.put(self.out / "mutant.h", MUTANT_H)
        self.put(self.out / "mutant.cpp", MUTANT_CPP % max(1, len(mutants)))

    @staticmethod
    def put(file, text):
        if not file.exists() or file.read_text() != text:
            file.write_text(text)

    def compile(self):
        """Compiles what has changed. @return places of errors, as FILE:LINE"""
        jobs, self.objects = [], {}
        for output, command in self.commands.items():
            source = pathlib.Path(command["file"])
            text = source.read_text() if source.exists() else ""
            if "Unity" in output:
                new = text
                for original, copy in self.changed.items():
                    new = new.replace(f'"{original}"', f'"{copy}"')
            else:
                new = f'#include "{self.changed[str(source)]}"\n' if str(source) in self.changed else text
            if new == text:
                continue
            copy, target = self.out / (output.replace("/", "_") + ".cpp"), self.out / output.replace("/", "_")
            self.put(copy, new)
            self.objects[output] = target
            line = command["command"].replace(str(source), str(copy)).replace(f"-o {output}", f"-o {target}")
            stamp = hashlib.sha256((new + "".join(pathlib.Path(c).read_text() for o, c in self.changed.items()
                                                  if c in new)).encode()).hexdigest()
            done = target.with_suffix(".stamp")
            if not (done.exists() and done.read_text() == stamp and target.exists()):
                jobs.append((line, done, stamp))
        errors = set()
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for (_, done, stamp), ran in zip(jobs, pool.map(lambda job: subprocess.run(
                    job[0] + " -w", shell=True, cwd=self.release, capture_output=True, text=True), jobs)):
                if ran.returncode == 0:
                    done.write_text(stamp)
                    continue
                here = re.findall(r"^(\S+?):(\d+):\d+: (?:fatal )?error", ran.stderr, re.M)
                if not here:
                    sys.exit(ran.stderr)
                errors |= {f"{pathlib.Path(f).relative_to(self.root)}:{n}" for f, n in here}
        return errors

    def link(self, target):
        """A program of the release build with the changed objects in place of its own. @return its path"""
        last = self.ninja("-t", "commands", target).stdout.strip().split("\n")[-1]
        out = self.out / target
        line = re.split(r" && (?=cmake|/usr/bin/cmake|cd )", last)[0].removeprefix(": && ")
        for module in SHARES:
            old = f"src/bentur/{module}/libbentur_{module}.a"
            new = self.out / f"libbentur_{module}.a"
            members = [o for o in self.commands if o.startswith(f"src/bentur/{module}/CMakeFiles/bentur_{module}.dir/")]
            new.unlink(missing_ok=True)
            subprocess.run(["ar", "qcs", new, *(str(self.objects.get(o, o)) for o in members)], cwd=self.release,
                           check=True)
            line = line.replace(old, str(new))
        line = re.sub(r"-o \S+", f"-o {out} {self.out}/mutant.o", line, count=1)
        subprocess.run(f"g++ -c -O2 {self.out}/mutant.cpp -o {self.out}/mutant.o", shell=True, check=True)
        subprocess.run(line.removesuffix(" && :"), shell=True, cwd=self.release, check=True)
        return out


def run(program, arguments, timeout, **environment):
    """@return status, seconds; a status of 124 where it took too long"""
    begin = time.time()
    started = subprocess.Popen(["nice", "-n", "19", program, *arguments], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, env={**os.environ, **environment}, start_new_session=True)
    try:
        status = started.wait(timeout)
    except subprocess.TimeoutExpired:  # what it has started ends too
        os.killpg(started.pid, signal.SIGKILL)
        started.wait()
        status = 124
    return status, time.time() - begin


def traced(build, programs, count, kept):
    """For each test how long it takes and which mutants it comes by."""
    trace = build.out / "trace"
    for name, program in programs.items():
        if name in ("answers", "bentur"):
            continue
        listed = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True, check=True).stdout
        suite = ""
        for line in listed.split("\n"):
            if line and not line.startswith(" "):
                suite = line.split()[0]
                continue
            if not line.strip() or (test := f"{name} {suite}{line.split()[0]}") in kept:
                continue
            trace.unlink(missing_ok=True)
            status, seconds = run(program, [f"--gtest_filter={test.split()[1]}"], LONGEST,
                                  BENTUR_MUTANT_TRACE=str(trace))
            good = status == 0 and trace.exists()
            kept[test] = [seconds, [i for i, byte in enumerate(trace.read_bytes()) if byte] if good else []]
            yield
    trace.unlink(missing_ok=True)


def run_suite(build, programs, suite, timeout, **environment):
    """A test in Python that starts the program."""
    return run(sys.executable, [build.root / f"tests/{suite}_test.py"], timeout, BENTUR=str(programs["bentur"]),
               BENTUR_SOURCE=str(build.root), BENTUR_MPI="0", BENTUR_SANITIZED="0", BENTUR_BASH="/bin/bash",
               **environment)


def tried(build, programs, number, tests, module):
    """What became of one mutant: who noticed it, or `survived`, or `the same`. Its own module's tests come first."""
    chosen = {"BENTUR_MUTANT": str(number)}
    mine = sorted((seconds, test) for test, (seconds, reached) in tests.items() if number in reached)
    groups = {}
    for seconds, test in mine:
        groups.setdefault((0 if seconds < 0.3 else seconds, test.split()[0]), []).append((seconds, test.split()[1]))
    for (_, name), of_group in sorted(groups.items(), key=lambda one: (one[0][0], one[0][1] != f"{module}_test", one[0])):
        seconds = sum(s for s, _ in of_group)
        for start in range(0, len(of_group), 60):
            some = ":".join(test for _, test in of_group[start:start + 60])
            if run(programs[name], [f"--gtest_filter={some}", "--gtest_fail_fast"], 10 * seconds + 10, **chosen)[0] != 0:
                return name
    if module != "study" and answers(programs, **chosen) == build.answers:
        return "the same"
    for suite, seconds in build.suites.items():
        if run_suite(build, programs, suite, 3 * seconds + 30, **chosen)[0] != 0:
            return suite
    return "survived"


def answers(programs, **environment):
    """What 1,000 random cases answer."""
    return subprocess.run(["nice", "-n", "19", programs["answers"], "1000"], capture_output=True, timeout=1200,
                          env={**os.environ, **environment}).stdout


def report(mutants, results):
    for module in [*SHARES, ""]:
        of = [results[m["id"]] for m in mutants if m["id"] in results and m["module"].startswith(module)]
        same, left = of.count("the same"), of.count("survived")
        counted = len(of) - same
        print(f"{module or 'all':10} {len(of):4} tried, {same:3} the same, {counted - left:4} of {counted} noticed"
              f" ({100 * (counted - left) / max(1, counted):.1f} %)")
    for mutant in mutants:
        if results.get(mutant["id"]) == "survived":
            print("survived:", mutant["id"])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--count", type=int, default=270)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=1e9)
    parser.add_argument("--jobs", type=int, default=1)
    asked = parser.parse_args()
    end = time.time() + 60 * asked.minutes
    build = Build(asked.root)
    kept_in = build.out / "results.json"
    kept = json.loads(kept_in.read_text()) if kept_in.exists() else {"refused": [], "tests": {}, "results": {}, "of": ""}
    while True:
        mutants = drawn(asked.root, asked.count, asked.seed, set(kept["refused"]))
        build.write(mutants)
        errors = build.compile()
        if not errors:
            break
        bad = {m["id"] for m in mutants for e in errors if m["file"] == e.split(":")[0]
               and 0 <= int(e.split(":")[1]) - m["line"] <= 3}
        if not bad:
            sys.exit(f"mutate: these errors are of no mutant: {errors}")
        kept["refused"] += sorted(bad)
        kept_in.write_text(json.dumps(kept))
    what = hashlib.sha256(json.dumps(mutants).encode()).hexdigest()
    if kept["of"] != what:  # sources or seed are others: what is known of others' mutants does not count
        kept.update(of=what, tests={}, results={})
    programs = {name: build.link(name) for name in [*TESTS, "answers", "bentur"]
                if name in asked_targets(build)}

    def keep():
        kept_in.with_suffix(".new").write_text(json.dumps(kept))
        kept_in.with_suffix(".new").rename(kept_in)

    for i, _ in enumerate(traced(build, programs, len(mutants), kept["tests"])):
        if i % 50 == 0:
            keep()
        if time.time() > end:
            break
    keep()
    tries = {suite: run_suite(build, programs, suite, 600) for suite in SUITES}
    build.suites = {suite: seconds for suite, (status, seconds) in tries.items() if status == 0}
    if left := set(SUITES) - set(build.suites):
        print("left out, as they fail without a change:", ", ".join(sorted(left)))
    build.answers = answers(programs)
    order = list(enumerate(mutants))
    random.Random(asked.seed).shuffle(order)  # so that a run that is cut short is a sample
    left = [one for one in order if one[1]["id"] not in kept["results"]]

    def become(one):
        number, mutant = one
        return None if time.time() > end else tried(build, programs, number, kept["tests"], mutant["module"])

    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        for (_, mutant), result in zip(left, pool.map(become, left)):
            if result is not None:
                kept["results"][mutant["id"]] = result
                print(f"{result:14} {mutant['id']}", flush=True)
                keep()
    report(mutants, kept["results"])


def asked_targets(build):
    """Tests that have been built; ./dev mutate builds all."""
    places = [build.release / "tests", build.release / "apps/bentur", *(build.release / "src/bentur").iterdir()]
    return {file.name for place in places for file in place.glob("*") if file.is_file() and os.access(file, os.X_OK)} | {
        "answers" for _ in [0] if (build.release / "tests/mutation/answers").exists()}


if __name__ == "__main__":
    main()
