"""The description of the API: complete, rendered without foreign scripts, and kept to by the server."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest
import schemathesis
from hypothesis import HealthCheck, settings
from serving import COMPILING, running

from stayput.app.server import create_app

if TYPE_CHECKING:
    from collections.abc import Iterator

    import httpx
    from serving import Running

app = create_app(warming=False)
app.state.service.close()
schema = schemathesis.openapi.from_dict(app.openapi())
schema.config.phases.coverage.enabled = False  # a thousand cases for each scene: passed, but takes minutes


@pytest.fixture(scope="module")
def served() -> Iterator[Running]:
    """A server of its own, since its motions and jobs are thrown about."""
    with running() as found:
        yield found


MADE_UP = settings(deadline=None, derandomize=True, database=None, suppress_health_check=list(HealthCheck))


@schema.parametrize()
@settings(MADE_UP, max_examples=3)
def test_no_input_makes_the_server_fail(case: schemathesis.Case, served: Running) -> None:
    is_described(case, served)


@pytest.mark.long
@schema.parametrize()
@settings(MADE_UP, max_examples=25)
def test_much_input_does_not_make_the_server_fail(case: schemathesis.Case, served: Running) -> None:
    is_described(case, served)


def is_described(case: schemathesis.Case, served: Running) -> None:
    answer = case.call(base_url=served.address, timeout=COMPILING)
    assert answer.status_code < 500 or answer.status_code == 503, answer.text
    case.validate_response(
        answer,
        checks=[
            schemathesis.checks.not_a_server_error,
            schemathesis.checks.status_code_conformance,
            schemathesis.checks.content_type_conformance,
            schemathesis.checks.response_schema_conformance,
        ],
    )


def test_the_description_is_openapi_3_1_and_closed(client: httpx.Client) -> None:
    found = client.get("/api/openapi.json").json()
    assert found["openapi"].startswith("3.1")
    schemas = found["components"]["schemas"]
    references = set(re.findall(r'"#/components/schemas/([^"]+)"', client.get("/api/openapi.json").text))
    assert references <= set(schemas)
    assert {"Scenario", "Measure", "Problem"} <= references
    assert "x-stands-for" not in str(found)
    assert [*found["paths"]["/api/v1/motions"]["post"]["requestBody"]["content"]] == ["multipart/form-data"]
    for methods in found["paths"].values():
        for route in methods.values():
            assert route["description"].endswith((".", ")"))
