"""Records and answers that the project does not ship: `SHARED` is ../shared beside the repository, or the folder that the
environment variable BENTUR_SHARED names. Where it does not exist, as for most users, tests that need it are skipped.
"""

import os
import pathlib

SHARED = pathlib.Path(os.environ.get("BENTUR_SHARED", pathlib.Path(__file__).resolve().parents[2] / "shared"))
