"""The product's page: speed and wrong pixels, steps, two sheets; how it looks, and for whom."""

import json
import pathlib
import re
import unittest

from browser import PROGRAMS, SCREENSHOTS, make_page, run, served, set_window, wait_for
from index_page import IndexTest
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.select import Select


class FiguresTest(IndexTest):

    def test_speed_and_wrong_pixels(self):
        self.show_scene("cyclic-overlap.draw")
        self.find("#speed-table button").click()
        wait_for(lambda: self.find("#speed-table [role=status]").text == "Done.", "all methods")
        self.assertIn("cyclic-overlap.draw", self.find("#speed-table caption").text)
        rows = {}
        for row in self.browser.find_elements(By.CSS_SELECTOR, "#speed-table tbody tr"):
            rows[row.find_element(By.TAG_NAME, "th").text] = [cell.text for cell in row.find_elements(By.TAG_NAME, "td")]
        self.assertGreaterEqual(len(rows), 12)
        for name, cells in rows.items():
            self.assertEqual(len(cells), 3, f"{name}: {cells}")
            if name.endswith("exact"):
                self.assertEqual(cells[2], "0", name)
        self.assertNotEqual(rows["none: in order of entry"][2], "0")
        for column in (0, 1):
            times = [float(cells[column]) for cells in rows.values()]
            self.assertEqual(min(times), 1.0)

    def test_step_by_step(self):
        self.show_scene("cyclic-overlap.draw")
        for method in ("bsp", "warnock"):
            Select(self.find("#stepped")).select_by_value(method)
            file = self.folder / "steps.json"
            run("steps", PROGRAMS / "cyclic-overlap.draw", "--hidden", method, "-o", file)
            self.browser.find_element(By.XPATH, "//button[.='Watch']").click()
            frame = wait_for(lambda: self.browser.find_elements(By.CSS_SELECTOR, "iframe.steps"), "the steps")[0]
            self.browser.switch_to.frame(frame)
            try:
                wait_for(lambda: self.browser.find_elements(By.ID, "sentence"), "the steps' page")
                wait_for(lambda: self.find("#sentence").text, "the last step's sentence")
                self.assertEqual(self.find("#title").text, json.loads(file.read_text())["title"] + ": cyclic-overlap.draw")
                count = len(json.loads(file.read_text())["steps"])
                self.assertEqual(self.find("#count").text, f"{count} / {count}")
            finally:
                self.browser.switch_to.default_content()
            page = self.saved("Save as a page").read_text(encoding="utf-8")
            data = re.search('id="data">(.*?)</script>', page, re.DOTALL)
            self.assertEqual(json.loads(data[1]), json.loads(file.read_text()))

    def test_methods_that_have_no_steps_of_a_scene_say_so(self):
        self.show_scene("cyclic-overlap.draw")
        Select(self.find("#stepped")).select_by_value("perimeter")
        self.browser.find_element(By.XPATH, "//button[.='Watch']").click()
        told = lambda: self.find("#step-by-step .status").text
        wait_for(lambda: "perimeter" in told(), "why it has none")
        self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, "iframe.steps"), [])

    def test_two_sheets(self):
        captions = self.browser.find_elements(By.CSS_SELECTOR, "#sheets figcaption")
        wait_for(lambda: all("wrong" in caption.text for caption in captions), "two sheets")
        self.assertIn("no wrong pixel", captions[0].text)
        self.assertRegex(captions[1].text, r"[1-9].* % of the pixels wrong")
        gap = self.find("#gap")
        gap.send_keys(Keys.HOME)
        wait_for(lambda: "no wrong pixel" in captions[1].text, "sheets that lie far apart")
        self.assertEqual(gap.get_attribute("aria-valuetext"), "1e-3")
        Select(self.find("#depths")).select_by_value("16")
        gap.send_keys(Keys.ARROW_RIGHT * 3)
        wait_for(lambda: "%" in captions[1].text, "sheets that 16 bits do not part")
        self.assertIn("no wrong pixel", captions[0].text)


class LooksTest(IndexTest):

    def test_from_a_server(self):
        for address in (self.page.as_uri(), f"{served(self.folder)}/index.html"):
            print(f"ready after {self.open(address)} ms: {address.split(':')[0]}")
            self.assertEqual(self.pixels(), self.drawn(PROGRAMS / "gears.draw"))

    def test_nothing_is_wider_than_the_window(self):
        scene = self.folder / "scene.html"
        make_page(scene, PROGRAMS / "house-perspective.draw")
        for page in (self.page, scene):
            for dark in (False, True):
                for width in (320, 375, 768, 1280):
                    set_window(self.browser, width, dark=dark)
                    self.open(page.as_uri())
                    self.at_rest()
                    wide = self.browser.execute_script("return document.documentElement.scrollWidth")
                    self.assertLessEqual(wide, width, page.name)
                    self.take_screenshot(f"{page.stem}-{width}-{'dark' if dark else 'light'}.png", width, dark)

    def take_screenshot(self, name, width, dark):
        if SCREENSHOTS is None:
            return
        folder = pathlib.Path(SCREENSHOTS)
        folder.mkdir(parents=True, exist_ok=True)
        if self.browser.find_elements(By.ID, "sheets"):
            wait_for(lambda: "wrong" in self.find("#sheets figure + figure figcaption").text, "the sheets")
        height = self.browser.execute_script("return document.documentElement.scrollHeight")
        set_window(self.browser, width, height, dark)
        self.at_rest()
        self.browser.save_screenshot(str(folder / name))

    def test_all_that_is_worked_has_a_name(self):
        tree = self.browser.execute_cdp_cmd("Accessibility.getFullAXTree", {})["nodes"]
        roles = {"button", "combobox", "slider", "textbox", "application", "img", "table", "Canvas"}
        worked = [node for node in tree if not node.get("ignored") and node["role"]["value"] in roles]
        self.assertGreater(len(worked), 15)
        for node in worked:
            self.assertTrue(node.get("name", {}).get("value"), node["role"])

    def test_the_keyboard_reaches_all_of_it(self):
        everything = self.browser.execute_script("""
            return [...document.querySelectorAll('button, select, input, textarea, canvas[tabindex]')]
              .filter((one) => one.checkVisibility()).length;""")
        self.browser.execute_script("document.activeElement.blur()")
        reached = set()
        for _ in range(everything + 4):
            ActionChains(self.browser).send_keys(Keys.TAB).perform()
            reached.add(self.browser.switch_to.active_element.id)
            outline = self.browser.execute_script("""
                const active = document.activeElement;
                const shown = active.closest('.editor') ?? (active.id === 'file' ? active.nextElementSibling : active);
                return active === document.body ? 'none needed' : getComputedStyle(shown).outlineStyle;""")
            self.assertNotEqual(outline, "none")
        self.assertGreaterEqual(len(reached), everything)

    def test_text_can_be_read(self):
        for dark in (False, True):
            set_window(self.browser, 1280, dark=dark)
            colours = self.browser.execute_script("""
                const style = getComputedStyle(document.documentElement);
                const of = (name) => style.getPropertyValue(`--${name}`).trim();
                return Object.fromEntries(['paper', 'panel', 'ink', 'quiet', 'accent', 'on-accent', 'wrong', 'wrong-paper',
                  'edge'].map((name) => [name, of(name)]));""")
            for text, paper, least in (("ink", "paper", 7), ("ink", "panel", 7), ("quiet", "paper", 4.5),
                                       ("quiet", "panel", 4.5), ("accent", "paper", 4.5), ("on-accent", "accent", 4.5),
                                       ("wrong", "paper", 4.5), ("ink", "wrong-paper", 4.5), ("edge", "paper", 3)):
                contrast = self.contrast(colours[text], colours[paper])
                self.assertGreaterEqual(contrast, least, f"{text} on {paper}, {'dark' if dark else 'light'}")

    @staticmethod
    def contrast(one, other):
        """The ratio of luminances, as WCAG 2.2 defines it."""

        def luminance(colour):
            parts = [int(colour[k:k + 2], 16) / 255 for k in (1, 3, 5)]
            linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055)**2.4 for part in parts]
            return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

        dark, light = sorted((luminance(one), luminance(other)))
        return (light + 0.05) / (dark + 0.05)


if __name__ == "__main__":
    unittest.main()
