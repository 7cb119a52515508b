#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `l0_resample --page`, used in headless Chromium as a reader would:

  test_page_in_browser.py SOURCE_DIRECTORY PROGRAM SCRATCH

Points are drawn and turn with the mouse, colors and histograms change with the choice, and nothing
is asked of a network. Exit status 77 if Debian's chromium-driver or python3-selenium is missing.
"""

import shutil
import subprocess
import sys
from pathlib import Path

source, program, scratch = map(Path, sys.argv[1:])
sys.path.insert(0, str(source / "doc/L0_resampling/tools"))
import check_pages  # noqa: E402

# What of a picture is not white, how much of it is blue, red or gray, and a sum that tells pictures
# apart
LOOK = """
const canvas = document.getElementById(arguments[0]);
const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
const found = {drawn: 0, blue: 0, red: 0, gray: 0, sum: 0};
for (let i = 0; i < pixels.length; i += 4) {
  const [r, g, b] = pixels.subarray(i, i + 3);
  found.sum = (31 * found.sum + r + 7 * g + 11 * b) % 1000003;
  if (r + g + b == 765) continue;
  ++found.drawn;
  if (b > 1.5 * r) ++found.blue;
  else if (r > 2 * b && r > 2 * g) ++found.red;
  else if (r == g && g == b) ++found.gray;
}
found.drawn /= pixels.length / 4;
return found;
"""


# How many frames have been drawn once those are that are asked for
COUNT_FRAMES = """
const done = arguments[0];
requestAnimationFrame(() => requestAnimationFrame(() => done(document.body.dataset.frames)));
"""


def settled(driver):
    """Waits until a frame draws nothing, however slow the machine is."""
    frames = -1
    while frames != (frames := driver.execute_async_script(COUNT_FRAMES)):
        pass


def look(driver, canvas):
    settled(driver)
    return driver.execute_script(LOOK, canvas)


def check(driver):
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.support.ui import Select

    before = {name: look(driver, name) for name in ("input", "result")}
    for name, seen in before.items():
        assert 0.1 < seen["drawn"] < 0.9, f"{name}: {seen}"
    assert before["input"]["red"] > 20 and before["result"]["red"] == 0, before
    assert before["result"]["gray"] > 20 * before["result"]["blue"], "sides are wrong"

    canvas = driver.find_element(By.ID, "input")
    ActionChains(driver).drag_and_drop_by_offset(canvas, 120, 40).perform()
    turned = {name: look(driver, name) for name in before}
    for name, seen in turned.items():
        assert seen["sum"] != before[name]["sum"], f"{name} does not turn"
        assert 0.1 < seen["drawn"] < 0.9, f"{name}, turned: {seen}"
    driver.find_element(By.ID, "reset").click()
    assert {name: look(driver, name) for name in before} == before, "the view is another one"

    driver.find_element(By.ID, "left_out").click()
    assert look(driver, "input")["red"] == 0, "what is left out stays"

    choice = Select(driver.find_element(By.ID, "color"))
    titles = [option.text for option in choice.options]
    assert titles == ["by light", "feature confidence", "side confidence", "neighbor radius",
                      "noise", "position deviation", "normal deviation"], titles
    sums = {before["result"]["sum"]}
    for title in titles[1:]:
        choice.select_by_visible_text(title)
        sums.add(look(driver, "result")["sum"])
        bars = driver.find_elements(By.CSS_SELECTOR, "#value_histogram rect")
        assert len(bars) == 40, f"{title} has no histogram"
    assert len(sums) == len(titles), "two colors give the same picture"
    assert driver.find_elements(By.CSS_SELECTOR, "#left_out_histogram rect"), "nothing left out"
    assert len(driver.find_elements(By.CSS_SELECTOR, "#stages tr")) > 5, "no stages"
    facts = driver.find_element(By.ID, "facts").text
    assert "points of the result 3000" in facts and "left out as outliers 3" in facts, facts
    found = driver.execute_script(check_pages.LOOK)
    assert not found, found
    complaints = [entry["message"] for entry in driver.get_log("browser")
                  if "getImageData" not in entry["message"]]    # it is the test that reads pictures
    assert not complaints, complaints


def main():
    if check_pages.webdriver is None or not shutil.which("chromedriver"):
        print("skipped: needs chromium, chromium-driver and python3-selenium")
        return check_pages.SKIPPED
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    subprocess.run([program, source / "data/torus_noisy.ply", "torus.xyz", "--convert-only"],
                   cwd=scratch, check=True)
    with open(scratch / "torus.xyz", "a", encoding="ascii") as file:
        file.write("0 0 0\n0 0 1.5\n1.6 0 1.5\n")
    subprocess.run([program, "torus.xyz", "clean.ply", "--points", "3000", "--page", "page.html"],
                   cwd=scratch, check=True)
    driver = check_pages.browser()
    try:
        driver.get((scratch / "page.html").resolve().as_uri())
        check(driver)
        driver.save_screenshot(str(scratch / "page.png"))
    finally:
        driver.quit()
    return 0


if __name__ == "__main__":
    sys.exit(main())
