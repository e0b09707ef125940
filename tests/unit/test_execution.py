"""Executors: the same results in the same order for any number of threads, and nothing left behind."""

import os
import signal
import threading
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from functools import partial

import forks
import numpy as np
import pytest

import stayput as sp
from stayput.execution import AHEAD, MOST_THREADS, Pool, Shared, cores, endable, thread_count


def slow_square(n):
    """The earlier of two neighbours takes longer, so that results come out of order."""
    time.sleep(0.002 * (n % 2 == 0))
    return n * n


def test_calls_are_made_a_few_ahead_of_the_results():
    """A first call that takes long holds back the results of the others, which must not pile up."""
    made, first = [], threading.Event()

    def wait_if_first(n):
        return n if n else first.wait(10)

    def calls():
        for n in range(100):
            made.append(n)
            yield partial(wait_if_first, n)

    with Pool(2) as pool:
        threading.Timer(0.1, first.set).start()
        for given, _ in enumerate(pool.in_order(calls())):
            assert len(made) <= given + 2 * AHEAD
    assert len(made) == 100


def test_an_error_comes_back_in_order_and_drops_the_rest():
    run = []

    def fail(n):
        run.append(n)
        if n in (3, 4):
            time.sleep(0.01 * (4 - n))
            raise ValueError(n)
        return n

    with Pool(2) as pool:
        with pytest.raises(ValueError, match=r"^3$"):
            list(pool.in_order(partial(fail, n) for n in range(1000)))
        assert len(run) < 20
        assert list(pool.in_order(partial(fail, n) for n in (7, 8))) == [7, 8]


def long_run(limit):
    """Run until the limit of its work is below 0, as the engine in space does."""
    endable(lambda: [time.sleep(0.01) for _ in iter(lambda: bool(limit[0] < 0.0), True)], limit)


def test_an_interrupt_ends_a_long_run_that_would_not_hear_it():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may have it ignored
    threading.Timer(0.1, os.kill, [os.getpid(), signal.SIGINT]).start()
    limit = np.ones(1)
    with pytest.raises(KeyboardInterrupt):
        long_run(limit)
    signal.signal(signal.SIGINT, before)
    assert limit[0] < 0.0


def test_an_error_ends_runs_under_way():
    """Without it the block would wait for the run for ever."""

    def fail():
        raise ValueError("no such piece")

    with pytest.raises(ValueError, match="no such piece"), Pool(2) as pool:
        list(pool.as_completed([partial(long_run, np.ones(1)), fail]))


def test_an_error_ends_runs_of_pools_within_a_pool():
    def fail():
        raise ValueError("no such piece")

    def nested():
        with Pool(1) as pool:
            return list(pool.in_order([partial(long_run, np.ones(1))]))

    with pytest.raises(ValueError, match="no such piece"), Pool(2) as pool:
        list(pool.as_completed([nested, fail]))


def test_the_end_of_a_block_drops_what_has_not_begun():
    run = []

    def note(n):
        run.append(n)
        time.sleep(0.01)

    def interrupted():
        with Pool(2) as pool:
            for _ in pool.as_completed(partial(note, n) for n in range(1000)):
                raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    done = len(run)
    time.sleep(0.05)
    assert len(run) == done < 8


class Noted:
    """Adds, and leaves a line in a file for each time that it does."""

    def __init__(self, file):
        self.file = file

    def add(self, base, n):
        number = base.value.number
        with self.file.open("a") as file:
            file.write(f"{n}\n")
        return number + n


class Weighed:
    """A number that leaves a line in a file for each time that it is pickled."""

    def __init__(self, number, file):
        self.number, self.file = number, file

    def __reduce__(self):
        with self.file.open("a") as file:
            file.write("sent\n")
        return Weighed, (self.number, self.file)


def squared(shared):
    return shared.value**2


def itself(value):
    return value


@pytest.fixture(scope="module")
def processes():
    with ProcessPoolExecutor(2, forks.context()) as made:
        yield made


@pytest.fixture(params=["threads", "given threads", "processes"])
def given(request, processes):
    """An executor that is given, or none, and how many processes compute."""
    if request.param == "given threads":
        with ThreadPoolExecutor(3) as made:
            yield made, 1
    else:
        yield (processes, 2) if request.param == "processes" else (None, 1)


def test_any_executor_gives_the_results_in_order(given):
    with Pool(3, given[0]) as pool:
        assert list(pool.in_order(partial(slow_square, n) for n in range(50))) == [n * n for n in range(50)]
        assert dict(pool.as_completed(partial(pow, n, 2) for n in range(9))) == {n: n * n for n in range(9)}


def test_a_shared_value_is_computed_once_a_process_and_sent_there_once(given, tmp_path):
    executor, count = given
    sent, computed = tmp_path / "sent", tmp_path / "computed"
    sent.touch()
    base = Shared(itself, Weighed(100, sent))
    values = [Shared(Noted(computed).add, base, n) for n in range(6)]
    with Pool(2, executor) as pool:
        calls = [partial(squared, value) for value in values for _ in range(10)]
        assert list(pool.in_order(calls)) == [(100 + n) ** 2 for n in range(6) for _ in range(10)]
    times = computed.read_text().split()
    assert all(1 <= times.count(str(n)) <= count for n in range(6))
    # not with each of 60 calls, but again where another process than the one that lacked it computes the call
    assert len(sent.read_text().split()) <= (0 if count == 1 else 12)


def test_an_error_comes_back_from_any_executor(given):
    with Pool(2, given[0]) as pool:
        with pytest.raises(ZeroDivisionError):
            list(pool.in_order([partial(squared, Shared(divmod, 1, 0))]))
        with pytest.raises(sp.InputError, match="Body width"):
            list(pool.in_order([partial(sp.Body, -1.0, 1.0, 1.0)]))


def test_a_lost_executor_is_said():
    with ProcessPoolExecutor(1, forks.context()) as broken, Pool(2, broken) as pool:
        for call in (partial(os._exit, 1), partial(pow, 2, 3)):
            with pytest.raises(sp.InputError, match="The executor is lost") as caught:
                list(pool.in_order([call]))
            assert "使えなくなりました（BrokenProcessPool" in caught.value.told("ja")


def test_what_is_no_executor_is_refused():
    with pytest.raises(sp.InputError, match="Executor"):
        Pool(2, "tcp://127.0.0.1:8786")


def test_a_worker_of_another_version_is_refused(processes, monkeypatch):
    monkeypatch.setattr(sp, "__version__", "0.0.0")
    with Pool(2, processes) as pool, pytest.raises(sp.InputError, match="that of this command"):
        list(pool.in_order([partial(pow, 2, 3)]))


@pytest.mark.parametrize("threads", [0, -1, MOST_THREADS + 1])
def test_a_number_of_threads_that_is_none(threads):
    with pytest.raises(sp.InputError, match="Threads is") as caught:
        Pool(threads)
    assert caught.value.field == "threads"
    assert thread_count(None) == cores() >= 1
