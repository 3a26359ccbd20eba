"""Opens pages that the program itself has made in headless Chromium: a comparison with another code's result, a study of
effects, a slope that slides.

usage: real_pages_test.py WETFRONT SOURCE_DIR [CHROMIUM]

Each is checked for its sections, for what it asks the network and says on the console, for its width on a phone and for
the files that its drawings link to. Fails without Chromium.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from chromium import browser, requests
from selenium.webdriver.common.by import By

WETFRONT, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
CHROMIUM = sys.argv[3] if len(sys.argv) > 3 else "chromium"
DESK = tempfile.TemporaryDirectory(prefix="wetfront_real_pages_", ignore_cleanup_errors=True)
CASES = SOURCE / "verification" / "cases"


def made(name, *arguments):
    """Runs the program; a verdict other than PASS is no concern of this test, bad input and giving up are."""
    folder = pathlib.Path(DESK.name, name)
    done = subprocess.run([WETFRONT, *map(str, arguments), "--out", str(folder)], cwd=DESK.name, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode not in (0, 1, 4):
        raise RuntimeError(f"{name}: exit code {done.returncode}\n{done.stdout}")
    return folder / "report.html"


class RealPages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.chromium = browser(CHROMIUM, DESK.name)
        cls.addClassCleanup(cls.chromium.quit)

    def all(self, selector):
        return self.chromium.find_elements(By.CSS_SELECTOR, selector)

    def check(self, page, sections):
        self.chromium.get("about:blank")
        for kind in ("performance", "browser"):
            self.chromium.get_log(kind)
        self.chromium.get(page.as_uri())
        asked = requests(self.chromium)
        self.assertTrue(asked, "the log of requests is not working")
        self.assertEqual([url for url in asked if not url.startswith("data:")], [page.as_uri()])
        headings = [heading.text for heading in self.all("h2") if heading.is_displayed()]
        for section in sections:
            self.assertIn(section, headings)
        for figure in self.all("figure"):
            self.assertGreater(figure.find_element(By.CSS_SELECTOR, "svg").size["height"], 20)
            links = [link.get_dom_attribute("href") for link in figure.find_elements(By.CSS_SELECTOR, ".files a")]
            self.assertTrue(links, figure.get_attribute("id"))
            for link in links:
                self.assertTrue((page.parent / link).is_file(), link)
        self.chromium.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                      {"width": 390, "height": 844, "deviceScaleFactor": 2, "mobile": True})
        try:
            self.chromium.get(page.as_uri())
            self.assertEqual(self.chromium.execute_script("return window.innerWidth"), 390)
            self.assertLessEqual(self.chromium.execute_script("return document.documentElement.scrollWidth"), 390)
        finally:
            self.chromium.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        self.assertEqual(self.chromium.get_log("browser"), [])

    def test_another_codes_result(self):
        case = CASES / "foreign_infiltration"
        self.check(made("compare", "compare", case / "scene.toml", case / "anura3d.result"),
                   ["Verdicts", "Profiles", "Flux audit", "Difference ledger", "Set-up", "Log", "Scene", "Provenance"])

    def test_a_study(self):
        # A long path and a long title, as users have them, must not widen the page.
        folder = pathlib.Path(DESK.name, "a_folder_with_a_rather_long_name_that_cannot_be_broken_anywhere")
        folder.mkdir()
        text = (CASES / "seed_column" / "scene_7.5e-5.toml").read_text(encoding="utf-8")
        scene = folder / "column.toml"
        scene.write_text(text.replace("cells = 40", "cells = 10"), encoding="utf-8")
        self.check(made("vary", "study", "vary", scene, "--set", "rain.intensity=5e-5,7.5e-5", "--jobs", "1"),
                   ["Verdicts", "Outcomes", "Scene", "Provenance"])
        self.check(made("accuracy", "study", "accuracy", scene, "--budget", "0.05", "--jobs", "1"),
                   ["Verdicts", "Settings", "Cost", "Scene"])

    def test_a_slope_that_slides(self):
        self.check(made("slope", "run", CASES / "small_slope" / "scene.toml", "--set", "geometry.profile.cells_over=2",
                        "--set", "geometry.profile.cells_along=12"),
                   ["Motion", "Verdicts", "The slide", "Flux audit", "Energy and momentum", "Cost", "Effects plan",
                    "Set-up", "Scene"])
        self.assertTrue(self.all(".film .player"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
