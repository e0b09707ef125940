"""What is in a page of HTML: its elements and its words."""

import re
from html.parser import HTMLParser
from itertools import pairwise

VOID = {"meta", "img", "input", "br", "line", "rect", "circle", "polyline", "polygon"}


class Page(HTMLParser):
    """Collects elements and text, and checks that elements are closed in order."""

    def __init__(self, text):
        super().__init__()
        self.open, self.elements, self.text, self.scripts = [], [], [], []
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        (self.scripts if self.open and self.open[-1] in ("script", "style") else self.text).append(data)

    @property
    def words(self):
        return " ".join("".join(self.text).split())


def check_alone(text):
    """Check that a page loads nothing, runs nothing of its text, and links nowhere else."""
    assert re.findall(r"https?://[^\s\"'<]*", text) == []
    for tag, attrs in Page(text).elements:
        assert "onclick" not in attrs, tag
        assert attrs.get("src", "data:").startswith("data:"), tag
        assert attrs.get("href", "#").startswith("#"), tag
        assert tag not in ("link", "object", "base")
    assert "@import" not in text
    assert "url(" not in text
    assert len(text.encode()) < 2_000_000


def check_readable(text, language):
    """Check what a reader who does not see the page needs: names, scopes, headings in order."""
    elements = Page(text).elements
    assert ("html", {"lang": language}) in elements
    ids = [attrs["id"] for _, attrs in elements if "id" in attrs]
    assert len(ids) == len(set(ids))
    for tag, attrs in elements:
        if tag == "svg":
            assert attrs.get("aria-label") or attrs.get("aria-hidden") == "true" or "x" in attrs
        if tag == "canvas":
            assert attrs["aria-label"]
        if tag == "th":
            assert attrs["scope"] in ("col", "row")
        assert attrs.get("aria-labelledby", ids[0]) in ids
    levels = [int(tag[1]) for tag, _ in elements if re.fullmatch("h[1-6]", tag)]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(after - before <= 1 for before, after in pairwise(levels))
