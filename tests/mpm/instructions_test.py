"""Counts, with valgrind, the instructions that scenes execute in the water kernels: a dry scene none to speak of.

usage: instructions_test.py BUILD_FOLDER

A water kernel is a function that only the objects of mpm/seepage/ and mpm/two_velocity/ define, and those of
mpm/coupling/ that carry water. What is inlined from their headers into others is not seen. Exit code 77, "skipped",
where valgrind is not installed.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(sys.argv[1])
ROOMS = {
    "seepage": ["seepage/*"],
    "two_velocity": ["two_velocity/*"],
    "coupling": [f"coupling/{name}.*" for name in ("carried_water", "fixed_stress", "true_time", "water_pull")],
}
# Of one run of a dry scene: what the loader runs before main(), 140 when this was written, out of 30 million.
MOST_AT_LOADING = 400


def functions_of(objects):
    """Mangled names that the symbol tables define as code. Clones that the optimiser makes (name.part.0) count as the
    function."""
    said = subprocess.run(["nm", "--defined-only", *objects], check=True, capture_output=True, text=True).stdout
    return {line.split()[2].split(".")[0] for line in said.splitlines() if re.match(r"[0-9a-f]+ [tTwW] ", line)}


def water_functions():
    """Room -> names that no object outside the water's rooms defines."""
    objects = set(BUILD.glob("mpm/CMakeFiles/*.dir/*/*.o")) | set(BUILD.glob("mpm/CMakeFiles/*.dir/*.o"))
    of_room = {room: {one for pattern in patterns for one in BUILD.glob(f"mpm/CMakeFiles/*.dir/{pattern}")}
               for room, patterns in ROOMS.items()}
    elsewhere = functions_of(sorted(objects - set().union(*of_room.values())))
    return {room: functions_of(sorted(own)) - elsewhere for room, own in of_room.items()}


def counted(scene):
    """Instructions of every function (mangled, or as the loader has it) in a run of the scene, its callees left out."""
    with tempfile.TemporaryDirectory(prefix="wetfront_instructions_") as desk:
        out = pathlib.Path(desk, "counts")
        subprocess.run(["valgrind", "--tool=callgrind", "--demangle=no", f"--callgrind-out-file={out}",
                        BUILD / "mpm_instructions", scene], check=True, capture_output=True)
        text = out.read_text()
    names, counts, current, of_callee = {}, {}, "", False
    for line in text.splitlines():
        function = re.match(r"(c?)fn=(\(\d+\))(?: (.*))?$", line)
        if function:
            called, number, name = function.groups()
            if name:
                names[number] = re.sub(r"'\d+$", "", name).split(".")[0]  # name'2 is a recursion's second level
            if not called:
                current = names[number]
        elif line.startswith("calls="):
            of_callee = True  # the next line is what the callee cost
        elif re.match(r"[+*\-\d]", line):
            if not of_callee:
                counts[current] = counts.get(current, 0) + int(line.split()[1])
            of_callee = False
    return counts


class Instructions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.water = water_functions()

    def in_rooms(self, scene):
        counts = counted(scene)
        self.assertGreater(sum(counts.values()), 1e7, "a run of the scene is longer than that")
        spent = {room: sum(n for name, n in counts.items() if name in own) for room, own in self.water.items()}
        print(f"{scene}: {sum(counts.values())} instructions, in water kernels {spent}", flush=True)
        return counts, spent

    def test_a_dry_scene_executes_no_water_kernel(self):
        counts, spent = self.in_rooms("dry")
        every = set().union(*self.water.values())
        worst = sorted(((n, name) for name, n in counts.items() if name in every), reverse=True)[:10]
        self.assertLess(sum(spent.values()), MOST_AT_LOADING, worst)

    # The controls: the same names are found, and by far, where there is water.
    def test_seepage_is_seen(self):
        self.assertGreater(self.in_rooms("seepage")[1]["seepage"], 1e6)

    def test_two_velocities_are_seen(self):
        for scene in ("two_velocity_rigid", "two_velocity_deforming"):
            self.assertGreater(self.in_rooms(scene)[1]["two_velocity"], 1e6, scene)

    def test_water_that_moves_with_the_soil_is_seen(self):
        self.assertGreater(self.in_rooms("seepage_deforming")[1]["coupling"], 1e5)


if __name__ == "__main__":
    if shutil.which("valgrind") is None:
        print("skipped: valgrind is not installed (make deps, or apt-get install valgrind), so the instructions of a "
              "dry scene are not counted")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
