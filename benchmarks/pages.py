"""The built book in a browser: weight of its pages, time to a working explorer, frame times.

Frames are measured while the pointer drags λ in the explorer of the
figure eight at order 60, with software rendering; a screen of 60 Hz gives one every 16.7 ms.
"""

import os
import shutil
import statistics
import time
from pathlib import Path

from browser.pages import Explorer, served
from playwright.sync_api import sync_playwright

BUILT = Path(__file__).parents[1] / "_build" / "html"
WIDGETS, PLAIN = "book/figure_eight.html", "book/notation.html"
FRAMES = """() => {
    window.frames_ = [];
    let last;
    const step = now => { if (last) window.frames_.push(now - last); last = now;
                          requestAnimationFrame(step); };
    requestAnimationFrame(step);
}"""


def measure(repeats=5):
    """``{quantity: text}``; empty where no browser is installed."""
    path = os.environ.get("CHROMIUM") or shutil.which("chromium")
    if path is None:
        return {}
    found = {}
    with served(BUILT) as home, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=path, args=["--no-sandbox", "--disable-gpu"])
        for name, kind in ((WIDGETS, "with an explorer"), (PLAIN, "without")):
            found[f"what a page loads, {kind}"] = visit(browser, f"{home}/{name}")
        waits = sorted(opening(browser, f"{home}/{WIDGETS}") for _ in range(repeats))
        found["from opening a page to a working explorer"] = (
            f"{statistics.median(waits):.1f} s ({waits[0]:.1f} to {waits[-1]:.1f})")
        frames = sorted(dragging(browser, f"{home}/{WIDGETS}"))
        found["one frame while λ is dragged, order 60"] = (
            f"median {statistics.median(frames):.1f} ms, "
            f"95th percentile {frames[int(0.95 * len(frames))]:.1f} ms")
        browser.close()
    return found


def visit(browser, url):
    """Megabytes and number of files that a page loads, the first time."""
    page = browser.new_page()
    sizes = []
    page.on("response", lambda response: sizes.append(int(response.headers["content-length"])))
    page.goto(url, wait_until="networkidle")
    page.close()
    return f"{sum(sizes) / 1e6:.1f} MB in {len(sizes)} files"


def opening(browser, url):
    page = browser.new_page()
    start = time.perf_counter()
    page.goto(url, wait_until="commit")
    page.locator(".ft-explorer .ft-status:not(:empty)").first.wait_for()
    wait = time.perf_counter() - start
    page.close()
    return wait


def dragging(browser, url, moves=240):
    page = browser.new_page(viewport={"width": 1200, "height": 900})
    page.goto(url)
    shown = Explorer(page, 0)
    shown.type("order", 60)
    handle = page.get_by_role("slider", name="λ", exact=True)
    track = shown.box.locator(".noUi-target").filter(has=handle).bounding_box()
    grip, middle = handle.bounding_box(), track["y"] + track["height"] / 2
    page.mouse.move(grip["x"] + grip["width"] / 2, middle)
    page.mouse.down()
    page.evaluate(FRAMES)
    for k in range(moves):
        page.mouse.move(track["x"] + track["width"] * (0.1 + 0.8 * (k % 60) / 60), middle)
    frames = page.evaluate("window.frames_")
    page.mouse.up()
    page.close()
    return frames

