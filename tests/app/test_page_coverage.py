"""V8's ranges become lines: inner ranges overrule outer ones, comments do not count."""

from page_coverage import code_lines, missed_lines

SOURCE = """\
// a comment
const wave = "🌊";

/* of two
   lines */
function run() {
  if (wave === "") {
    return 1;
  }
  return 2;
}
run();
function never() { return wave; }
"""


def span(text, count, end=None):
    def unit(place):
        return len(SOURCE[:place].encode("utf-16-le")) // 2

    start = SOURCE.index(text)
    stop = start + len(text) if end is None else SOURCE.index(end, start) + len(end)
    return {"startOffset": unit(start), "endOffset": unit(stop), "count": count}


FUNCTIONS = [
    {"ranges": [span(SOURCE, 1)]},
    {"ranges": [span("function run", 1, "return 2;\n}"), span("{\n    return 1", 0, "  }")]},
    {"ranges": [span("function never() { return wave; }", 0)]},
]


def test_blank_lines_and_comments_are_no_code():
    assert list(code_lines(SOURCE)) == [2, 6, 7, 8, 9, 10, 11, 12, 13]


def test_lines_of_which_no_part_ran_are_missed():
    assert missed_lines(SOURCE, [FUNCTIONS]) == [8, 9, 13]


def test_a_line_that_ran_in_one_of_the_pages_is_not_missed():
    other = [{"ranges": [span(SOURCE, 1)]}]
    assert missed_lines(SOURCE, [FUNCTIONS, other]) == []


def test_a_module_that_was_never_loaded_is_missed():
    assert len(missed_lines(SOURCE, [])) == 9
