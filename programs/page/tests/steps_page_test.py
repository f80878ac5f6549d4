"""The page of an algorithm's steps (displayfile steps), from disk."""

import json
import struct
import unittest

from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from browser import PROGRAMS, PageTest, run, set_window, wait_for

SURFACES = ["bsp", "depth-sort", "z-buffer", "scan-line", "scan-line-z", "warnock", "ray-cast"]
LINES = ["roberts", "appel", "franklin"]


def int32_npy(path):
    """The numbers of an array of int32, row by row."""
    data = path.read_bytes()
    (length,) = struct.unpack("<H", data[8:10])
    body = data[10 + length:]
    return list(struct.unpack(f"<{len(body) // 4}i", body))


def ppm_bytes(path):
    data = path.read_bytes()
    for _ in range(3):
        data = data[data.index(b"\n") + 1:]
    return list(data)


class StepsPage(PageTest):
    def open_steps(self, program, method, size="36x36"):
        page = self.folder / f"{method}.html"
        run("steps", program, "--hidden", method, "--size", size, "-o", page)
        self.open(page.as_uri())
        return page

    def js(self, code, *values):
        return self.browser.execute_script(code, *values)

    def state(self):
        """All that a step shows."""
        return self.js("""return [steps.step(), steps.ids().join(), document.getElementById('sentence').textContent,
            document.getElementById('overlay').innerHTML, document.getElementById('panels').innerHTML,
            document.querySelectorAll('#listing .runs').length, document.getElementById('count').textContent]""")

    def key(self, key):
        self.browser.find_element(By.TAG_NAME, "body").send_keys(key)

    def test_the_last_step_shows_what_the_command_draws(self):
        plain = self.folder / "plain.draw"  # the picture in pixels is of fills alone
        lines = (PROGRAMS / "cyclic-overlap.draw").read_text().splitlines()
        fills = [line for line in lines if not line.startswith("set-line-style")]
        plain.write_text("\n".join(["set-line-style none", *fills, ""]))
        ids, picture = self.folder / "ids.npy", self.folder / "picture.ppm"
        run("truth", plain, "--size", "36x36", "--ids", ids)
        run("draw", plain, "--size", "36x36", "--hidden", "z-buffer", "--samples", "1", "-o", picture)
        for method in SURFACES:
            with self.subTest(method):
                self.open_steps(plain, method)
                self.js("steps.go(0)")
                self.assertEqual(set(self.js("return steps.ids()")), {-1})
                self.js("steps.go(steps.count)")
                self.assertEqual(self.js("return steps.ids()"), int32_npy(ids))
                self.assertEqual(self.js("return steps.colours()"), ppm_bytes(picture))

    def test_every_step_back_is_the_one_before(self):
        for method in ["bsp", "warnock", "ray-cast", "appel"]:
            with self.subTest(method):
                self.open_steps(PROGRAMS / "interpenetrating-planes.draw", method, "24x24")
                count = self.js("return steps.count")
                self.assertGreater(count, 20)
                forward = []
                for step in list(range(0, min(count, 90))) + [count - 1, count]:
                    self.js("steps.go(arguments[0])", step)
                    forward.append((step, self.state()))
                for step, before in reversed(forward):
                    self.js("steps.go(arguments[0])", step)
                    self.assertEqual(self.state(), before, f"{method}, step {step}")

    def test_steps_of_lines_draw_the_lines(self):
        for method in LINES + ["perimeter"]:
            with self.subTest(method):
                name = "surface" if method == "perimeter" else "house-perspective"
                page = self.open_steps(PROGRAMS / f"{name}.draw", method)
                run("steps", PROGRAMS / f"{name}.draw", "--hidden", method, "-o", page.with_suffix(".json"))
                told = json.loads(page.with_suffix(".json").read_text())
                lines = [line for step in told["steps"] for line in step.get("lines", [])]
                self.js("steps.go(steps.count)")
                seen = self.js("return document.querySelectorAll('#overlay .line-seen').length")
                hidden = self.js("return document.querySelectorAll('#overlay .line-hidden').length")
                self.assertEqual(seen, sum(1 for line in lines if not line[1]))
                self.assertEqual(hidden, sum(1 for line in lines if line[1]))
                self.assertGreater(seen, 10)
                self.js("steps.go(0)")
                self.assertEqual(self.js("return document.querySelectorAll('#overlay .drawn-lines *').length"), 0)

    def test_it_opens_at_the_finished_picture_or_at_the_step_of_its_address(self):
        page = self.open_steps(PROGRAMS / "cyclic-overlap.draw", "bsp")
        step = lambda: self.js("return steps.step()")
        slider = lambda: self.js("return Number(document.getElementById('slider').value)")
        count = self.js("return steps.count")
        self.assertEqual((step(), slider()), (count, count))
        self.assertGreater(len(set(self.js("return steps.ids()"))), 3)
        disabled = "return [...document.querySelectorAll('#controls button:disabled')].map((b) => b.id)"
        self.assertEqual(self.js(disabled), ["next", "last"])
        for address, shown in (("#step=0", 0), ("#step=12", 12), (f"#step={count + 5}", count), ("#else", count)):
            self.open(page.as_uri() + address)
            self.assertEqual((step(), slider()), (shown, shown), address)
        for number in (7, 0, count):  # a link in the page, or an address typed over
            self.js("location.hash = arguments[0]", f"#step={number}")
            wait_for(lambda: step() == number, f"step {number}")
        self.js("steps.go(9)")
        self.assertTrue(self.js("return location.hash") == "#step=9")
        self.browser.refresh()
        wait_for(lambda: self.js("return document.documentElement.dataset.ready"), "the page")
        self.assertEqual(step(), 9)

    def test_play_at_the_end_begins_before_the_first_step(self):
        self.open_steps(PROGRAMS / "cyclic-overlap.draw", "bsp")
        self.js("document.getElementById('speed').value = '1000'; document.activeElement.blur()")
        self.key(" ")
        self.assertLess(self.js("return steps.step()"), 3)
        self.key(" ")
        self.assertEqual(self.js("return document.getElementById('play').getAttribute('aria-pressed')"), "false")

    def test_each_listing_names_the_file_whose_code_runs(self):
        for method, program in [*((method, "cyclic-overlap") for method in SURFACES + LINES), ("perimeter", "surface")]:
            with self.subTest(method):
                self.open_steps(PROGRAMS / f"{program}.draw", method, "8x8")
                code = self.find("#code").text
                self.assertTrue((PROGRAMS.parent / code).is_file(), code)
                self.assertIn(method.replace("-", "_"), code)

    def test_keys_buttons_slider_and_listing_lead_to_steps(self):
        self.open_steps(PROGRAMS / "cyclic-overlap.draw", "bsp")
        step = lambda: self.js("return steps.step()")
        count = self.js("return steps.count")
        self.key(Keys.ARROW_LEFT)
        self.assertEqual(step(), count - 1)
        self.key(Keys.HOME)
        self.key(Keys.ARROW_RIGHT)
        self.key(Keys.ARROW_RIGHT)
        self.assertEqual(step(), 2)
        self.key(Keys.ARROW_LEFT)
        self.assertEqual(step(), 1)
        self.key(Keys.END)
        self.assertEqual(step(), count)
        self.key(Keys.HOME)
        self.assertEqual(step(), 0)
        self.browser.find_element(By.ID, "next").click()
        self.assertEqual(step(), 1)
        self.js("""const slider = document.getElementById('slider'); slider.value = 7;
                slider.dispatchEvent(new Event('input'))""")
        self.assertEqual(step(), 7)
        self.js("document.querySelector('#listing li:last-child').previousElementSibling.firstElementChild.click()")
        self.assertEqual(self.js("return document.querySelector('#listing .runs') === "
                                 "document.querySelector('#listing li:last-child').previousElementSibling"), True)
        live = lambda: self.browser.find_element(By.ID, "sentence").get_attribute("aria-live")
        self.assertEqual(live(), "polite")
        self.js("document.getElementById('speed').value = '0'; document.activeElement.blur()")
        self.key(Keys.HOME)
        self.js("""window.before = [];
                new MutationObserver(changes => before.push(...changes.map(change => change.oldValue)))
                  .observe(document.getElementById('sentence'),
                           {attributeFilter: ['aria-live'], attributeOldValue: true})""")
        self.key(" ")  # it may be over before the next call
        wait_for(lambda: step() == count, "the last step")
        wait_for(lambda: live() == "polite", "the end of playing")
        self.assertIn("off", self.js("return before"))

    def test_going_back_in_thousands_of_steps_is_quick(self):
        self.open_steps(PROGRAMS / "platonic-solids.draw", "ray-cast", "64x64")
        count = self.js("return steps.count")
        self.assertGreater(count, 3000)
        there, back = self.js("""
            const time = (from, by) => { const begin = performance.now();
              for (let k = 0; k < 40; ++k) steps.go(from + by * k); return performance.now() - begin; };
            time(2000, 1); return [time(2000, 1), time(2040, -1)]""")
        self.assertLess(back, 4 * there + 50)

    def test_it_fits_a_phone_and_each_control_has_a_name(self):
        set_window(self.browser, 375)
        self.open_steps(PROGRAMS / "cyclic-overlap.draw", "depth-sort")
        self.js("steps.go(30)")
        self.assertTrue(self.js("return document.documentElement.scrollWidth <= innerWidth"))
        self.assertTrue(self.js("""return [...document.querySelectorAll('button, select, input')].every((e) =>
            e.textContent.trim() || e.getAttribute('aria-label') || e.closest('label'))"""))


if __name__ == "__main__":
    unittest.main()
