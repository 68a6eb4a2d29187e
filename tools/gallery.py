"""gallery.py BENTUR ROOT OUTPUT: runs the commands of docs/gallery.md and puts the pictures it shows into OUTPUT.

Blocks marked "sh records" need the ground motions of ./dev records and are left out, with a note, where these are missing.
"""

import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile


def commands(text, has_records):
    """The command lines of all blocks that can be run, and whether any had to be left out."""
    lines = []
    left_out = False
    for kind, block in re.findall(r"^```sh( records)?\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        if kind and not has_records:
            left_out = True
            continue
        lines += block.strip().splitlines()
    return lines, left_out


def pictures(text):
    return re.findall(r"\]\(figures/([^)]+\.svg)\)", text)


def made(folder, name):
    """The file a picture of the page comes from: NAME.svg, or for DIR-KIND.svg that of a run in DIR."""
    run, _, kind = name.partition("-")
    of_run = folder / run / "figures" / kind
    return of_run if of_run.is_file() else folder / name


def main():
    bentur, root, output = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
    text = (root / "docs/gallery.md").read_text()
    lines, left_out = commands(text, (root / "records").is_dir())
    output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="bentur-gallery-") as name:
        folder = pathlib.Path(name)
        for part in ("examples", "data", "records"):
            if (root / part).is_dir():
                (folder / part).symlink_to(root / part)
        for line in lines:
            words = shlex.split(line)
            if words[0] != "bentur":
                sys.exit(f"docs/gallery.md: {line}: is not a command of bentur")
            result = subprocess.run([bentur, *words[1:]], cwd=folder, capture_output=True, text=True)
            if result.returncode != 0:
                sys.exit(f"{line}\n{result.stderr}")
        missing = []
        for picture in pictures(text):
            source = made(folder, picture)
            if source.is_file():
                shutil.copyfile(source, output / picture)
            else:
                missing.append(picture)
    if missing and not left_out:
        sys.exit("docs/gallery.md: no command makes " + ", ".join(missing))
    if missing:
        print("left as they were, since ./dev records has not been run: " + ", ".join(missing), file=sys.stderr)


main()
