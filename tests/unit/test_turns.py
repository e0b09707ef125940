"""Whose turn it is: addresses, then the pages at each, then what came first."""

from __future__ import annotations

from stayput.app.turns import Client, Turns


def taken(turns: Turns[str]) -> list[str]:
    found: list[str] = []
    while (item := turns.take()) is not None:
        found.append(item)
    return found


def test_what_one_client_asks_for_comes_in_its_order() -> None:
    turns: Turns[str] = Turns()
    for item in "abc":
        turns.add(Client("1", "x"), item)
    turns.add(Client("1", "x"), "begun", again=True)
    assert turns.in_order() == ["begun", "a", "b", "c"]
    assert taken(turns) == ["begun", "a", "b", "c"]
    assert len(turns) == 0


def test_pages_at_one_address_take_turns() -> None:
    turns: Turns[str] = Turns()
    for n in range(3):
        turns.add(Client("1", "greedy"), f"g{n}")
    turns.add(Client("1", "other"), "o0")
    assert turns.in_order() == ["g0", "o0", "g1", "g2"]


def test_an_address_with_many_pages_gets_one_turn_of_the_addresses() -> None:
    turns: Turns[str] = Turns()
    for n in range(100):
        turns.add(Client("1", str(n)), f"g{n}")
    turns.add(Client("2", ""), "o")
    assert turns.in_order()[:3] == ["g0", "o", "g1"]
    assert turns.of_address("1") == 100
    assert turns.of_address("3") == 0


def test_who_has_had_a_turn_goes_to_the_end() -> None:
    turns: Turns[str] = Turns()
    clients = {name: Client("1", name) for name in "abc"}
    for name, client in clients.items():
        turns.add(client, name)
    order: list[str] = []
    for _ in range(9):
        item = turns.take()
        assert item is not None
        order.append(item)
        turns.add(clients[item], item, again=True)
    assert "".join(order) == "abcabcabc"


def test_what_is_removed_does_not_get_a_turn() -> None:
    turns: Turns[str] = Turns()
    turns.add(Client("1", "x"), "a")
    turns.add(Client("2", "x"), "b")
    turns.remove("a")
    turns.remove("a")
    assert turns.in_order() == ["b"]
    assert turns.take() == "b"
    assert turns.take() is None
