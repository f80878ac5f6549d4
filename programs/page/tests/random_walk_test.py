"""Whatever is done on the product's page, what is saved is what is shown: random scenes, choices and gestures."""

import os
import random
import unittest

from index_page import IndexTest
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.select import Select

SEED = int(os.environ.get("SEED", "1"))
SCENES = int(os.environ.get("SCENES", "12"))
KEYS = [Keys.ARROW_LEFT, Keys.ARROW_RIGHT, Keys.ARROW_UP, Keys.ARROW_DOWN, "+", "-", "0", "p", Keys.ESCAPE]
NEEDS_CGAL = "section-view.draw"


class RandomWalkTest(IndexTest):

    def walk(self, chance):
        """Chooses a scene, and does some of what can be done with it. Gives its name."""
        scene = Select(self.find("#scene"))
        name = chance.choice([value for value in (option.get_attribute("value") for option in scene.options)
                              if value != NEEDS_CGAL])
        for select in self.browser.find_elements(By.CSS_SELECTOR, ".choices select"):
            if select.is_displayed() and chance.random() < 0.6:
                Select(select).select_by_index(0)
        self.show_scene(name)
        for _ in range(chance.randrange(2, 8)):
            if chance.random() < 0.5:
                self.find(".picture canvas").send_keys(chance.choice(KEYS) * chance.randrange(1, 6))
                continue
            shown = [one for one in self.browser.find_elements(By.CSS_SELECTOR, ".choices select") if one.is_displayed()]
            select = Select(chance.choice(shown))
            select.select_by_index(chance.randrange(len(select.options)))
        self.find(".picture canvas").send_keys(Keys.ESCAPE)
        self.settle()
        return name

    def settle(self):
        """A choice may have entered the scene anew, and drawn it after that."""
        self.browser.execute_async_script("""
            const done = arguments[0];
            const viewer = document.documentElement.viewer;
            const again = (times) => (times === 0 ? done() : viewer.drawer.ask('counts', { key: viewer.key })
              .then(() => viewer.redrawn()).catch(() => undefined).then(() => again(times - 1)));
            again(3);""")

    def test_what_is_saved_is_what_is_shown(self):
        chance = random.Random(SEED)
        drawn = 0
        for step in range(SCENES):
            name = self.walk(chance)
            if self.status():  # a method that is not for this scene or view is refused, and the picture is the last one
                self.browser.refresh()
                self.open(self.page.as_uri())
                continue
            settings = self.browser.execute_script("return document.documentElement.viewer.settings")
            with self.subTest(f"seed {SEED}, step {step}: {name} {settings}"):
                samples = ["--samples", settings["samples"]] if settings["samples"] else []
                kept = self.folder / "kept.draw"
                try:
                    kept.write_bytes(self.saved("Save drawing program").read_bytes())
                except AssertionError:
                    # A program keeps the scene's own method, which may refuse the view: perimeter draws whole surfaces.
                    self.assertIn("expected another method", self.status())
                    continue
                self.assertIn("byte for byte", self.status())
                if settings.get("background") != "none" and "as SVG" not in self.find("figcaption").text:
                    self.assertEqual(self.pixels(), self.drawn(kept, *samples))
                self.assertEqual(self.saved("Save SVG").read_bytes(), self.drawn_as("svg", kept))
                drawn += 1
        self.assertGreaterEqual(drawn, SCENES // 2)


if __name__ == "__main__":
    unittest.main()
