"""What the program says it is (cmake/version.cmake): of clones, archives, source distributions and plain folders.

BENTUR, BENTUR_SOURCE and BENTUR_BUILD name the program, the sources and the folder that it was built in.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["BENTUR_SOURCE"])
# The public version and the local one of https://peps.python.org/pep-0440, as far as there is need of them.
PEP_440 = re.compile(r"\d+\.\d+\.\d+(\.dev\d+|\.post\d+)?(\+g[0-9a-f]+(\.dirty)?)?")
DATE = "2026-11-26T20:50:30+0000"


def said(folder, **environment):
    """What the script of a folder says it is."""
    done = subprocess.run(["cmake", "-P", folder / "cmake" / "version.cmake"], check=True, capture_output=True, text=True,
                          env={**os.environ, **environment})
    return done.stdout.rstrip("\n")


def git(folder, *arguments):
    environment = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    environment |= {"GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_NOSYSTEM": "1", "GIT_COMMITTER_DATE": DATE,
                    "GIT_AUTHOR_DATE": DATE}
    settings = ["-c", "user.name=A", "-c", "user.email=a@b", "-c", "init.defaultBranch=main", "-c", "commit.gpgSign=false"]
    done = subprocess.run(["git", "-C", folder, *settings, *arguments], check=True, capture_output=True, text=True, env=environment)
    return done.stdout.rstrip("\n")


class Scratch(unittest.TestCase):
    """A folder with what the script reads, of version 0.2.0."""

    def setUp(self):
        self.scratch = pathlib.Path(tempfile.mkdtemp(prefix="bentur-version-"))
        self.addCleanup(shutil.rmtree, self.scratch)
        self.folder = self.scratch / "bentur"
        (self.folder / "cmake").mkdir(parents=True)
        for name in ("cmake/version.cmake", "cmake/commit.txt", ".gitattributes"):
            shutil.copy(SOURCE / name, self.folder / name)
        # An archive's own stamp is no stamp here.
        (self.folder / "cmake" / "commit.txt").write_text("$Format:%H %cs %(describe:tags=true,abbrev=8,match=v[0-9]*)$\n")
        told = re.search(r"^project\(.*$", (SOURCE / "CMakeLists.txt").read_text(), re.MULTILINE)[0]
        told = re.sub(r"VERSION [0-9.]+ ", "VERSION 0.2.0 ", told)
        (self.folder / "CMakeLists.txt").write_text(f"cmake_minimum_required(VERSION 3.25)\n{told}\n")

    def is_said(self, expected, folder=None):
        found = said(folder or self.folder)
        self.assertEqual(found, expected)
        self.assertIsNotNone(PEP_440.fullmatch(found), found)


class Folder(Scratch):
    def test_without_git_it_is_the_version(self):
        self.is_said("0.2.0")

    def test_a_source_distribution_says_what_its_metadata_say(self):
        (self.folder / "PKG-INFO").write_text("Metadata-Version: 2.2\nName: bentur\nVersion: 0.2.0.dev7+g01234567\n\nVersion: 9\n")
        self.is_said("0.2.0.dev7+g01234567")

    def test_the_source_is_written_where_it_changes(self):
        source = self.scratch / "version.cpp"
        command = ["cmake", f"-DOUTPUT={source}", "-P", self.folder / "cmake" / "version.cmake"]
        subprocess.run(command, check=True)
        self.assertIn('version() noexcept { return "0.2.0"; }', source.read_text())
        os.utime(source, (1, 1))
        subprocess.run(command, check=True)
        self.assertEqual(source.stat().st_mtime, 1)
        (self.folder / "PKG-INFO").write_text("Version: 0.2.1\n")
        subprocess.run(command, check=True)
        self.assertNotEqual(source.stat().st_mtime, 1)
        self.assertIn('"0.2.1"', source.read_text())


@unittest.skipUnless(shutil.which("git"), "git is not installed")
class Clone(Scratch):
    """That folder as a clone with one commit."""

    def setUp(self):
        super().setUp()
        git(self.scratch, "init", "-q", self.folder)
        git(self.folder, "add", "-A")
        self.commit()

    def commit(self):
        git(self.folder, "commit", "-q", "--allow-empty", "-m", "A change")
        self.hash = git(self.folder, "rev-parse", "HEAD")[:8]

    def change(self):
        with (self.folder / "CMakeLists.txt").open("a") as file:
            file.write("# changed\n")

    def archive(self):
        """The folder of an archive of what is committed, within the clone, as ./dev package has it."""
        folder = self.folder / "build" / "archive"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        git(self.folder, "archive", "-o", folder / "a.tar", "HEAD")
        shutil.unpack_archive(folder / "a.tar", folder)
        return folder

    def test_commits_are_counted_where_there_is_no_tag(self):
        self.is_said(f"0.2.0.dev1+g{self.hash}")
        self.commit()
        self.is_said(f"0.2.0.dev2+g{self.hash}")
        self.assertEqual(said(self.folder, GIT_DIR="/nowhere", GIT_WORK_TREE="/nowhere"), f"0.2.0.dev2+g{self.hash}")

    def test_a_change_to_what_git_tracks_is_said(self):
        (self.folder / "notes.txt").write_text("of no commit\n")
        self.is_said(f"0.2.0.dev1+g{self.hash}")
        self.change()
        self.is_said(f"0.2.0.dev1+g{self.hash}.dirty")

    def test_commits_after_the_release_before(self):
        git(self.folder, "tag", "-a", "-m", "Release", "v0.1.0")
        self.is_said(f"0.2.0.dev0+g{self.hash}")
        self.commit()
        git(self.folder, "tag", "nightly")
        self.is_said(f"0.2.0.dev1+g{self.hash}")
        self.is_said(f"0.2.0.dev1+g{self.hash}", self.archive())
        git(self.folder, "tag", "v0.2.0-rc1")
        self.is_said(f"0.2.0.dev0+g{self.hash}")

    def test_a_release_is_its_version(self):
        for options in (["-a", "-m", "Release"], []):
            git(self.folder, "tag", *options, "v0.2.0")
            self.is_said("0.2.0")
            self.is_said("0.2.0", self.archive())
            git(self.folder, "tag", "-d", "v0.2.0")
        git(self.folder, "tag", "v0.2.0")
        self.change()
        self.is_said(f"0.2.0+g{self.hash}.dirty")
        self.is_said("0.2.0", self.archive())

    def test_commits_after_the_release(self):
        git(self.folder, "tag", "v0.2.0")
        self.commit()
        self.is_said(f"0.2.0.post1+g{self.hash}")
        self.is_said(f"0.2.0.post1+g{self.hash}", self.archive())

    def test_an_archive_says_the_day_where_there_is_no_tag(self):
        self.is_said(f"0.2.0.dev20261126+g{self.hash}", self.archive())

    def test_a_plain_folder_within_a_clone_is_not_that_clone(self):
        inner = self.folder / "vendored"
        shutil.copytree(self.folder, inner, ignore=shutil.ignore_patterns(".git", "vendored"))
        self.is_said("0.2.0", inner)


class Sources(unittest.TestCase):
    """These sources, and the program built from them."""

    def test_the_program_says_what_was_compiled(self):
        compiled = pathlib.Path(os.environ["BENTUR_BUILD"], "src", "bentur", "core", "version.cpp").read_text()
        told = subprocess.run([os.environ["BENTUR"], "--version"], check=True, capture_output=True, text=True).stdout
        version = told.removeprefix("bentur ").rstrip("\n")
        self.assertIn(f'return "{version}";', compiled)
        self.assertIsNotNone(PEP_440.fullmatch(version), version)
        project = re.search(r"^project\(bentur VERSION ([0-9.]+) ", (SOURCE / "CMakeLists.txt").read_text(), re.MULTILINE)[1]
        self.assertTrue(version.startswith(project))

    @unittest.skipUnless(shutil.which("git") and (SOURCE / ".git").exists(), "these sources are no clone")
    def test_an_archive_of_them_is_configured_as_its_commit(self):
        with tempfile.TemporaryDirectory(prefix="bentur-archive-") as scratch:
            folder = pathlib.Path(scratch, "bentur")
            folder.mkdir()
            git(SOURCE, "archive", "-o", folder / "a.tar", "HEAD")
            shutil.unpack_archive(folder / "a.tar", folder)
            done = subprocess.run(["cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja", "-DBENTUR_COMPONENTS=core",
                                   "-DBENTUR_BUILD_TESTS=OFF"], check=True, capture_output=True, text=True)
            version = re.search(r"^-- bentur (.*)$", done.stdout, re.MULTILINE)[1]
            self.assertIsNotNone(PEP_440.fullmatch(version), version)
            if "+" in version:
                self.assertTrue(version.endswith("+g" + git(SOURCE, "rev-parse", "HEAD")[:8]), version)
            else:
                self.assertIn("v" + version, git(SOURCE, "tag", "--points-at", "HEAD").split())


if __name__ == "__main__":
    sys.exit(unittest.main())
