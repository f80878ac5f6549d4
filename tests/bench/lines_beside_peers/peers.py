"""Programs that stay for many questions, so that they are warm (README.md has the protocol)."""
import pathlib
import select
import subprocess

HERE = pathlib.Path(__file__).resolve().parent


class Stopped(Exception):
    """A peer did not answer: it failed, ended, or took too long."""


class Peer:
    """Waits until it is ready. An answer may take `limit` seconds. Raises Stopped, as ask does."""

    def __init__(self, words, limit):
        self.limit, self.said = limit, b""
        try:
            self.process = subprocess.Popen(list(map(str, words)), stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                            stderr=subprocess.DEVNULL, bufsize=0)
        except OSError as error:
            raise Stopped(f"{words[0]} cannot be started") from error
        try:
            self.ready = self.answer("ready")
        except Stopped:
            self.__exit__()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.communicate()

    def ask(self, question, word):
        """What follows the word in the answer."""
        try:
            self.process.stdin.write(f"{question}\n".encode())
        except BrokenPipeError:
            raise Stopped("it ended") from None
        return self.answer(word)

    def answer(self, word):
        """What else it prints is skipped."""
        while True:
            while b"\n" not in self.said:
                if not select.select([self.process.stdout], [], [], self.limit)[0]:
                    raise Stopped(f"stopped after {self.limit:g} s")
                part = self.process.stdout.read(65536)
                if not part:
                    raise Stopped("it ended")
                self.said += part
            line, self.said = self.said.split(b"\n", 1)
            said = line.decode(errors="replace")
            if said.startswith("peer: failed "):
                raise Stopped(said.removeprefix("peer: failed "))
            if said.startswith(f"peer: {word}"):
                return said.removeprefix(f"peer: {word}").strip()


def line_art(blender, folder, kinds, options, threads, limit):
    return Peer([blender, "--background", "--threads", threads, "--factory-startup", "--python", HERE / "line_art.py", "--",
                 folder / "mesh.obj", folder / "view", kinds, options], limit)


def open_cascade(program, folder, algorithm, limit):
    return Peer([program, folder / "mesh.obj", folder / "view", algorithm], limit)
