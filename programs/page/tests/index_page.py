"""The product's page in a browser, for its tests."""

from browser import PageTest, make_page, wait_for
from selenium.webdriver.support.select import Select

TRIANGLE = "open-segment 1\npolygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0 0.5 0\nclose-segment\n"


class IndexTest(PageTest):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.page = cls.folder / "index.html"
        make_page(cls.page)

    def setUp(self):
        super().setUp()
        self.open(self.page.as_uri())
        self.at_rest()

    def enter(self, program):
        """Types a program in the place of what stands in the editor."""
        area = self.find("#program")
        self.browser.execute_script("""
            const area = arguments[0];
            area.focus();
            area.select();
            document.execCommand('insertText', false, arguments[1]);""", area, program)

    def pictures(self):
        return int(self.find(".picture canvas").get_attribute("data-pictures"))

    def enter_and_wait(self, program):
        before = self.pictures()
        self.enter(program)
        wait_for(lambda: self.pictures() > before or self.error(), "a picture or an error")
        self.at_rest()

    def error(self):
        return self.find("#program-error").text

    def command_draws(self, program, *words):
        file = self.folder / "typed.draw"
        file.write_text(program, encoding="utf-8")
        return self.drawn(file, *words)

    def show_scene(self, name):
        Select(self.find("#scene")).select_by_value(name)
        wait_for(lambda: self.find("figcaption").text.startswith(f"{name} "), name)
        self.at_rest()
