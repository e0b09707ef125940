"""How fast the app's page is in Chromium: the first picture, a slider's change, a frame of the animation.

`python benchmarks/page.py` starts a server of its own on the loopback, warms it, and prints medians.
"""

from __future__ import annotations

import argparse
import shutil
import statistics
import threading
import time
from itertools import pairwise

from playwright.sync_api import Browser, Page, sync_playwright

from stayput.app.server import address_of, bind, create_app, server_of

FLAGS = ["--no-sandbox"]
FRAMES = """() => new Promise(done => {
  const stamps = [];
  const tick = stamp => {
    stamps.push(stamp);
    if (stamps.length < 121) requestAnimationFrame(tick); else done(stamps);
  };
  requestAnimationFrame(tick);
})"""
DRAWN = """() => new Promise(done => {
  const seen = document.documentElement.dataset.drawn, began = performance.now();
  const fields = [...document.querySelectorAll("input[type=range]")];
  const field = fields.find(one => one.labels[0]?.textContent === "Height");
  field.value = field.value === "180" ? "170" : "180";
  field.dispatchEvent(new Event("input", { bubbles: true }));
  const look = () => {
    if (document.documentElement.dataset.drawn === seen) setTimeout(look, 1);
    else requestAnimationFrame(() => done(performance.now() - began));
  };
  look();
})"""
SIZES = "() => performance.getEntriesByType('resource').map(one => one.encodedBodySize)"
COST = """() => import("/see.js").then(({ clock }) => {
  const original = window.requestAnimationFrame, spent = [];
  window.requestAnimationFrame = work => original(stamp => {
    const began = performance.now();
    work(stamp);
    spent.push(performance.now() - began);
  });
  clock.play(true);
  return new Promise(done => setTimeout(() => {
    window.requestAnimationFrame = original;
    done(spent.slice(5));
  }, 2000));
})"""


def opened(browser: Browser, address: str, *, verify: bool) -> tuple[Page, float]:
    page = browser.new_page(viewport={"width": 1280, "height": 900}, locale="en-GB")
    if not verify:
        page.route("**/verify", lambda route: None)
    page.goto(address)
    page.wait_for_selector("html[data-drawn]", state="attached")
    return page, float(page.get_attribute("html", "data-drawn") or "nan")


def told(name: str, values: list[float], unit: str = "ms") -> None:
    ordered = sorted(values)
    high = ordered[min(len(ordered) - 1, int(0.95 * len(ordered)))]
    print(
        f"{name:<58} {statistics.median(ordered):8.1f} {unit} (95 %: {high:.1f}, largest {ordered[-1]:.1f})"
    )


def measure(browser: Browser, address: str, times: int) -> None:
    first = []
    for _ in range(times):
        page, drawn = opened(browser, address, verify=False)
        first.append(drawn)
        sizes = page.evaluate(SIZES)
        page.close()
    told("first picture after opening the page", first)
    print(
        f"{'requests until then':<58} {len(sizes):8d}, {sum(sizes) / 1024:.0f} KiB, "
        f"of which the runs {max(sizes) / 1024:.0f}"
    )
    page, _ = opened(browser, address, verify=False)
    told("a slider's change until both runs are drawn anew", [page.evaluate(DRAWN) for _ in range(5 * times)])
    spent = page.evaluate(COST)
    told("script for a frame: two runs and the histories", spent)
    stamps = page.evaluate(FRAMES)
    told("from frame to frame while it plays", [b - a for a, b in pairwise(stamps)])
    page.close()
    began = time.perf_counter()
    page, _ = opened(browser, address, verify=True)
    page.wait_for_selector("#verdict .sentence", timeout=120_000)
    print(f"{'first chances after opening the page':<58} {time.perf_counter() - began:8.1f} s")
    page.wait_for_selector("#understand[data-state=done]", timeout=300_000)
    print(f"{'ranking and curves after opening the page':<58} {time.perf_counter() - began:8.1f} s")
    page.click("#verify")
    page.wait_for_selector("#verdict .sentence")
    told("a slider's change while a verification runs", [page.evaluate(DRAWN) for _ in range(times)])
    page.close()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--times", type=int, default=7, help="how often the page is opened")
    times: int = parser.parse_args().times
    bound = bind("127.0.0.1", 0)
    app = create_app()
    server = server_of(app)
    thread = threading.Thread(target=lambda: server.run(sockets=[bound]), daemon=True)
    thread.start()
    while not (server.started and app.state.service.ready):
        time.sleep(0.05)
    path = shutil.which("chromium") or shutil.which("google-chrome")
    with (
        sync_playwright() as playwright,
        playwright.chromium.launch(executable_path=path, args=FLAGS) as browser,
    ):
        print(f"Chromium {browser.version}, {address_of(bound)}")
        measure(browser, address_of(bound), times)
    server.should_exit = True
    thread.join(10.0)


if __name__ == "__main__":
    main()
