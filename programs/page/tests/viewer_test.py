"""The page of one scene: its pictures are those of the command, in every view."""

import subprocess
import unittest

import PIL.Image
from browser import COMMAND, PROGRAMS, PageTest, make_page, served, start_browser, wait_for
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.select import Select

GEARS = PROGRAMS / "gears.draw"
SURFACE = PROGRAMS / "surface.draw"


class PicturesTest(PageTest):

    def methods(self):
        options = self.browser.find_elements(By.CSS_SELECTOR, "select[id$='-method'] option")
        return [value for value in (option.get_attribute("value") for option in options) if value]

    def compare_every_method(self, scene):
        """Gives how many methods drew; what others are refused with is shown."""
        self.open_scene(scene)
        drew = 0
        self.assertEqual(self.pixels(), self.drawn(scene))
        for method in self.methods():
            with self.subTest(scene=scene.name, method=method):
                self.choose("method", method)
                done = subprocess.run([COMMAND, "draw", scene, "--hidden", method, "-o", self.folder / "refused.png"],
                                      capture_output=True, text=True, check=False)
                if done.returncode == 0:
                    self.assertEqual(self.pixels(), self.drawn(scene, "--hidden", method))
                    drew += 1
                else:
                    self.assertIn(self.status(), done.stderr)
                    self.assertNotEqual(self.status(), "")
        return drew, len(self.methods())

    def test_every_method_draws_the_commands_pixels(self):
        drew, methods = self.compare_every_method(GEARS)
        self.assertEqual(drew, methods - 1)  # all but the perimeter method, which is of surfaces
        drew, methods = self.compare_every_method(SURFACE)
        self.assertEqual(drew, methods)

    def test_choices_are_the_commands_options(self):
        self.open_scene(GEARS)
        self.choose("method", "bsp")
        self.choose("precision", "roundoff=1e-3")
        self.assertEqual(self.pixels(), self.drawn(GEARS, "--hidden", "bsp", "--precision", "roundoff=1e-3"))
        self.choose("precision", "")
        self.choose("method", "franklin")
        self.choose("hiddenLines", "dashed")
        self.assertEqual(self.pixels(), self.drawn(GEARS, "--hidden", "franklin", "--hidden-lines", "dashed"))
        self.choose("lines", "outline boundary crease")
        self.choose("samples", "3")
        self.assertEqual(self.pixels(), self.drawn(GEARS, "--hidden", "franklin", "--hidden-lines", "dashed", "--lines",
                                                   "outline,boundary,crease", "--samples", "3"))

    def test_the_default_of_samples_is_that_of_the_method(self):
        kept = self.folder / "plain.draw"
        kept.write_text("set-hidden-method plain-z-buffer=24\nset-hidden-line-removal on\n" + GEARS.read_text())
        for scene, methods in ((GEARS, {"": 4, "plain-z-buffer=24": 1, "plain-z-buffer=double": 1, "z-buffer": 4}),
                               (kept, {"": 1, "bsp": 4})):
            self.open_scene(scene)
            for method, samples in methods.items():
                with self.subTest(scene=scene.name, method=method):
                    self.choose("samples", "")
                    self.choose("method", method)
                    choices = Select(self.find("select[id$='-samples']")).options
                    one = next(choice for choice in choices if choice.get_attribute("value") == str(samples))
                    self.assertEqual(choices[0].text, f"default: {one.text}")
                    by_default = self.pixels()
                    self.choose("samples", str(samples))
                    self.assertEqual(self.pixels(), by_default)

    def test_methods_of_lines_draw_the_sides_of_a_mesh(self):
        mesh = self.folder / "mesh.obj"
        mesh.write_text("v -1 0 0\nv 1 0 0\nv 0 1 0.5\nv 0 0 2\nf 1 2 3\nf 1 2 4\n")
        self.open_scene(mesh)
        self.assertEqual(self.pixels(), self.drawn(mesh))
        surfaces = self.pixels()
        for method in ("franklin", "roberts", "appel"):
            self.choose("method", method)
            self.assertEqual(self.pixels(), self.drawn(mesh, "--hidden", method))
            self.assertEqual(self.saved("Save SVG").read_bytes(), self.drawn_as("svg", mesh, "--hidden", method))
        self.choose("method", "auto")
        self.assertEqual(self.pixels(), surfaces)

    def test_shading_is_the_commands(self):
        ball = self.folder / "ball.draw"
        ball.write_text("set-light 1 2 3 0.2\nset-hidden-line-removal on\nset-line-style none\nset-shading gouraud\n"
                        "open-segment 1\nsphere-3 0 0 0 0.8 24\nclose-segment\n")
        self.open_scene(ball)
        self.assertEqual(self.pixels(), self.drawn(ball))
        for shading in ("flat", "phong"):
            self.choose("shading", shading)
            other = self.folder / "other.draw"
            other.write_text(ball.read_text().replace("gouraud", shading))
            self.assertEqual(self.pixels(), self.drawn(other))
            self.assertNotEqual(self.pixels(), self.drawn(ball))

    def test_png_has_the_commands_pixels(self):
        self.open_scene(GEARS)
        for background in ("", "none"):
            self.choose("background", background)
            self.choose("samples", "2")
            file = self.saved("Save PNG")
            words = ["--samples", "2"] + (["--background", background] if background else [])
            image = PIL.Image.open(file)
            self.assertEqual("{}x{}".format(*image.size), self.size())
            self.assertEqual(image.convert("RGBA").tobytes(), self.drawn(GEARS, *words))

    def test_svg_has_the_commands_bytes(self):
        self.open_scene(GEARS)
        for method in ("", "map", "bsp", "depth-sort", "franklin", "z-buffer"):
            self.choose("method", method)
            words = ["--hidden", method] if method else []
            self.assertEqual(self.saved("Save SVG").read_bytes(), self.drawn_as("svg", GEARS, *words), method)

    def test_other_shapes_than_squares(self):
        page = self.folder / "wide.html"
        square = self.folder / "square.draw"
        square.write_text("open-segment 1\npolygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0 0.5 0\nclose-segment\n")
        mesh = self.folder / "mesh.obj"
        mesh.write_text("v -1 0 0\nv 1 0 0\nv 0 1 0.5\nv 0 0 2\nf 1 2 3\nf 1 2 4\n")
        for scene in (GEARS, square, mesh):
            make_page(page, scene, "--size", "640x400")
            self.open(page.as_uri())
            width, height, _ = self.picture()
            self.assertAlmostEqual(width / height, 1.6, delta=0.01)
            self.assertEqual(self.pixels(), self.drawn(scene))
            self.find(".picture canvas").send_keys(Keys.ARROW_RIGHT)
            self.at_rest()
            self.assertEqual(self.pixels(), self.drawn(self.saved("Save drawing program")))


class TurningTest(PageTest):

    def drag(self, right, down, with_shift=False):
        canvas = self.find(".picture canvas")
        actions = ActionChains(self.browser)
        if with_shift:
            actions.key_down(Keys.SHIFT)
        actions.move_to_element(canvas).click_and_hold().move_by_offset(right // 2, down // 2)
        actions.move_by_offset(right - right // 2, down - down // 2).release()
        if with_shift:
            actions.key_up(Keys.SHIFT)
        actions.perform()
        self.at_rest()

    def touch(self, kind, *fingers):
        points = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(fingers)]
        self.browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    def assert_saved_program_draws_what_is_shown(self):
        shown = self.pixels()
        program = self.saved("Save drawing program")
        self.assertIn("byte for byte", wait_for(self.status, "what is said of saving"))
        kept = self.folder / "kept.draw"
        kept.write_bytes(program.read_bytes())
        self.assertEqual(shown, self.drawn(kept))
        self.assertEqual(self.saved("Save SVG").read_bytes(), self.drawn_as("svg", kept))

    def test_dragging_turns(self):
        for scene in (GEARS, PROGRAMS / "house-oblique.draw", PROGRAMS / "room-front-clipping.draw"):
            with self.subTest(scene=scene.name):
                self.open_scene(scene)
                before = self.pixels()
                self.drag(120, 60)
                self.assertNotEqual(self.pixels(), before)
                self.assert_saved_program_draws_what_is_shown()

    def test_what_was_chosen_is_saved(self):
        self.open_scene(GEARS)
        self.drag(-150, 40)
        for method in ("z-buffer", "bsp", "map", "plain-z-buffer=16", "franklin", "none"):
            with self.subTest(method=method):
                self.choose("method", method)
                self.assert_saved_program_draws_what_is_shown()
        self.choose("method", "franklin")
        self.choose("lines", "outline boundary crease")
        self.choose("hiddenLines", "dashed")
        self.choose("background", "0 0 0")
        self.assert_saved_program_draws_what_is_shown()

    def test_panning_and_zooming(self):
        self.open_scene(GEARS)
        seen = {self.pixels()}
        self.drag(60, 30, with_shift=True)
        seen.add(self.pixels())
        canvas = self.find(".picture canvas")
        self.browser.execute_cdp_cmd("Input.dispatchMouseEvent", {
            "type": "mouseWheel", "x": canvas.rect["x"] + 200, "y": canvas.rect["y"] + 100, "deltaX": 0, "deltaY": -200})
        wait_for(lambda: self.at_rest() or self.pixels() not in seen, "a larger picture")
        self.at_rest()
        seen.add(self.pixels())
        self.assertEqual(len(seen), 3)
        self.assert_saved_program_draws_what_is_shown()

    def test_zooming_keeps_the_place_under_the_pointer(self):
        self.open_scene(GEARS)
        moved = self.browser.execute_script("""
            const view = { window: [-1, 3, -2, 2], viewport: [0, 1, 0, 1] };
            const pose = { ...kAsDrawn, shift: [0.3, -0.1], zoom: 1.5 };
            const larger = zoomed(view, pose, 2, [0.2, 0.9]);
            return [in_window(view, pose, [0.2, 0.9]), in_window(view, larger, [0.2, 0.9]), larger.zoom];""")
        self.assertEqual(len(moved[0]), len(moved[1]))
        self.assertEqual(len(moved[0]), 2)
        for before, after in zip(moved[0], moved[1]):
            self.assertAlmostEqual(before, after)
        self.assertEqual(moved[2], 3)

    def test_keys(self):
        self.open_scene(GEARS)
        first = self.pixels()
        canvas = self.find(".picture canvas")
        seen = {first}
        for keys in (Keys.ARROW_LEFT, Keys.ARROW_DOWN, "+", "-", Keys.SHIFT + Keys.ARROW_RIGHT):
            canvas.send_keys(keys)
            self.at_rest()
            seen.add(self.pixels())
        self.assertGreaterEqual(len(seen), 5)
        canvas.send_keys("0")
        self.at_rest()
        self.assertEqual(self.pixels(), first)

    def test_fingers(self):
        self.open_scene(GEARS)
        box = self.find(".picture canvas").rect
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        seen = {self.pixels()}
        self.touch("touchStart", (x, y))
        for k in range(1, 6):
            self.touch("touchMove", (x + 20 * k, y))
        self.touch("touchEnd")
        self.at_rest()
        seen.add(self.pixels())
        self.touch("touchStart", (x - 40, y), (x + 40, y))
        for k in range(1, 6):
            self.touch("touchMove", (x - 40 - 10 * k, y), (x + 40 + 10 * k, y))
        self.touch("touchEnd")
        self.at_rest()
        seen.add(self.pixels())
        self.assertEqual(len(seen), 3)
        zoom = self.browser.execute_script("""
            const { view } = document.documentElement.viewer;
            return view.window[1] - view.window[0];""")
        self.assertAlmostEqual(9.2 / zoom, 180 / 80, places=2)

    def test_several_views_are_not_turned(self):
        scene = PROGRAMS / "four-views.draw"
        self.open_scene(scene)
        self.assertRegex(self.status(), "cannot be rotated: .*view")
        self.assertEqual(self.pixels(), self.drawn(scene))
        before = self.pixels()
        self.drag(100, 0)
        self.assertEqual(self.pixels(), before)
        self.assertRegex(self.status(), "cannot be rotated: .*view")

    def test_picking(self):
        self.open_scene(GEARS)
        width, height, _ = self.picture()
        said = subprocess.run([COMMAND, "draw", GEARS, "-o", self.folder / "x.png", "--size", f"{width}x{height}",
                               "--pick", f"{width // 2},{height // 2},2"], capture_output=True, text=True, check=True)
        canvas = self.find(".picture canvas")
        ActionChains(self.browser).move_to_element_with_offset(canvas, 1, 0).click().perform()
        words = wait_for(self.status, "what is picked")
        self.assertRegex(words, r"(Polygon|Edge of polygon) \d+ of segment \d+")
        for number in (words.split(" of segment ")[0].split()[-1], words.split(" of segment ")[1].split(",")[0]):
            self.assertIn(number, said.stdout)
        self.assertNotEqual(self.find(".marks .over").get_attribute("d"), "")
        canvas.send_keys("p")
        wait_for(lambda: self.browser.find_elements(By.CSS_SELECTOR, ".marks .cross"), "the cross")
        self.assertEqual(wait_for(self.status, "what is picked").split(",")[0], words.split(",")[0])
        canvas.send_keys(Keys.ESCAPE)
        self.assertEqual(self.status(), "")


class StillTest(PageTest):

    def test_from_disk_and_from_a_server(self):
        page = self.folder / "scene.html"
        make_page(page, GEARS)
        for address in (page.as_uri(), f"{served(self.folder)}/scene.html"):
            milliseconds = self.open(address)
            print(f"ready after {milliseconds} ms: {address.split(':')[0]}")
            self.assertEqual(self.pixels(), self.drawn(GEARS))
            self.assertEqual(self.browser.find_elements(By.CSS_SELECTOR, ".still"), [])
            loaded = self.browser.execute_script("return performance.getEntriesByType('resource').map(({ name }) => name)")
            self.assertEqual([name for name in loaded if not name.startswith(("blob:", "data:"))], [])

    def page_without(self, before, arguments=()):
        """The page in a browser of its own, after a script that takes something away."""
        page = self.folder / "scene.html"
        make_page(page, GEARS)
        browser = start_browser(arguments=arguments)
        self.addCleanup(browser.quit)
        browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": before})
        browser.get(page.as_uri())
        return browser

    def assert_still(self, browser):
        self.assertTrue(browser.find_element(By.CSS_SELECTOR, ".still svg").is_displayed())
        self.assertIn("A still picture", browser.find_element(By.ID, "why-still").text)
        self.assertEqual(browser.find_elements(By.CSS_SELECTOR, "canvas"), [])

    def test_the_still_without_javascript(self):
        self.assert_still(self.page_without("", ["--blink-settings=scriptEnabled=false"]))

    def test_the_still_without_webassembly(self):
        browser = self.page_without("delete globalThis.Worker; delete globalThis.WebAssembly;")
        wait_for(lambda: browser.execute_script("return document.documentElement.dataset.ready"), "the page")
        self.assert_still(browser)

    def test_without_workers_the_page_draws_itself(self):
        browser = self.page_without("delete globalThis.Worker;")
        wait_for(lambda: browser.execute_script("return document.documentElement.dataset.ready"), "the page")
        self.browser, shared = browser, self.browser
        try:
            self.assertEqual(self.pixels(), self.drawn(GEARS))
        finally:
            self.browser = shared


if __name__ == "__main__":
    unittest.main()
