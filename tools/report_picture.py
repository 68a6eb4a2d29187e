"""report_picture.py BENTUR ROOT OUTPUT: the first screen of a report, at its hardest impact, as OUTPUT/report.png.

Without chromium the picture stays as it was.
"""

import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
WIDTH, LEAST, MOST = 960, 700, 1800  # CSS pixels


def main():
    bentur, root, output = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
    sys.path.insert(0, str(root / "tests/report"))
    import browser
    if browser.find() is None:
        print("left as it was, since chromium is not installed: report.png", file=sys.stderr)
        return
    with tempfile.TemporaryDirectory(prefix="bentur-picture-") as name:
        page = pathlib.Path(name) / "report.html"
        subprocess.run([bentur, "report", root / "examples/row-of-three.toml", "-o", page], check=True,
                       stderr=subprocess.DEVNULL)
        driver = browser.Browser(browser.find(), name)
        try:
            driver.resize(WIDTH, 900)
            driver.open(page)
            driver.evaluate("new Promise(r => setTimeout(r, 300))")
            end = driver.evaluate("document.querySelector('#motion .controls').getBoundingClientRect().bottom + scrollY")
            driver.screenshot(output / "report.png", max(LEAST, min(MOST, end + 20)))
        finally:
            driver.close()


main()
