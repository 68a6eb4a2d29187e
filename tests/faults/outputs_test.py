#!/usr/bin/env python3
"""What an output must never do: harm an input, a device or a file that is not bentur's own (docs/result-files.md).

The program under test is the environment variable BENTUR, the repository BENTUR_SOURCE. Devices, pipes and links are made
in a scratch folder; where the machine does not let us make a device, the test says so and is skipped.
"""

import hashlib
import json
import os
import pathlib
import re
import shutil
import socket
import stat
import subprocess
import tempfile
import unittest

BENTUR = os.environ["BENTUR"]
SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
MINE = "something of the user's own\n"
STUDY = 'case = "case.toml"\n[[vary]]\nparameter = "gap[0].width"\nvalues = [0.2, 0.4]\n'
IDA = 'case = "case.toml"\n[ida]\nintensity = "pga"\nunit = "g"\nlevels = [0.1, 0.2]\n'


class Outputs(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="bentur-outputs-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.bentur("example", "m12-el-centro", "-o", ".")
        os.rename(self.folder / "m12-el-centro.toml", self.folder / "case.toml")
        self.case, self.record = self.folder / "case.toml", self.folder / "el-centro-1940-ns.csv"
        (self.folder / "study.toml").write_text(STUDY)
        (self.folder / "ida.toml").write_text(IDA)
        self.inputs = {file.name: file.read_bytes() for file in self.folder.iterdir()}

    def bentur(self, *arguments, status=0):
        result = subprocess.run([BENTUR, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder, timeout=60)
        self.assertEqual(result.returncode, status, f"{arguments}\n{result.stdout}\n{result.stderr}")
        return result

    def refused(self, *arguments):
        """Bad input, said in one line, and no input has changed."""
        result = self.bentur(*arguments, status=2)
        self.assertEqual(result.stdout, "")
        self.assertRegex(result.stderr, r"^\S.*: not written: .+\n$")
        for name, content in self.inputs.items():
            self.assertEqual((self.folder / name).read_bytes(), content, f"{arguments} changed {name}")
        self.assertEqual([file.name for file in self.folder.rglob(".*")], [], "nothing temporary is left")
        return result.stderr

    def writers(self):
        """Every command that writes one file, as arguments before its name."""
        commands = {"report": ["report", "case.toml", "-o"],
                    "spectrum": ["spectrum", self.record.name, "--unit", "g", "--periods", "0.1:1:3", "-o"],
                    "sweep": ["sweep", "study.toml", "-q", "-o"],
                    "ida": ["ida", "ida.toml", "-q", "-o"]}
        for name, command in commands.items():
            with self.subTest(name):
                yield name, command

    def picture_writers(self):
        self.bentur("run", "case.toml", "-q", "-o", "results")
        for name, command in (("plot", ["plot", "results", "opening", "-o"]),
                              ("picture", ["spectrum", self.record.name, "--unit", "g", "-o"])):
            with self.subTest(name):
                yield name, command


class Places(Outputs):
    def stays(self, place, is_still, word):
        for _, command in self.writers():
            self.assertIn(word, self.refused(*command, place))
            self.assertTrue(is_still(os.lstat(place).st_mode))
            self.assertIn(word, self.refused(*command, place, "--force"))
            self.assertTrue(is_still(os.lstat(place).st_mode), "not even by force")
        for _, command in self.picture_writers():
            picture = place.with_name("picture.svg")
            os.rename(place, picture)
            self.assertIn(word, self.refused(*command, picture))
            self.assertTrue(is_still(os.lstat(picture).st_mode))
            os.rename(picture, place)
        # One file of a folder of results.
        for name in "summary.json", "impacts.csv", "histories.nc", "case.toml":
            (self.folder / "out").mkdir()
            os.rename(place, self.folder / "out" / name)
            self.assertIn(word, self.refused("run", "case.toml", "-q", "-o", "out"))
            self.assertTrue(is_still(os.lstat(self.folder / "out" / name).st_mode))
            self.assertEqual(len(list((self.folder / "out").iterdir())), 1)
            os.rename(self.folder / "out" / name, place)
            (self.folder / "out").rmdir()

    def test_devices(self):
        for kind, is_still, number in ((stat.S_IFCHR, stat.S_ISCHR, os.makedev(1, 3)),
                                       (stat.S_IFBLK, stat.S_ISBLK, os.makedev(7, 250))):
            node = self.folder / "node"
            try:
                os.mknod(node, kind | 0o600, number)
            except OSError as error:
                self.skipTest(f"no device can be made here: {error}")
            self.stays(node, is_still, "is a device")
            node.unlink()

    def test_pipes(self):
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        self.stays(pipe, stat.S_ISFIFO, "is a pipe")

    def test_sockets(self):
        place = self.folder / "socket"
        with socket.socket(socket.AF_UNIX) as server:
            server.bind(str(place))
            self.stays(place, stat.S_ISSOCK, "is a socket")

    def test_folders(self):
        place = self.folder / "folder"
        place.mkdir()
        self.stays(place, stat.S_ISDIR, "is a folder")

    def test_a_link_to_a_pipe_and_one_that_leads_nowhere(self):
        os.mkfifo(self.folder / "pipe")
        os.symlink("pipe", self.folder / "link")
        os.symlink("round", self.folder / "round")
        for _, command in self.writers():
            self.assertIn("is a pipe", self.refused(*command, "link"))
            self.assertIn("leads nowhere", self.refused(*command, "round"))

    def test_a_file_in_place_of_the_folder(self):
        (self.folder / "plain").write_text(MINE)
        for place in "plain", "plain/below":
            self.assertIn("not a folder", self.refused("run", "case.toml", "-q", "-o", place))
        for _, command in self.writers():
            self.assertIn("not a folder", self.refused(*command, "plain/below"))
        self.assertEqual((self.folder / "plain").read_text(), MINE)

    def test_missing_folders_are_made_by_all_alike(self):
        for name, command in self.writers():
            self.bentur(*command, f"new-{name}/deeper/file")
            self.assertTrue((self.folder / f"new-{name}/deeper/file").is_file())

    def test_standard_output_where_the_format_allows(self):
        self.assertTrue(self.bentur("report", "case.toml", "-o", "-").stdout.startswith("<!DOCTYPE html>"))
        spectrum = ["spectrum", self.record.name, "--unit", "g", "--periods", "0.1:1:3"]
        lines = self.bentur(*spectrum, "-o", "-").stdout.splitlines()
        self.assertEqual(len(lines), 4)
        self.assertTrue(lines[0].startswith("period [s],"))
        self.bentur(*spectrum, "-o", "-", "--json", status=2)
        for command in ["sweep", "study.toml"], ["ida", "ida.toml"], ["run", "case.toml"]:
            self.assertIn("--output -", self.bentur(*command, "-o", "-", status=2).stderr)
        self.assertFalse((self.folder / "-").exists())


class Links(Outputs):
    def test_what_a_link_leads_to_is_written(self):
        (self.folder / "far").mkdir()
        for name, command in self.writers():
            link, target = self.folder / f"link-{name}", self.folder / "far" / name
            os.symlink(f"far/{name}", link)  # leads to nothing so far
            for _ in range(2):  # made, then replaced
                self.bentur(*command, link)
                self.assertTrue(link.is_symlink())
                self.assertGreater(target.stat().st_size, 100)
            self.assertEqual([file.name for file in self.folder.rglob(".*")], [])

    def test_files_of_a_folder_of_results(self):
        (self.folder / "out").mkdir()
        os.symlink("../elsewhere.json", self.folder / "out" / "summary.json")
        self.bentur("run", "case.toml", "-q", "-o", "out")
        self.assertTrue((self.folder / "out" / "summary.json").is_symlink())
        self.assertIn("solver", json.loads((self.folder / "elsewhere.json").read_text()))

    def test_other_names_of_a_result_keep_their_content(self):
        """A hard link is a file of its own once the other name is replaced."""
        self.bentur("report", "case.toml", "-o", "r.html")
        before = (self.folder / "r.html").read_bytes()
        os.link(self.folder / "r.html", self.folder / "kept.html")
        self.bentur("report", "case.toml", "-o", "r.html", "--lang", "id")
        self.assertEqual((self.folder / "kept.html").read_bytes(), before)
        self.assertNotEqual((self.folder / "r.html").read_bytes(), before)


class Inputs(Outputs):
    READS = {"report": ["case.toml", "el-centro-1940-ns.csv"], "spectrum": ["el-centro-1940-ns.csv"],
             "sweep": ["study.toml", "case.toml", "el-centro-1940-ns.csv"],
             "ida": ["ida.toml", "case.toml", "el-centro-1940-ns.csv"]}

    def test_are_never_written_under_any_name_nor_by_force(self):
        for name, command in self.writers():
            for read in self.READS[name]:
                os.symlink(read, self.folder / "symbolic")
                os.link(self.folder / read, self.folder / "hard")
                for place in read, f"./{read}", self.folder / read, "symbolic", "hard":
                    for force in [], ["--force"]:
                        self.assertIn("is read by this very command", self.refused(*command, place, *force))
                (self.folder / "symbolic").unlink()
                (self.folder / "hard").unlink()

    def test_a_record_that_is_called_like_a_result(self):
        os.rename(self.record, self.folder / "impacts.csv")
        self.case.write_text(self.case.read_text().replace(self.record.name, "impacts.csv"))
        self.inputs = {name: (self.folder / name).read_bytes() for name in ("case.toml", "impacts.csv")}
        for force in [], ["--force"]:
            self.assertIn("impacts.csv", self.refused("run", "case.toml", "-q", "-o", ".", *force))
        self.assertFalse((self.folder / "summary.json").exists())

    def test_results_that_a_report_or_a_figure_is_made_from(self):
        self.bentur("run", "case.toml", "-q", "-o", "results")
        before = {file: file.read_bytes() for file in (self.folder / "results").iterdir()}
        self.assertEqual(len(before), 4)
        for file in before:
            for force in [], ["--force"]:
                self.assertIn("is read by", self.refused("report", "results", "-o", file, *force))
        os.link(self.folder / "results/histories.nc", self.folder / "opening.svg")
        self.assertIn("is read by", self.refused("plot", "results", "opening", "--force"))
        self.assertEqual({file: file.read_bytes() for file in before}, before)


class Foreign(Outputs):
    def test_files_stay_without_force_and_go_with_it(self):
        for name, command in self.writers():
            place = self.folder / f"file-{name}"
            place.write_text(MINE)
            self.assertIn("--force", self.refused(*command, place))
            self.assertEqual(place.read_text(), MINE)
            self.bentur(*command, place, "--force")
            self.assertNotEqual(place.read_bytes(), MINE.encode())
        for _, command in self.picture_writers():
            for ending in ".svg", "-data.csv", ".py":
                place = self.folder / f"picture{ending}"
                place.write_text(MINE)
                self.assertIn("--force", self.refused(*command, "picture.svg"))
                self.assertEqual(place.read_text(), MINE)
                place.unlink()

    def test_an_empty_file_holds_nothing(self):
        for name, command in self.writers():
            (self.folder / name).touch()
            self.bentur(*command, name)
            self.assertGreater((self.folder / name).stat().st_size, 100)

    def test_results_are_replaced_by_their_like_alone(self):
        for name, command in self.writers():
            self.bentur(*command, f"{name}.result")
            self.bentur(*command, f"{name}.result")
        for name, command in self.writers():
            for other, _ in self.writers():
                if other != name:
                    self.assertIn("--force", self.refused(*command, f"{other}.result"))

    def test_write_protected_results_stay(self):
        for name, command in self.writers():
            self.bentur(*command, name)
            (self.folder / name).chmod(0o444)
            self.assertIn("write-protected", self.refused(*command, name))
            self.bentur(*command, name, "--force")

    def test_a_folder_of_results(self):
        for name in "summary.json", "impacts.csv", "histories.nc", "case.toml":
            out = self.folder / f"out-{name}"
            out.mkdir()
            (out / name).write_text(MINE)
            self.assertIn(name, self.refused("run", "case.toml", "-q", "-o", out))
            self.assertEqual([file.name for file in out.iterdir()], [name])
            self.bentur("run", "case.toml", "-q", "-o", out, "--force")
            self.assertEqual(len(list(out.iterdir())), 4)
            self.bentur("run", "case.toml", "-q", "-o", out)

    def test_an_example(self):
        place = self.folder / "free-impact.toml"
        place.write_text(MINE)
        self.assertIn("--force", self.refused("example", "free-impact"))
        self.assertEqual(place.read_text(), MINE)
        self.bentur("example", "free-impact", "--force")
        self.assertNotEqual(place.read_text(), MINE)
        self.bentur("example", "free-impact")

    def test_what_stands_beside_a_sweep(self):
        for ending in ".new", ".part.new":  # names that were once used on the way
            (self.folder / f"r.nc{ending}").write_text(MINE)
        self.bentur("sweep", "study.toml", "-q", "-o", "r.nc")
        for ending in ".new", ".part.new":
            self.assertEqual((self.folder / f"r.nc{ending}").read_text(), MINE)
        (self.folder / "r.nc.part").write_text(MINE)
        for resume in [], ["--resume"]:
            self.bentur("sweep", "study.toml", "-q", "-o", "r.nc", *resume, status=1)
        self.assertEqual((self.folder / "r.nc.part").read_text(), MINE)
        (self.folder / "r.nc.part").unlink()
        os.mkfifo(self.folder / "r.nc.part")
        self.assertIn("r.nc.part", self.refused("sweep", "study.toml", "-q", "-o", "r.nc", "--resume"))


class CaseCopies(Outputs):
    def test_the_copy_and_what_it_was_read_with(self):
        self.bentur("run", "case.toml", "-q", "-o", "out")
        out = self.folder / "out"
        self.assertEqual((out / "case.toml").read_bytes(), self.inputs["case.toml"])
        summary = json.loads((out / "summary.json").read_text())
        digest = {name: hashlib.sha256(content).hexdigest() for name, content in self.inputs.items()}
        self.assertEqual(summary["case"], {"file": "case.toml", "size": len(self.inputs["case.toml"]),
                                           "sha256": digest["case.toml"], "copied": True})
        self.assertEqual(summary["excitation"]["size"], len(self.inputs[self.record.name]))
        self.assertEqual(summary["excitation"]["sha256"], digest[self.record.name])

    def test_follows_the_case_from_run_to_run(self):
        self.bentur("run", "case.toml", "-q", "-o", "out")
        self.case.write_text(self.case.read_text() + "# edited\n")
        self.bentur("run", "case.toml", "-q", "-o", "out")
        self.assertEqual((self.folder / "out/case.toml").read_text(), self.case.read_text())

    def test_that_was_edited_is_the_users(self):
        self.bentur("run", "case.toml", "-q", "-o", "out")
        (self.folder / "out/case.toml").write_text(MINE)
        self.assertIn("out/case.toml", self.refused("run", "case.toml", "-q", "-o", "out"))
        self.assertEqual((self.folder / "out/case.toml").read_text(), MINE)

    def test_never_takes_the_place_of_the_case_itself(self):
        other = self.folder / "other.toml"
        other.write_text(self.case.read_text().replace("width = 0.2 ", "width = 0.3 "))
        for _ in range(2):
            self.bentur("run", "case.toml", "-q", "-o", ".")
            self.assertFalse(json.loads((self.folder / "summary.json").read_text())["case"]["copied"])
        # Its hash is that of the summary beside it, and still it is no copy.
        self.assertIn("case.toml", self.refused("run", "other.toml", "-q", "-o", "."))

    def test_a_report_of_the_folder_tells_what_the_case_says(self):
        self.case.write_text(self.case.read_text() + "[code]\nen-1998-1 = { behaviour_factor = 3.9 }\n")
        self.bentur("run", "case.toml", "-q", "-o", "out")
        os.rename(self.record, self.folder / "gone.csv")  # the folder is enough
        self.bentur("report", "out", "-o", "folder.html")
        os.rename(self.folder / "gone.csv", self.record)
        self.bentur("report", "case.toml", "-o", "case.html")
        # But how peaks change, which results do not know.
        texts = [re.sub('<section id="sensitivity">.*?</section>|<script.*?</script>|<svg.*?</svg>', "", (self.folder / name).read_text(), flags=re.DOTALL)
                 for name in ("folder.html", "case.html")]
        for word in "DDC", "EN 1998", "el-centro-1940-ns.csv", "210000", "Effective mass":
            of_folder, of_case = (text.count(word) for text in texts)
            self.assertGreater(of_case, 0, word)
            self.assertEqual(of_folder, of_case, word)
        # A case that is not the one of these results is not taken for it.
        (self.folder / "out/case.toml").write_text(self.case.read_text().replace("3.9", "2.9"))
        self.bentur("report", "out", "-o", "folder.html")
        self.assertFalse("EN 1998" in (self.folder / "folder.html").read_text())

    def test_files_of_two_runs_are_told_apart(self):
        self.bentur("run", "case.toml", "-q", "-o", "out")
        before = (self.folder / "out/histories.nc").read_bytes()
        self.case.write_text(self.case.read_text() + "# another case that gives the same numbers\n")
        self.bentur("run", "case.toml", "-q", "-o", "out")
        (self.folder / "out/histories.nc").write_bytes(before)
        message = self.bentur("report", "out", "-o", "report.html", status=2).stderr
        self.assertIn("histories.nc: is not of the same run", message)


class OldFigures(Outputs):
    def test_never_stay_beside_new_results(self):
        if shutil.which("rsvg-convert") is None:
            self.skipTest("rsvg-convert is not installed")
        figures = self.folder / "out/figures"
        self.bentur("run", "case.toml", "-q", "-o", "out", "--figures", "svg,pdf")
        self.assertTrue((figures / "force.pdf").exists())
        self.bentur("run", "case.toml", "-q", "-o", "out")
        self.assertFalse(figures.exists())
        self.bentur("run", "case.toml", "-q", "-o", "out", "--figures", "svg")
        (figures / "mine.svg").write_text(MINE)
        (figures / "loop.py").unlink()
        (figures / "loop.py").write_text(MINE)  # not bentur's any more, and so the others of its name
        self.bentur("run", "case.toml", "-q", "-o", "out")
        self.assertEqual(sorted(file.name for file in figures.iterdir()), ["loop-data.csv", "loop.py", "loop.svg", "mine.svg"])
        self.assertIn("figures/loop", self.refused("run", "case.toml", "-q", "-o", "out", "--figures", "svg"))
        self.assertEqual((figures / "loop.py").read_text(), MINE)


if __name__ == "__main__":
    unittest.main()
