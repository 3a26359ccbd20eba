#!/usr/bin/python3
"""The documentation is built whole, and a link or heading that is not there stops it with its place."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(sys.argv.pop(1))


def make(source, out):
    return subprocess.run(["/usr/bin/python3", SOURCE / "docs" / "make_pages.py", source, out], capture_output=True, text=True)


class Documentation(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_the_project_is_whole(self):
        done = make(SOURCE, self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        theory = (self.folder / "docs" / "theory.html").read_text()
        self.assertIn("<table>", theory)
        self.assertTrue((self.folder / "mpm" / "README.html").exists())
        self.assertTrue(list((self.folder / "docs" / "gallery").glob("*.svg")), "pictures go along")

    def test_what_leads_nowhere_is_named(self):
        source = self.folder / "source"
        (source / "reports").mkdir(parents=True)
        (source / "reports" / "page.css").touch()
        (source / "a.md").write_text("# A title\n\n[b](b.md) [here](#a-title)\n[c](b.md#gone)\n[d](gone.md)\n")
        (source / "b.md").write_text("# B\n\n```\n# gone\n```\n")
        done = make(source, self.folder / "out")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout, "a.md:4: 'b.md' has no heading '#gone'\na.md:5: 'gone.md' leads nowhere\n")
        self.assertIn('href="b.html"', (self.folder / "out" / "a.html").read_text())


if __name__ == "__main__":
    unittest.main(verbosity=2)
