"""How long a frame takes in Chromium while a figure turns, in those of the command: ratios of medians, measured in turn.

    DISPLAYFILE=... [PACKAGE=...] frame_figures.py SCENE... [--rounds N] [--side PIXELS]

A frame in the page goes from a turn to the pixels on the canvas: the worker's drawing, the way there and back, and
putting them. The command's is that of a turntable of the same size, written as PPM: the difference of one with many
views and one with a single view, by one thread.
"""

import argparse
import pathlib
import statistics
import tempfile
import time

from browser import make_page, run, set_window, start_browser, wait_for

TURNS = 40
MARGINS = (440, 170)  # what stands beside the picture, and above and below it

TURN = """
    const [turns, done] = arguments;
    const viewer = document.documentElement.viewer;
    (async () => {
      const times = [];
      for (let k = 0; k < turns; ++k) {
        const begin = performance.now();
        viewer.turn(2 * Math.PI / turns, 0);
        await viewer.drawn();
        times.push([performance.now() - begin, viewer.picture.milliseconds]);
      }
      viewer.rest();
      done(times);
    })();"""


def frames_in_page(browser):
    times = browser.execute_async_script(TURN, TURNS)
    return [statistics.median(column) for column in zip(*times)]


def frame_of_command(scene, size, folder):

    def whole(views):
        begin = time.perf_counter()
        run("draw", scene, "-o", folder / "turn.ppm", "--size", size, "--turntable", views, "--hidden", "z-buffer",
            "--samples", 1, "--threads", 1, "--quiet")
        return 1000 * (time.perf_counter() - begin)

    return (whole(TURNS + 1) - whole(1)) / TURNS


def measure(scene, side, rounds):
    with tempfile.TemporaryDirectory(dir="/dev/shm") as name:
        folder = pathlib.Path(name)
        page = folder / "scene.html"
        make_page(page, scene)
        browser = start_browser()
        try:
            set_window(browser, side + MARGINS[0], side + MARGINS[1])
            browser.get(page.as_uri())
            ready = "return document.documentElement.dataset.ready"
            wait_for(lambda: browser.execute_script(ready), "the page")
            size = browser.execute_script("const { width, height } = document.documentElement.viewer.size;"
                                          "return `${width}x${height}`;")
            frames_in_page(browser)  # for the browser, which compiles anew what is called often
            whole, drawing = [], []
            for _ in range(rounds):
                native = frame_of_command(scene, size, folder)
                frame, drawn = frames_in_page(browser)
                whole.append(frame / native)
                drawing.append(drawn / native)
        finally:
            browser.quit()
    print(f"{scene.name} at {size}: a frame in the page takes {statistics.median(whole):.2f} times as long as the "
          f"command's ({min(whole):.2f} to {max(whole):.2f}); its drawing alone {statistics.median(drawing):.2f}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--side", type=int, default=1024)
    words = parser.parse_args()
    for scene in words.scenes:
        measure(scene, words.side, words.rounds)


if __name__ == "__main__":
    main()
