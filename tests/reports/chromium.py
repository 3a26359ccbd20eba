"""Headless Chromium as the page tests use it."""

import json
import shutil
import tempfile

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service


def browser(program, desk, javascript=True):
    """Chromium with its console and its requests recorded, its profile in the folder `desk`."""
    found, driver = shutil.which(program), shutil.which("chromedriver")
    if not found or not driver:
        raise FileNotFoundError(f"{program} or chromedriver is missing: install chromium and chromium-driver")
    options = Options()
    options.binary_location = found
    profile = tempfile.mkdtemp(dir=desk)
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
