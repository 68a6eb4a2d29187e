"""What packages are made from: the address of the repository, and the libraries that each recipe asks for."""

import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import tomllib
import unittest

ROOT = pathlib.Path(os.environ["BENTUR_SOURCE"])
sys.path.insert(0, str(ROOT / "tools"))
import addresses  # noqa: E402


class Addresses(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="bentur-addresses-"))
        self.addCleanup(shutil.rmtree, self.root)
        for name in [*addresses.FILES, "packaging/address"]:
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, self.root / name)

    def texts(self, address):
        (self.root / "packaging/address").write_text(address + "\n")
        addresses.main(self.root)
        return {name: (self.root / name).read_text() for name in addresses.FILES}

    def test_an_address_stands_once_in_each_file_and_another_takes_its_place(self):
        for address in "https://example.org/bentur", "https://example.org/other/bentur.git":
            texts = self.texts(address)
            for name, text in texts.items():
                self.assertEqual(text.count("https://example.org"), text.count(address), name)
                self.assertEqual(text.count(address), 1, name)
            self.assertEqual(tomllib.loads(texts["pyproject.toml"])["project"]["urls"], {"Source": address})

    def test_without_one_the_files_are_as_they_were(self):
        without = self.texts("")
        self.assertNotIn("example.org", "".join(without.values()))
        self.texts("https://example.org/bentur")
        self.assertEqual(self.texts(""), without)

    def test_what_is_committed_is_what_the_address_gives(self):
        address = (ROOT / "packaging/address").read_text().strip()
        self.assertEqual(self.texts(address), {name: (ROOT / name).read_text() for name in addresses.FILES})


# Libraries of Debian by their names for conda and for vcpkg.
LIBRARIES = {
    "libeigen3-dev": ("eigen", "eigen3"), "libfmt-dev": ("fmt", "fmt"), "libcli11-dev": ("cli11", "cli11"),
    "nlohmann-json3-dev": ("nlohmann_json", "nlohmann-json"), "libtomlplusplus-dev": ("tomlplusplus", "tomlplusplus"),
    "libboost-dev": ("libboost-headers", "boost-math"), "libtbb-dev": ("tbb-devel", "tbb"),
    "libnetcdf-dev": ("libnetcdf", "netcdf-c"), "libnlopt-dev": ("nlopt", "nlopt"),
    "libutf8proc-dev": ("libutf8proc", "utf8proc"),
}


class Libraries(unittest.TestCase):
    def test_every_recipe_asks_for_those_that_dev_installs(self):
        listed = re.search(r"^run_packages=\(([^)]*)\)", (ROOT / "dev").read_text(), re.MULTILINE)[1].split()
        installed = {name for name in listed if name.endswith("-dev")}
        self.assertEqual(installed, set(LIBRARIES))
        debian = re.findall(r"[\w.-]+", re.search(r"^Build-Depends:((?:.*\n )*.*)", (ROOT / "packaging/debian/control").read_text(), re.MULTILINE)[1])
        self.assertLessEqual(installed, set(debian))
        host = re.search(r"^  host:\n((?:    - .*\n)*)", (ROOT / "packaging/conda/meta.yaml").read_text(), re.MULTILINE)[1]
        self.assertEqual(set(re.findall(r"- (\S+)", host)), {conda for conda, _ in LIBRARIES.values()})
        port = json.loads((ROOT / "packaging/vcpkg/vcpkg.json").read_text())["dependencies"]
        self.assertLessEqual({vcpkg for _, vcpkg in LIBRARIES.values()}, {one for one in port if isinstance(one, str)})


class Paper(unittest.TestCase):
    TEXT = (ROOT / "paper/paper.md").read_text()

    def test_what_it_cites_and_shows_is_there(self):
        known = set(re.findall(r"^@\w+\{(\w+),", (ROOT / "docs/references.bib").read_text(), re.MULTILINE))
        cited = set(re.findall(r"@(\w+)", self.TEXT))
        self.assertGreater(len(cited), 4)
        self.assertLessEqual(cited, known)
        for picture in re.findall(r"\]\((\S+)\)", self.TEXT):
            self.assertTrue((ROOT / "paper" / picture).exists(), picture)

    def test_its_numbers_are_those_of_the_documents(self):
        codes = re.search(r"^## Rules of the codes\n(.*?)^## ", (ROOT / "docs/separation-rules.md").read_text(), re.MULTILINE | re.DOTALL)[1]
        self.assertIn(f"rules of {len(re.findall(r'^[|] `', codes, re.MULTILINE))} codes", self.TEXT)
        rows = re.findall(r"^[|] (?:m12|storeys|row)\S* +[|](.*)[|]$", (ROOT / "docs/performance.md").read_text(), re.MULTILINE)[:6]
        numbers = [[float(re.search(r"[\d,.]+", cell)[0].replace(",", "")) for cell in row.split("|")[2::2]] for row in rows]
        fastest, odeint = zip(*numbers)
        for low, high in (min(fastest), max(fastest)), (min(odeint), max(odeint)):
            self.assertRegex(" ".join(self.TEXT.split()), rf"\b{low:,g} (and|to) {high:,g} times")


if __name__ == "__main__":
    unittest.main()
