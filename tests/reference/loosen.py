"""loosen.py EXPECTED FACTOR OUT: the expected summary with all relative tolerances times FACTOR; counts stay exact."""

import json
import sys

expected, factor, out = sys.argv[1:]
with open(expected, encoding="utf-8") as file:
    summary = json.load(file)
relative = summary["tolerance"]["relative"]
for kind in relative:
    relative[kind] *= float(factor)
with open(out, "w", encoding="utf-8") as file:
    json.dump(summary, file)
