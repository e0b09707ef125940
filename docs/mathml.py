"""A Sphinx extension: formulas become MathML as the pages are built, so that they show without a network."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from docutils import nodes
from docutils.utils.math import latex2mathml, pick_math_environment, wrap_math_code

if TYPE_CHECKING:
    from sphinx.application import Sphinx
    from sphinx.writers.html5 import HTML5Translator


DOTTED = re.compile(
    r"""<munderover>\s*(<mi>[^<]*</mi>)\s*(.*?)\s*(<mo stretchy="false">[˙¨]</mo>)\s*</munderover>""",
    re.DOTALL,
)


def _mathml(code: str, as_block: bool = False) -> str:
    """Convert a formula; an index of a letter with dots stands beside the letter, not below it."""
    text = str(latex2mathml.tex2mathml(code, as_block=as_block))
    return DOTTED.sub(r"""<msub><mover accent="true">\1\3</mover>\2</msub>""", text)


def _inline(self: HTML5Translator, node: nodes.math) -> None:
    self.body.append(_mathml(node.astext()))
    raise nodes.SkipNode


def _block(self: HTML5Translator, node: nodes.math_block) -> None:
    text = node.astext()
    code = wrap_math_code(text, as_block=True) if pick_math_environment(text) == "align*" else text
    anchor = f' id="{node["ids"][0]}"' if node["ids"] else ""
    self.body.append(f'<div class="math-block"{anchor}>{_mathml(code, as_block=True)}')
    if node["number"]:
        self.body.append(f'<span class="eqno">({node["number"]})</span>')
    self.body.append("</div>")
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the renderer."""
    app.add_html_math_renderer("mathml", inline_renderers=(_inline, None), block_renderers=(_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
