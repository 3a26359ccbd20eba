#!/usr/bin/env python3
"""Makes gallery.md and its pictures from what the program writes.

usage: docs/make_gallery.py [--stored] PROGRAM [OUT]

Runs, from the root of the project, each scene that has no result in OUT (default out) yet, copies the drawings named
below from its folder of figures into docs/gallery/ and states its verdict and cost. Nothing is drawn by hand.
--stored runs nothing: scenes without a result are left out.
"""

import json
import pathlib
import shutil
import subprocess
import sys

CASES = pathlib.Path("verification/cases")
# Scene, its folder in OUT, its drawings, what they show.
SHOWN = [
    ("seed_column/scene_3e-5.toml", "scene_3e-5", ["pressure_profile", "cumulative_infiltration"],
     "Points lie on the reference while the column of Lee et al. (2021) fills; what each of the two took up."),
    ("levee/scene.toml", "levee", ["pressure_field", "pressure_contours", "water_table"],
     "Water seeps through a levee: the MPM and the reference, field by field."),
    ("column_collapse/scene.toml", "column_collapse", ["body_stills", "body", "energy"],
     "A column whose wall is taken away: how it runs out, and where its energy goes."),
    ("deforming_column/seepage.toml", "seepage", ["pressure_profile", "pressure_at_probes"],
     "A column that deforms while it takes up rain, against Richards' equation with the skeleton's storage."),
    ("reference_rising_lake/scene.toml", "scene_reference", ["pressure_field", "water_table"],
     "The finite-element reference alone: a lake rises in front of a slope."),
    ("moriwaki_flume/scene.toml", "moriwaki_flume", ["body_stills", "pressure_field", "marker_displacement"],
     "The flume of Moriwaki et al. (2004): infiltration, failure, run-out and rest in one run (minutes)."),
    ("moriwaki_flume/fine_contractive.toml", "fine_contractive", ["body_stills", "marker_displacement"],
     "The same flume with sand that shrinks while it shears: it slides three metres, as the experiment did (a quarter of an hour)."),
]


def command_of(scene):
    return "reference" if scene.parent.name.startswith("reference_") else "run"


def record_of(program, scene, folder):
    if not (folder / "result.json").exists():
        subprocess.run([program, command_of(scene), str(scene), "--out", str(folder)], check=False)
    return json.loads((folder / "result.json").read_text(encoding="utf-8"))


def verdicts(record):
    counts = {}
    for finding in record["findings"]:
        counts[finding["verdict"]] = counts.get(finding["verdict"], 0) + 1
    words = [f"{counts[v]} {v.upper()}" for v in ("pass", "fail", "inconclusive") if v in counts]
    return ", ".join(words) if words else "nothing is gated"


def main(program, out):
    pictures = pathlib.Path("docs/gallery")
    shutil.rmtree(pictures, ignore_errors=True)
    pictures.mkdir(parents=True)
    text = ["# Gallery", "", "Made by `docs/make_gallery.py` from the program's own output; every drawing is one of a "
            "report's `figures/`, its numbers in the CSV file beside it."]
    for name, run, drawings, sentence in SHOWN:
        scene = CASES / name
        if "--stored" in sys.argv and not (out / run / "result.json").exists():
            continue
        record = record_of(program, scene, out / run)
        text += ["", f"## {record['title']}", "", sentence, "",
                 f"`wetfront {command_of(scene)} {scene}`: {verdicts(record)}; {record['cpu_s']:.3g} s of CPU time.", ""]
        there = [drawing for drawing in drawings if (out / run / "figures" / f"{drawing}.svg").exists()]
        if not there:
            sys.exit(f"{out / run}/figures: none of {', '.join(drawings)} (the report no longer draws them)")
        for drawing in there:
            source = out / run / "figures" / f"{drawing}.svg"
            target = pictures / f"{run}_{drawing}.svg"
            shutil.copyfile(source, target)
            title = next((f["title"] for kind in ("figures", "pictures") for f in record.get(kind, []) if f["id"] == drawing),
                         "Points at three moments")
            text.append(f"![{title}](gallery/{target.name})")
    pathlib.Path("docs/gallery.md").write_text("\n".join(text) + "\n", encoding="utf-8")


if __name__ == "__main__":
    arguments = [argument for argument in sys.argv[1:] if not argument.startswith("--")]
    if not arguments:
        sys.exit(__doc__)
    main(arguments[0], pathlib.Path(arguments[1] if len(arguments) > 1 else "out"))
