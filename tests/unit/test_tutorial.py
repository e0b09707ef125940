"""The tutorial notebook of the documentation runs, and its cells show what the text says."""

from pathlib import Path

import nbformat
from nbclient import NotebookClient

TUTORIAL = Path(__file__).parents[2] / "docs" / "tutorial.ipynb"


def printed(notebook: nbformat.NotebookNode) -> str:
    outputs = [out for cell in notebook.cells if cell.cell_type == "code" for out in cell.outputs]
    return "".join(out.get("text", "") for out in outputs)


def test_the_tutorial_is_kept_without_what_it_prints() -> None:
    notebook = nbformat.read(TUTORIAL, as_version=4)
    nbformat.validate(notebook)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(not cell.outputs and cell.execution_count is None for cell in code)


def test_the_tutorial_runs() -> None:
    notebook = nbformat.read(TUTORIAL, as_version=4)
    NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    assert "It lies after" in printed(notebook)
    shown = [
        out["data"]
        for cell in notebook.cells
        if cell.cell_type == "code"
        for out in cell.outputs
        if "data" in out
    ]
    assert sum("image/png" in data for data in shown) == 1
    body, run, film, verdict = (data["text/html"] for data in shown if "text/html" in data)
    assert "g tan α" in body
    assert "overturned" in run
    assert film.startswith("<iframe")
    assert verdict.index("Screwed L-brackets") < verdict.index("Without measures")
