"""Files of a document as text within limits, and the files of its folder that it takes in."""

from __future__ import annotations

from pathlib import Path, PurePosixPath, PureWindowsPath

BYTES_MAX = 20_000_000
"""Largest size of a document with the files that it takes in."""
FILES_MAX = 500
"""Largest number of times that a document takes in a file."""
DEPTH_MAX = 16
"""Largest number of files that take in one another in a row."""


class SheetError(ValueError):
    """Error for a file that cannot be read as a paper: one line with the file and what was expected."""


def text_of(path: str | Path, most: int) -> str:
    """Return the text of a file of at most so many bytes; raise SheetError or OSError."""
    with open(path, "rb") as file:
        content = file.read(most + 1)
    if len(content) > most:
        raise SheetError(f"{path}: a file has at most {most} bytes")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        wrong = f"the byte {content[error.start]:#x} at {error.start}"
        raise SheetError(f"{path}: expected UTF-8 text, got {wrong}") from None
    if (place := text.find("\0")) >= 0:
        raise SheetError(f"{path}: expected UTF-8 text, got the byte 0x0 at {place}")
    return text.replace("\r\n", "\n").replace("\r", "\n")


class Files:
    """Files of one document, counted against its limits."""

    def __init__(self, first: str | Path) -> None:
        self.first, self.folder = str(first), Path(first).parent
        self.open: list[str] = []
        self.bytes_left, self.files_left = BYTES_MAX, FILES_MAX

    def text(self, path: str) -> str:
        text = text_of(path, self.bytes_left)
        self.bytes_left -= len(text.encode())
        return text

    def name(self, path: str) -> str:
        """Return the name of a file in the folder; empty for the first file."""
        return "" if path == self.first else Path(path).relative_to(self.folder).as_posix()

    def taken_in(self, name: str) -> str:
        r"""Return the path of a file that ``\input`` names; raise ValueError with the reason why it is not read."""
        inside = PurePosixPath(name)
        if not name or "\\" in name or ".." in inside.parts or inside.is_absolute() or PureWindowsPath(name).drive:
            raise ValueError("expected the name of a file in the folder of the document, without \"..\" and macros")
        if self.files_left == 0:
            raise SheetError(f"{self.first}: a document takes in at most {FILES_MAX} files")
        self.files_left -= 1
        for ending in (".tex", ""):
            path = self.folder / f"{name}{ending}"
            try:
                if not path.is_file():
                    continue
            except OSError:  # such as a name that is too long
                continue
            if any(step.is_symlink() for step in (path, *(self.folder / step for step in inside.parents[:-1]))):
                raise ValueError("a symbolic link is not followed")
            if str(path) in self.open:
                raise ValueError(f"the file takes in itself: {' -> '.join(map(self.short, (*self.open, str(path))))}")
            if len(self.open) >= DEPTH_MAX:
                raise ValueError(f"at most {DEPTH_MAX} files take in one another")
            return str(path)
        raise ValueError("no such file in the folder of the document")

    def short(self, path: str) -> str:
        return self.name(path) or Path(path).name
