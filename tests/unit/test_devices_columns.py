"""Record layouts of elements: what zeros mean, and the room in the work records."""

import numpy as np

from stayput.mechanics.columns import CONTACTS
from stayput.mechanics.devices import columns as el


def test_a_row_of_zeros_is_no_element_and_a_result_of_zeros_is_no_failure():
    assert np.zeros(1, el.ELEMENT)["kind"][0] == el.NONE
    assert np.zeros(1, el.DEVICE)["failure"][0] == el.HOLDS
    assert np.zeros(1, el.LINK)["branch"][0].tolist() == [el.OPEN, el.OPEN]


def test_a_work_record_has_room_for_all_lines_and_margins():
    work = np.zeros(1, el.WORK)[0]
    assert work["line"].shape == (2 * el.MAX_ELEMENTS,)
    assert work["weight"].shape == (CONTACTS + 3,)
    assert work["gap"].shape == (CONTACTS,)
