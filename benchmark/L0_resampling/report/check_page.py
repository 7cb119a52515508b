#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens a report in headless Chromium and checks that its pictures are drawn, turn, zoom and change, and that its meshes are as small as its
selection asks for: check_page.py PAGE.html SCREENSHOT.png

Exit status 77 if Debian's chromium-driver or python3-selenium is not installed, or what the page needs, so that there is none.
"""

import json
import shutil
import sys
import time
from pathlib import Path

from selections import SELECTIONS

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
except ImportError:
    webdriver = None

SKIPPED = 77
TIME_LIMIT = 240    # seconds after which the browser counts as hung; a busy machine is slow

# How many pixels of a canvas are drawn, and a sum that changes with the picture
LOOK = """
const data = arguments[0].getContext("2d").getImageData(0, 0, arguments[0].width, arguments[0].height).data;
let drawn = 0, sum = 0;
for (let i = 0; i < data.length; i += 4)
  if (data[i + 3] && data[i] + data[i + 1] + data[i + 2] < 720) {
    ++drawn;
    sum = (31 * sum + i + data[i] + 7 * data[i + 1] + 13 * data[i + 2]) % 1000000007;
  }
return [drawn, sum];
"""

# Triangles of each mesh
MESH_SIZES = """
const scenes = JSON.parse(document.getElementById(arguments[0]).textContent).scenes;
return scenes.filter(scene => scene.mesh).map(scene => scene.mesh.triangles);
"""


def browser():
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--window-size=1200,1000", "--use-angle=swiftshader",
                     "--enable-unsafe-swiftshader", "--force-device-scale-factor=1"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    driver.set_script_timeout(TIME_LIMIT)
    return driver


class Page:
    def __init__(self, driver, path):
        self.driver = driver
        self.selection = SELECTIONS[json.loads(path.with_suffix(".json").read_text(encoding="utf-8"))["selection"]]
        driver.get(path.resolve().as_uri())

    def wait_until(self, condition, what):
        end = time.monotonic() + TIME_LIMIT
        while not condition():
            if time.monotonic() > end:
                raise AssertionError(f"{what}: not within {TIME_LIMIT} seconds")
            time.sleep(0.1)

    def look(self, canvas):
        return tuple(self.driver.execute_script(LOOK, canvas))

    def check_figure(self, figure):
        """All pictures of a figure are drawn, and follow what is done to the first."""
        name = figure.get_attribute("data-figure")
        self.driver.execute_script("arguments[0].scrollIntoView({block: 'start'})", figure)
        self.wait_until(lambda: figure.get_attribute("data-state") == "shown", f"{name} is shown")
        canvases = figure.find_elements(By.TAG_NAME, "canvas")
        assert canvases, f"{name} has no pictures"
        sizes = sorted(self.driver.execute_script(MESH_SIZES, name))
        # A mesh of many small closed parts, as of a thin plate whose sides are mixed, cannot be made so coarse.
        assert not sizes or sizes[len(sizes) // 2] <= self.selection.picture_triangles, f"{name} has meshes of {sizes} triangles"
        first = [self.look(canvas) for canvas in canvases]
        for canvas, (drawn, _) in zip(canvases, first):
            pixels = int(canvas.get_attribute("width")) * int(canvas.get_attribute("height"))
            assert 500 < drawn < 0.9 * pixels, f"{name}: a picture is empty"

        def all_changed(before):
            return lambda: all(self.look(canvas) != seen for canvas, seen in zip(canvases, before))

        ActionChains(self.driver).drag_and_drop_by_offset(canvases[0], 60, 20).perform()
        self.wait_until(all_changed(first), f"{name}: all pictures turn")
        turned = [self.look(canvas) for canvas in canvases]
        self.driver.execute_script("arguments[0].dispatchEvent(new WheelEvent('wheel', {deltaY: -300, bubbles: true, cancelable: true}))", canvases[-1])
        self.wait_until(all_changed(turned), f"{name}: all pictures zoom")
        zoomed = [self.look(canvas) for canvas in canvases]
        for button in figure.find_elements(By.TAG_NAME, "button")[1:]:
            button.click()
            # Points whose normals contradict each other have no mesh: their picture stays as it is.
            self.wait_until(lambda: any(self.look(canvas) != seen for canvas, seen in zip(canvases, zoomed)), f"{name}: {button.text} is shown")
            assert all(self.look(canvas)[0] > 500 for canvas in canvases), f"{name}: {button.text} is empty"
            zoomed = [self.look(canvas) for canvas in canvases]
        return len(canvases)

    def check(self):
        figures = self.driver.find_elements(By.CLASS_NAME, "scenes")
        assert figures, "the page has no figures"
        count = sum(self.check_figure(figure) for figure in figures)
        errors = [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]
        assert not errors, f"the browser says: {errors}"
        for tag in ("link[href]", "script[src]", "img[src^='http']"):
            assert not self.driver.find_elements(By.CSS_SELECTOR, tag), f"the page is not self-contained: {tag}"
        return len(figures), count


def main():
    if webdriver is None or not shutil.which("chromedriver"):
        print("skipped: needs chromium, chromium-driver and python3-selenium")
        return SKIPPED
    if not Path(sys.argv[1]).exists():
        print("skipped: there is no page")
        return SKIPPED
    driver = browser()
    try:
        page = Page(driver, Path(sys.argv[1]))
        figures, pictures = page.check()
        driver.save_screenshot(sys.argv[2])
    except AssertionError as error:
        driver.save_screenshot(sys.argv[2])
        print(f"check_page.py: {error}; see {sys.argv[2]}", file=sys.stderr)
        return 1
    finally:
        driver.quit()
    print(f"{figures} figures with {pictures} pictures are drawn, turn and zoom")
    return 0


if __name__ == "__main__":
    sys.exit(main())
