"""Installs the built tree into an empty folder and uses it there.

usage: install_test.py BUILD_FOLDER

Checks that the program starts, finds its library in the prefix and not in the build tree, checks and runs an installed
case; that every relative link of every installed page leads to something that was installed, and that every path in
back quotes in docs/ is one of the source tree.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

BUILD = sys.argv[1]
SOURCE = pathlib.Path(__file__).resolve().parents[1]
DESK = tempfile.TemporaryDirectory(prefix="wetfront_install_")
PREFIX = pathlib.Path(DESK.name, "prefix")


def said(*command, **options):
    return subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True, **options).stdout


class Installed(unittest.TestCase):
    program = PREFIX / "bin" / "wetfront"
    share = PREFIX / "share" / "wetfront"

    def test_the_program_starts_with_its_own_library(self):
        self.assertIn("wetfront ", said(self.program, "--version"))
        line = [line for line in said("ldd", self.program).splitlines() if "libwetfront_mpm" in line]
        self.assertEqual(len(line), 1)
        self.assertIn(str(PREFIX), line[0])

    def test_a_case_runs(self):
        scene = self.share / "verification" / "cases" / "dry_column" / "scene.toml"
        said(self.program, "check", scene)
        said(self.program, "run", scene, cwd=DESK.name)
        self.assertTrue(pathlib.Path(DESK.name, "out", "dry_column", "report.html").exists())

    def test_links_between_pages_hold(self):
        pages = sorted(self.share.rglob("*.md"))
        self.assertGreater(len(pages), 15)
        broken = []
        for page in pages:
            text = re.sub(r"```.*?```|`[^`]*`", "", page.read_text(encoding="utf-8"), flags=re.S)
            for link in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", text):
                if "://" not in link and not (page.parent / urllib.parse.unquote(link)).exists():
                    broken.append(f"{page.relative_to(self.share)}: {link}")
        self.assertEqual(broken, [])

    def test_paths_in_back_quotes_exist(self):
        """`mpm/plan/derive_effects.cpp`, `verification/scene/keys_*.cpp`, `translate/mpm_soil` (a pair of files)."""
        roots = [SOURCE, SOURCE / "verification", SOURCE / "mpm"]
        named, missing = 0, []
        for page in [SOURCE / "README.md", *sorted((SOURCE / "docs").glob("*.md"))]:
            for path in re.findall(r"`([\w.-]+(?:/[\w.*-]+)+/?)`", page.read_text(encoding="utf-8")):
                homes = [root for root in roots if (root / path.split("/")[0]).is_dir()]
                if not homes or path.startswith(("out/", "build/")):
                    continue  # made by the program, or no path of ours
                named += 1
                if not any([*root.glob(path), *root.glob(path + ".*")] for root in homes):
                    missing.append(f"{page.name}: {path}")
        self.assertEqual(missing, [])
        self.assertGreater(named, 12)


if __name__ == "__main__":
    said("cmake", "--install", BUILD, "--prefix", PREFIX)
    unittest.main(argv=sys.argv[:1], verbosity=2)
