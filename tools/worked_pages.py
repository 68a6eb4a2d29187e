"""worked_pages.py BENTUR ROOT PAGE...: what the commands in the worked examples of docs/examples print, written anew.

In a PAGE each block ```console holds commands after "$ " with what they print below them. They run one after the other in
a folder that has examples/, data/ and records/ of ROOT, with BENTUR as `bentur`. A block ```console records needs the
ground motions of ./dev records.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"(?<=^```console)(| records)\n(.*?)(?=^```$)", re.MULTILINE | re.DOTALL)


def commands(block):
    """The commands of a block, each with what stands below it."""
    return [(text.split("\n", 1)[0], text.split("\n", 1)[1]) for text in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]]


def blocks(page):
    """For each block whether it needs the records, and its commands."""
    return [(needs != "", commands(block)) for needs, block in BLOCK.findall(page)]


class Place:
    """A folder in which the commands of pages run."""

    def __init__(self, bentur, root):
        self.folder = tempfile.TemporaryDirectory(prefix="bentur-worked-")
        place = pathlib.Path(self.folder.name)
        for name in ("examples", "data", "records"):
            if (root / name).exists():
                (place / name).symlink_to((root / name).resolve())
        (place / "bin").mkdir()
        (place / "bin/bentur").symlink_to(pathlib.Path(bentur).resolve())
        self.environment = os.environ | {"PATH": f"{place / 'bin'}:{os.environ['PATH']}"}

    def run(self, command):
        """What the command prints. @throws RuntimeError where it fails."""
        result = subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=self.folder.name, env=self.environment,
                                capture_output=True, text=True, timeout=280)
        if result.returncode != 0:
            raise RuntimeError(f"{command}: exit status {result.returncode}\n{result.stderr}")
        printed = re.sub(r"[ \t]+$", "", result.stdout, flags=re.MULTILINE).strip("\n")
        return printed + "\n" if printed else ""


def main():
    bentur, root = sys.argv[1], pathlib.Path(sys.argv[2])
    for name in sys.argv[3:]:
        page, place = pathlib.Path(name), Place(bentur, root)
        text = page.read_text()
        if any(needs for needs, _ in blocks(text)) and not (root / "records").is_dir():
            sys.exit(f"{page} needs records/: run ./dev records first")
        renew = lambda found: found[1] + "\n" + "".join(f"$ {command}\n{place.run(command)}"  # noqa: E731
                                                        for command, _ in commands(found[2]))
        page.write_text(BLOCK.sub(renew, text))


if __name__ == "__main__":
    main()
