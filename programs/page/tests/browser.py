"""Headless Chromium and the command, for the tests of the pages.

The tests are told by the environment where things are: DISPLAYFILE is the command, PACKAGE the folder of the WebAssembly
package if the command does not find it, and SCREENSHOTS a folder for pictures of the pages, if they are wanted.
"""

import base64
import functools
import http.server
import os
import pathlib
import subprocess
import tempfile
import threading
import time
import unittest

import PIL.Image
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.support.select import Select

PROGRAMS = pathlib.Path(__file__).resolve().parents[2]
COMMAND = os.environ["DISPLAYFILE"]
SCREENSHOTS = os.environ.get("SCREENSHOTS")
LONGEST_WAIT = 60.0  # seconds, on a machine that does much else


def run(*words):
    """The command's standard output. Raises an AssertionError with its message if it fails."""
    done = subprocess.run([COMMAND, *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, words))}: {done.stderr}")
    return done.stdout


def make_page(page, *words):
    package = os.environ.get("PACKAGE")
    run("page", *words, "-o", page, *(["--package", package] if package else []))


def start_browser(width=1280, height=900, dark=False, arguments=()):
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                     f"--window-size={width},{height}", *arguments):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    browser.set_script_timeout(LONGEST_WAIT)
    set_window(browser, width, height, dark)
    return browser


def set_window(browser, width, height=900, dark=False):
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
    scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [scheme]})


def wait_for(found, what):
    """What `found()` gives as soon as it is something."""
    end = time.monotonic() + LONGEST_WAIT
    while time.monotonic() < end:
        result = found()
        if result:
            return result
        time.sleep(0.02)
    raise AssertionError(f"{what}: not there after {LONGEST_WAIT:.0f} seconds")


@functools.cache
def served(folder):
    """The address of a server of a folder."""
    handler = functools.partial(type("Quiet", (http.server.SimpleHTTPRequestHandler,), {"log_message": lambda *_: None}),
                                directory=str(folder))
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_address[1]}"


class PageTest(unittest.TestCase):
    """A test of pages in one browser, which must have nothing to say on its console at the end."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.downloads = cls.folder / "downloads"
        cls.downloads.mkdir()
        cls.browser = start_browser()
        cls.browser.execute_cdp_cmd("Browser.setDownloadBehavior",
                                    {"behavior": "allow", "downloadPath": str(cls.downloads)})

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.temporary.cleanup()

    def setUp(self):
        set_window(self.browser, 1280)
        self.browser.get_log("browser")

    def tearDown(self):
        self.assertEqual(self.browser.get_log("browser"), [])

    def open(self, address):
        """Opens a page, and waits until it is ready. Gives how long that took, in milliseconds."""
        self.browser.get("about:blank")
        self.browser.get(address)
        ready = "return document.documentElement.dataset.ready"
        return int(wait_for(lambda: self.browser.execute_script(ready), "the page"))

    def open_scene(self, *inputs):
        page = self.folder / "scene.html"
        make_page(page, *inputs)
        return self.open(page.as_uri())

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def at_rest(self):
        """Waits until what was asked for is drawn."""
        self.browser.execute_async_script("""
            const done = arguments[0];
            document.documentElement.viewer.redrawn().then(() => requestAnimationFrame(done), done);""")

    def choose(self, name, value):
        Select(self.find(f"select[id$='-{name}']")).select_by_value(value)
        self.at_rest()

    def status(self):
        return self.find(".status").text

    def picture(self):
        """The canvas's width and height, and its pixels in bytes."""
        width, height, pixels = self.browser.execute_script("""
            const canvas = document.querySelector('.picture canvas');
            const copy = new OffscreenCanvas(canvas.width, canvas.height);
            const context = copy.getContext('2d', { willReadFrequently: true });
            context.drawImage(canvas, 0, 0);
            const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
            let text = '';
            for (let k = 0; k < data.length; k += 8192) text += String.fromCharCode(...data.subarray(k, k + 8192));
            return [canvas.width, canvas.height, btoa(text)];""")
        return width, height, base64.b64decode(pixels)

    def pixels(self):
        return self.picture()[2]

    def size(self):
        return "{}x{}".format(*self.picture()[:2])

    def drawn(self, *words):
        """The pixels that the command draws in the canvas's size."""
        file = self.folder / "drawn.png"
        run("draw", *words, "-o", file, "--size", self.size(), "--quiet")
        return PIL.Image.open(file).convert("RGBA").tobytes()

    def drawn_as(self, extension, *words):
        file = self.folder / f"drawn.{extension}"
        run("draw", *words, "-o", file, "--size", self.size(), "--quiet")
        return file.read_bytes()

    def saved(self, words):
        """What the button saves, as a file."""
        for file in self.downloads.iterdir():
            file.unlink()
        self.browser.find_element(By.XPATH, f"//button[.='{words}']").click()

        def whole():
            # The browser holds the name with an empty file, and writes beside it.
            files = list(self.downloads.iterdir())
            return len(files) == 1 and files[0].suffix != ".crdownload" and files[0].stat().st_size > 0 and files

        return wait_for(whole, words)[0]
