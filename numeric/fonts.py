"""Font files: found by name or path, opened by fontTools, and the glyph of a character in them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache
from io import BytesIO
from pathlib import Path
from typing import Any

from symbolic.errors import BadValue, shown


def open_font(font: str | Path) -> Any:
    """Return fontTools' `TTFont` of a font that matplotlib ships, or of a .ttf or .otf file.

    >>> open_font("DejaVu Sans")["head"].unitsPerEm
    2048
    """
    return _opened(str(_font_file(font)))


def glyph_name(character: Any, tables: Any, font: Any) -> str:
    """Return the name of the glyph of one character in an open font; `font` is for messages.

    >>> glyph_name("é", open_font("DejaVu Sans"), "DejaVu Sans")
    'eacute'
    """
    if not isinstance(character, str) or len(character) != 1:
        count = f", {len(character)} characters" if isinstance(character, str) else ""
        raise BadValue(
            "one character", shown(character) + count, 'Ask for one letter, such as glyph("a").'
        )
    name = (tables.getBestCmap() or {}).get(ord(character))
    if name is None:
        raise BadValue(
            f"a character that {font} has",
            f"{character!r} (U+{ord(character):04X})",
            "Choose another character or another font.",
        )
    return str(name)


@contextmanager
def readable(font: Any) -> Iterator[None]:
    """Raise BadValue for whatever goes wrong inside: a damaged font fails anywhere in fontTools."""
    try:
        yield
    except Exception as error:
        raise BadValue(
            "an OpenType or TrueType font file",
            f"{font}, which cannot be read ({type(error).__name__}: {shown(str(error))})",
            "Give another file.",
        ) from error


def _font_file(font: Any) -> Path:
    import matplotlib

    if not isinstance(font, str | Path) or len(str(font)) > 500:
        raise BadValue("the name or path of a font", shown(font), 'Try glyph("a", "DejaVu Sans").')
    shipped = Path(matplotlib.get_data_path()) / "fonts" / "ttf"
    for candidate in (Path(font), shipped / f"{str(font).replace(' ', '')}.ttf"):
        if candidate.suffix.lower() in (".ttf", ".otf") and candidate.is_file():
            return candidate
    known = ", ".join(sorted(path.stem for path in shipped.glob("DejaVu*.ttf")))
    raise BadValue(
        "an OpenType or TrueType font", shown(font), f"Matplotlib ships {known}; or give a path."
    )


@lru_cache(maxsize=8)
def _opened(path: str) -> Any:
    from fontTools.ttLib import TTFont

    with readable(path):
        tables = TTFont(BytesIO(Path(path).read_bytes()), lazy=True)
        tables.getBestCmap()  # read now what a damaged file may lack
    return tables
