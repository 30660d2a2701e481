"""Working copies: the notebooks a learner works in, one for every lesson.

A copy that was edited is never written over. A small file beside the copies remembers what was
written, and only a copy that still is exactly that may be replaced by the lesson's next edition;
beside an edited one that edition gets a name of its own. Of a copy nothing is remembered about we
know only that it may be edited.
"""

import json
import os
import sys
from collections.abc import Iterator
from hashlib import sha256
from itertools import count
from pathlib import Path
from platform import python_version

STATE = ".casteljau.json"
LESSONS = "[0-9][0-9]_*.md"
Records = dict[str, dict[str, str]]  # name of a copy: digests of the "lesson" and of the "copy"


def write_copies(lessons: Path, folder: Path, edition: str) -> dict[str, str]:
    """Bring the working copies of all lessons in a folder up to date.

    Returns
    -------
    dict
        One entry a lesson: the file that holds its present edition, and what became of it:
        ``written``, ``current`` (nothing to do) or ``kept`` (edited, so left alone).

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as name:
    ...     lessons, folder = Path(name), Path(name, "copies")
    ...     _ = (lessons / "01_lines.md").write_text("# Lines")
    ...     print(write_copies(lessons, folder, "0.1.0"))
    ...     _ = (folder / "01_lines.ipynb").write_text("edited")
    ...     print(write_copies(lessons, folder, "0.1.0"))
    ...     _ = (lessons / "01_lines.md").write_text("# Straight lines")
    ...     print(write_copies(lessons, folder, "0.2.0"))
    {'01_lines.ipynb': 'written'}
    {'01_lines.ipynb': 'kept'}
    {'01_lines.0.2.0.ipynb': 'written'}
    """
    folder.mkdir(parents=True, exist_ok=True)
    records = read_records(folder)
    save_records(folder, records)  # before any copy: this tells whether the folder can be written
    copies = [deliver(path, folder, records, edition) for path in sorted(lessons.glob(LESSONS))]
    save_records(folder, records)
    return dict(copies)


def deliver(lesson: Path, folder: Path, records: Records, edition: str) -> tuple[str, str]:
    """Write a lesson to the first of its names that is free or holds an unedited copy."""
    source = digest(lesson.read_bytes())
    own = next(names(lesson.stem, edition))
    there = (folder / own).exists()
    if there and own not in records:  # nothing is known of it: it is the learner's, or as written
        same = (folder / own).is_file() and (folder / own).read_bytes() == notebook(lesson)
        records[own] = {"lesson": source, "copy": digest(notebook(lesson)) if same else ""}
    for name, record in records.items():
        # A copy that was deleted comes back; one that lay beside an edited copy was unwanted.
        if there and name.startswith(f"{lesson.stem}.") and record["lesson"] == source:
            return name, "kept" if edited(folder, own, records) else "current"
    name = next(name for name in names(lesson.stem, edition) if not edited(folder, name, records))
    text = notebook(lesson)
    replace(folder / name, text)
    records[name] = {"lesson": source, "copy": digest(text)}
    return name, "written"


def edited(folder: Path, name: str, records: Records) -> bool:
    """Tell whether a copy is there and is not what was written."""
    try:
        content = (folder / name).read_bytes()
    except FileNotFoundError:
        return False
    except OSError:  # a folder, say
        return True
    return name not in records or digest(content) != records[name]["copy"]


def names(stem: str, edition: str) -> Iterator[str]:
    """Yield the names a copy may have: its own, then names that tell the edition.

    >>> some = names("01_lines", "0.2.0")
    >>> next(some), next(some), next(some)
    ('01_lines.ipynb', '01_lines.0.2.0.ipynb', '01_lines.0.2.0-2.ipynb')
    """
    yield f"{stem}.ipynb"
    yield f"{stem}.{edition}.ipynb"
    for number in count(2):
        yield f"{stem}.{edition}-{number}.ipynb"


def notebook(lesson: Path) -> bytes:
    """Convert a lesson to a notebook without outputs; the same text gives the same bytes.

    They are the bytes JupyterLab itself would save: to open a copy does not edit it.
    """
    # jsonschema would build a grammar of web addresses while it is imported, for 1.2 s of the 1.7 s
    # that importing jupytext takes; it does without where the grammar is not installed.
    sys.modules.setdefault("rfc3987_syntax", None)  # type: ignore[arg-type]
    import jupytext

    book = jupytext.reads(lesson.read_text("utf-8"), fmt="md:myst")
    book.metadata = {
        "kernelspec": {
            "display_name": "Python 3 (ipykernel)",
            "language": "python",
            "name": "python3",
        },
        "language_info": {
            "codemirror_mode": {"name": "ipython", "version": 3},
            "file_extension": ".py",
            "mimetype": "text/x-python",
            "name": "python",
            "nbconvert_exporter": "python",
            "pygments_lexer": "ipython3",
            "version": python_version(),
        },
    }
    for number, cell in enumerate(book.cells):
        cell.id = f"cell-{number}"  # jupytext draws them at random
        if cell.metadata.get("jupyter", {}).get("outputs_hidden"):
            cell.metadata["collapsed"] = True  # the older word for it
    return f"{jupytext.writes(book, fmt='ipynb')}\n".encode()


def read_records(folder: Path) -> Records:
    """Return what was written earlier; a file that cannot be understood says nothing."""
    try:
        records = json.loads((folder / STATE).read_bytes())
        return {
            name: {key: str(r[key]) for key in ("lesson", "copy")} for name, r in records.items()
        }
    except (OSError, ValueError, AttributeError, LookupError, TypeError):
        return {}


def save_records(folder: Path, records: Records) -> None:
    """Remember what was written."""
    replace(folder / STATE, json.dumps(records, indent=1).encode())


def replace(path: Path, content: bytes) -> None:
    """Write a file so that it is there as a whole or not at all."""
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    try:
        part.write_bytes(content)
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)


def digest(content: bytes) -> str:
    """Return a fingerprint.

    >>> digest(b"a") == digest(b"a"), digest(b"a") == digest(b"b")
    (True, False)
    """
    return sha256(content).hexdigest()
