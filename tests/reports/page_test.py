"""Opens the sample report and its index in headless Chromium, as a reader would from disk.

usage: page_test.py REPORTS_SAMPLE [CHROMIUM]

Checks that the page asks the network for nothing and says nothing on the console; that with JavaScript off the verdict
table, every figure and every section are there and visible; that with it on the pointer shows values that stand in the
data, that dragging zooms and a double click restores; that the index leads to the reports. Fails without Chromium.
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By

SAMPLE = sys.argv[1]
CHROMIUM = sys.argv[2] if len(sys.argv) > 2 else "chromium"
DESK = tempfile.TemporaryDirectory(prefix="wetfront_page_", ignore_cleanup_errors=True)
PAGES = pathlib.Path(DESK.name, "pages")


def browser(javascript):
    program, driver = shutil.which(CHROMIUM), shutil.which("chromedriver")
    if not program or not driver:
        raise FileNotFoundError(f"{CHROMIUM} or chromedriver is missing: install chromium and chromium-driver")
    options = Options()
    options.binary_location = program
    profile = tempfile.mkdtemp(dir=DESK.name)
    for flag in ("headless=new", "no-sandbox", "disable-gpu", "disable-background-networking", "no-first-run",
                 "disable-dev-shm-usage", "window-size=1280,1000", f"user-data-dir={profile}"):
        options.add_argument("--" + flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    if not javascript:
        options.add_experimental_option("prefs", {"profile.managed_default_content_settings.javascript": 2})
    return webdriver.Chrome(options=options, service=Service(driver))


def requests(chromium):
    messages = [json.loads(entry["message"])["message"] for entry in chromium.get_log("performance")]
    return [m["params"]["request"]["url"] for m in messages if m["method"] == "Network.requestWillBeSent"]


class Page:
    """A browser per class, the report opened afresh for each test."""

    @classmethod
    def setUpClass(cls):
        cls.chromium = browser(cls.javascript)
        cls.addClassCleanup(cls.chromium.quit)

    def setUp(self):
        self.chromium.get("about:blank")
        for kind in ("performance", "browser"):
            self.chromium.get_log(kind)  # what was said until here, by Chromium itself or in another test
        self.open(PAGES / "seed_column" / "report.html")

    def open(self, path):
        self.chromium.get(path.as_uri())

    def all(self, selector):
        return self.chromium.find_elements(By.CSS_SELECTOR, selector)

    def only(self, selector):
        found = self.all(selector)
        self.assertEqual(len(found), 1, selector)
        return found[0]


class WithoutJavaScript(Page, unittest.TestCase):
    javascript = False

    def test_nothing_is_missing(self):
        result = json.loads((PAGES / "seed_column" / "result.json").read_text(encoding="utf-8"))
        self.assertTrue(self.only("#verdict-table").is_displayed())
        gated = [finding for finding in result["findings"] if finding["verdict"] != "info"]
        self.assertEqual(len(self.all("#verdict-table tbody tr:not(.group)")), len(gated))
        self.only("details.shown-only summary").click()  # what decides nothing is folded away; no script opens it
        rows = self.all("table.verdicts tbody tr:not(.group)")
        self.assertEqual(len(rows), len(result["findings"]))
        shown = " ".join(row.text.replace("\u00a0", " ") for row in rows)
        for finding in result["findings"]:
            self.assertIn(finding["verdict"].upper(), shown)
            self.assertIn(finding["reason"], shown)
            self.assertIn(finding["description"], shown)
        for row in rows:
            self.assertTrue(row.is_displayed())
        for figure in result["figures"]:
            drawing = self.only(f"#figure-{figure['id']} svg")
            self.assertTrue(drawing.is_displayed())
            self.assertGreater(drawing.size["height"], 200)
            self.assertIn(figure["title"], drawing.text)
            for series in figure["series"]:
                self.assertIn(series["label"], drawing.text)
        for section in ("Profiles", "Time series", "Flux audit", "Cost", "Effects plan", "Set-up", "Log", "Scene",
                        "Provenance"):
            self.assertIn(section, [heading.text for heading in self.all("h2") if heading.is_displayed()])
        self.assertIn(result["scene"]["text"].split("\n")[0], self.only("#section-scene").text)
        self.assertEqual(self.all(".overlay"), [], "the script ran although JavaScript is off")

    def test_ids_are_unique(self):
        ids = [element.get_attribute("id") for element in self.all("[id]")]
        self.assertEqual(len(ids), len(set(ids)))


class WithJavaScript(Page, unittest.TestCase):
    javascript = True

    def test_no_request_and_no_complaint(self):
        self.only("#figure-pressure_profiles .overlay")
        asked = requests(self.chromium)
        self.assertTrue(asked, "the log of requests is not working")
        self.assertEqual([url for url in asked if not url.startswith(("file://", "data:"))], [])
        self.assertEqual([url for url in asked if url.startswith("file://")],
                         [(PAGES / "seed_column" / "report.html").as_uri()])
        self.assertEqual(self.chromium.get_log("browser"), [])

    def test_the_complaints_would_be_seen(self):
        broken = PAGES / "broken.html"
        broken.write_text("<script>nothing.here()</script><img src='http://127.0.0.1:9/x.png'>")
        self.open(broken)
        self.assertTrue(self.chromium.get_log("browser"))
        self.assertIn("http://127.0.0.1:9/x.png", requests(self.chromium))

    def point(self, figure, series, index):
        """Moves the pointer onto a datum, by the geometry that the page itself states."""
        drawing = self.only(f"#figure-{figure} svg")
        self.chromium.execute_script("arguments[0].scrollIntoView({block: 'center'})", drawing)
        data = json.loads(self.only(f"#figure-{figure} script").get_attribute("textContent"))
        datum = [data["series"][series][axis][index] for axis in "xy"]
        left, top, right, bottom = data["box"]
        share = [(v - data[a]["from"]) / (data[a]["to"] - data[a]["from"]) for v, a in zip(datum, "xy")]
        width = float(drawing.get_dom_attribute("viewBox").split()[2])
        height = float(drawing.get_dom_attribute("viewBox").split()[3])
        scale = drawing.size["width"] / width
        x = (left + share[0] * (right - left) - width / 2) * scale
        y = (bottom - share[1] * (bottom - top) - height / 2) * scale
        ActionChains(self.chromium).move_to_element_with_offset(drawing, round(x), round(y)).perform()
        return data["series"][series]["label"], datum

    def test_the_pointer_shows_the_datum(self):
        label, datum = self.point("probe_pressure", 1, 5)
        text = self.only(".tip").text.replace("\u2212", "-").replace("\u00a0", " ")
        self.assertEqual(text, f"{label}\ntime {float(f'{datum[0]:.5g}'):g} s\npore pressure {float(f'{datum[1]:.5g}'):.5g} kPa")
        # The ring lies on gnuplot's own mark: the page's geometry and the drawing agree within half a pixel.
        ring = self.only(".overlay circle").rect
        centre = [ring["x"] + ring["width"] / 2, ring["y"] + ring["height"] / 2]
        marks = [m.rect for m in self.all("#figure-probe_pressure use[transform]")]
        nearest = min(((m["x"] + m["width"] / 2 - centre[0]) ** 2 + (m["y"] + m["height"] / 2 - centre[1]) ** 2) for m in marks)
        self.assertLess(nearest, 0.25)

    def test_dragging_zooms_and_a_double_click_restores(self):
        drawing = self.only("#figure-water_ledger svg")
        self.chromium.execute_script("arguments[0].scrollIntoView({block: 'center'})", drawing)
        ActionChains(self.chromium).move_to_element_with_offset(drawing, -40, -40).click_and_hold().move_by_offset(
            120, 80).release().perform()
        self.only("#figure-water_ledger .zoomed")
        self.assertTrue(self.only("#figure-water_ledger .back").is_displayed())
        ActionChains(self.chromium).double_click(drawing).perform()
        self.assertEqual(self.all(".zoomed"), [])
        self.assertEqual(self.chromium.get_log("browser"), [])

    def test_the_index_leads_to_the_reports(self):
        self.open(PAGES / "index.html")
        self.assertTrue(self.only(".matrix").is_displayed())
        links = [link.get_attribute("href") for link in self.all(".matrix a")]
        self.assertEqual(len(links), 3)
        for link in links:
            self.chromium.get(link)
            self.assertTrue(self.all("table.verdicts"))
        self.assertEqual(self.chromium.get_log("browser"), [])


if __name__ == "__main__":
    subprocess.run([SAMPLE, str(PAGES)], check=True)
    unittest.main(argv=sys.argv[:1], verbosity=2)
