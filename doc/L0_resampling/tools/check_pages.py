#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens every page of the manual in headless Chromium and looks for what a reader would stumble
over: check_pages.py HTML_DIRECTORY [SCREENSHOT_DIRECTORY]

- a formula that MathJax cannot draw, or has not drawn;
- a picture that is not there;
- a command of Doxygen, an alias, an entity of HTML or the stars of bold words that stand in the
  text;
- something wider than the page, a list without entries, or a name in a list that is broken into
  many lines;
- a link to a place that does not exist;
- a script, picture or style that is asked of a network, which the browser has none of.

With SCREENSHOT_DIRECTORY, a picture of each page lies there for people to look at.
Exit status 77 if Debian's chromium-driver or python3-selenium is not installed.
"""

import shutil
import sys
import time
from pathlib import Path

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
except ImportError:
    webdriver = None

SKIPPED = 77
TIME_LIMIT = 240    # seconds after which a page counts as hung; a busy machine is slow
WIDTH = 1280

IS_READY = """
const hub = window.MathJax && window.MathJax.Hub;
return document.readyState == "complete"
       && (hub ? window.MathJax.isReady && !hub.queue.pending && !hub.queue.running
               : !document.querySelector("script[src*='MathJax.js']"));
"""

# What is wrong with the page that is shown. Code may hold backslashes, and may be scrolled.
LOOK = r"""
const found = [];
const content = document.getElementById("doc-content") || document.body;
for (const formula of content.querySelectorAll(".merror, .MathJax_Error, [data-mjx-error]"))
  found.push("a formula is not drawn: " + formula.textContent);
for (const text of content.querySelectorAll("text"))
  if (/Undefined control sequence|Misplaced|Missing|Unknown|Extra /.test(text.textContent))
    found.push("a formula is not drawn: " + text.textContent);
for (const picture of content.querySelectorAll("img"))
  if (!picture.complete || picture.naturalWidth == 0)
    found.push("a picture is not there: " + picture.getAttribute("src"));
for (const wide of content.querySelectorAll("p, li, table, img, .l0Figure, svg"))
  if (wide.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
    found.push("wider than the page: " + wide.tagName + " " + wide.textContent.trim().slice(0, 60));
for (const list of content.querySelectorAll(".directory"))
  if (!list.querySelector("td.entry"))
    found.push("a list has no entries");
for (const name of content.querySelectorAll(".directory td.entry a.el"))
  if (name.getBoundingClientRect().height > 60)
    found.push("a name has many lines: " + name.textContent);
for (const resource of performance.getEntriesByType("resource"))
  if (!/^(file|data|blob):/.test(resource.name))
    found.push("asks a network for " + resource.name);
for (const entity of content.innerText.match(/&(?:#\d+|amp|lt|gt|quot|nbsp);/g) || [])
  found.push("an entity stands in the text: " + entity);
const code_and_formulas = "code, .fragment, pre, script, style, "
                          + ".MathJax_Preview, .MathJax_SVG, .MathJax_SVG_Display";
for (const code of content.querySelectorAll(code_and_formulas))
  code.remove();
const text = content.textContent;
const commands = new RegExp("[\\\\@](?:cgal|l0|ref|cite|snippet|default_|lor_|constant_|quality_"
                            + "|speed_|solver_|f\\$|f\\[)\\w*", "g");
for (const command of text.match(commands) || [])
  found.push("a command stands in the text: " + command);
for (const words of text.match(/.{0,30}\*\*.{0,30}/g) || [])
  found.push("stars stand in the text: " + words);
return found;
"""

LINKS = """
const places = [...document.querySelectorAll("[id], a[name]")];
return [places.flatMap(e => [e.id, e.getAttribute("name")]),
        [...document.querySelectorAll("a[href]")].map(a => a.href)];
"""


def browser():
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
                     "--host-resolver-rules=MAP * ~NOTFOUND",   # there is no network
                     f"--window-size={WIDTH},1000", "--force-device-scale-factor=1"):
        options.add_argument(argument)
    driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    driver.set_script_timeout(TIME_LIMIT)
    return driver


def open_page(driver, page):
    driver.get(page.resolve().as_uri())
    end = time.monotonic() + TIME_LIMIT
    while not driver.execute_script(IS_READY):
        if time.monotonic() > end:
            raise TimeoutError(f"{page.name}: its formulas are not drawn within {TIME_LIMIT} "
                               "seconds")
        time.sleep(0.1)


def take_screenshot(driver, path):
    """Of the page as a whole, which Doxygen puts into a pane that scrolls."""
    height = driver.execute_script("""
      const content = document.getElementById("doc-content");
      if (content) content.style.height = "auto";
      return (content || document.body).scrollHeight;""")
    driver.set_window_size(WIDTH, height + 400)
    driver.save_screenshot(str(path))
    driver.set_window_size(WIDTH, 1000)


def main():
    if webdriver is None or not shutil.which("chromedriver"):
        print("skipped: needs chromium, chromium-driver and python3-selenium")
        return SKIPPED
    pages = sorted(Path(sys.argv[1]).glob("*.html"))
    errors, places, links = [], {}, []
    driver = browser()
    try:
        for page in pages:
            open_page(driver, page)
            names, targets = driver.execute_script(LINKS)
            places[page.resolve().as_uri()] = set(names)
            links += [(page.name, target) for target in targets]
            if len(sys.argv) > 2:
                Path(sys.argv[2]).mkdir(parents=True, exist_ok=True)
                take_screenshot(driver, Path(sys.argv[2]) / f"{page.stem}.png")
            errors += [f"{page.name}: {what}" for what in driver.execute_script(LOOK)]
    finally:
        driver.quit()
    for name, target in links:
        address, _, place = target.partition("#")
        if address.startswith("file:") and (address not in places
                                            or (place and place not in places[address])):
            errors.append(f"{name}: nothing is at {target.rpartition('/')[2]}")
    for error in errors:
        print("check_pages:", error, file=sys.stderr)
    print(f"{len(pages)} pages, {len(links)} links")
    return 1 if errors or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
