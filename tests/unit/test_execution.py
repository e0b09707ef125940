"""Executors: the same results in the same order for any number of threads, and nothing left behind."""

import threading
import time

import pytest

import stayput as sp
from stayput.execution import SHARED_KEPT, Call, Shared, ThreadExecutor, cores, thread_count


def slow_square(n):
    """The earlier of two neighbours takes longer, so that results come out of order."""
    time.sleep(0.002 * (n % 2 == 0))
    return n * n


@pytest.mark.parametrize("threads", [1, 2, 7, None])
def test_results_are_those_of_the_calls(threads):
    squares = [n * n for n in range(50)]
    with ThreadExecutor(threads) as executor:
        assert list(executor.in_order(Call(slow_square, n) for n in range(50))) == squares
        unordered = executor.as_completed(Call(slow_square, n) for n in range(50))
        assert dict(unordered) == dict(enumerate(squares))
        assert list(executor.in_order([])) == []


def test_calls_are_made_a_few_ahead_of_the_results():
    """A first call that takes long holds back the results of the others, which must not pile up."""
    made, first = [], threading.Event()

    def wait_if_first(n):
        return n if n else first.wait(10)

    def calls():
        for n in range(100):
            made.append(n)
            yield Call(wait_if_first, n)

    with ThreadExecutor(2) as executor:
        threading.Timer(0.1, first.set).start()
        for given, _ in enumerate(executor.in_order(calls())):
            assert len(made) <= given + 2 * executor.ahead
    assert len(made) == 100


def test_an_error_comes_back_in_order_and_drops_the_rest():
    run = []

    def fail(n):
        run.append(n)
        if n in (3, 4):
            time.sleep(0.01 * (4 - n))
            raise ValueError(n)
        return n

    with ThreadExecutor(2) as executor:
        with pytest.raises(ValueError, match=r"^3$"):
            list(executor.in_order(Call(fail, n) for n in range(1000)))
        assert len(run) < 20
        assert list(executor.in_order(Call(fail, n) for n in (7, 8))) == [7, 8]


def test_the_end_of_a_block_drops_what_has_not_begun():
    run = []

    def note(n):
        run.append(n)
        time.sleep(0.01)

    def interrupted():
        with ThreadExecutor(2) as executor:
            for _ in executor.as_completed(Call(note, n) for n in range(1000)):
                raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    done = len(run)
    time.sleep(0.05)
    assert len(run) == done < 8


def test_a_shared_value_is_computed_once_and_forgotten_in_time():
    computed = []

    def compute(base, n):
        computed.append(n)
        time.sleep(0.005)
        return base + n

    base = Shared.value(100)
    values = [Shared(compute, base, n) for n in range(6)]
    with ThreadExecutor(3) as executor:
        calls = [Call(slow_square, value) for value in values for _ in range(10)]
        assert list(executor.in_order(calls)) == [(100 + n) ** 2 for n in range(6) for _ in range(10)]
        assert sorted(computed) == list(range(6))
        assert len(executor._shared) <= SHARED_KEPT


def test_an_error_of_a_shared_value_comes_back():
    with ThreadExecutor(2) as executor, pytest.raises(ZeroDivisionError):
        list(executor.in_order([Call(slow_square, Shared(divmod, 1, 0))]))


@pytest.mark.parametrize("threads", [0, -1, 4097])
def test_a_number_of_threads_that_is_none(threads):
    with pytest.raises(sp.InputError, match="Threads is") as caught:
        ThreadExecutor(threads)
    assert caught.value.field == "threads"
    assert thread_count(None) == cores() >= 1
