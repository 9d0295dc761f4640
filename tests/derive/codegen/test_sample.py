"""What of a further chart is validated: all that is its own; of the geometry what no other chart has shown."""

from __future__ import annotations

from contextlib import nullcontext
from pathlib import Path

import pytest

from derive.codegen import ValidationFailed, lowered
from derive.codegen.cases import batches
from derive.codegen.lowered import geometry, lower, lower_chart
from derive.codegen.package import Facts, module_texts, shared_texts
from derive.codegen.signatures import FUNCTIONS, KERNELS, POSES
from derive.codegen.targets import TARGETS
from derive.codegen.validation import Seen, validate
from derive.maps import Cayley, family
from derive.output import files
from derive.proof import prove

pytestmark = pytest.mark.thorough

ORDERS = (1, 3, 4)


@pytest.fixture(scope="module")
def texts():
    target, charts = TARGETS["numpy"], map(Cayley, ORDERS)
    found = shared_texts(target)
    for proved in map(prove, charts):
        found |= module_texts(Facts(proved, lower(proved)), target)
    return found


@pytest.fixture(scope="module")
def given():
    return {n: batches(Cayley(n)) for n in ORDERS}


def test_every_program_of_the_geometry_runs_and_every_result_of_a_scalar_is_read(given):
    seen = Seen()
    chosen = {n: seen.new(lower_chart(Cayley(n)), given[n]) for n in ORDERS}
    assert all(whole for _, whole in chosen[1])
    assert len(chosen[1]) == len(given[1])
    assert seen.programs(POSES) >= KERNELS.keys()
    run = {batch.function for batch, _ in chosen[4]}
    read = {
        (call.function, place)
        for name in run
        for program in [geometry()[FUNCTIONS[name].kernel]]
        for call in program.calls
        for place, result in enumerate(call.names)
        if result in program.operands
    }
    results = {(call.function, i) for p in geometry().values() for call in p.calls for i, _ in enumerate(call.names)}
    assert read == {(function, i) for function, i in results if function in lower_chart(Cayley(4)).scalars}
    # all turns are taken, and what costs the most is not done again
    assert {batch.branch for batch, _ in chosen[4]} == {batch.branch for batch in given[4]}
    assert sum(len(batch.cases) for batch, _ in chosen[4]) < sum(len(batch.cases) for batch in given[4])
    assert not any(whole for _, whole in chosen[4])


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("cayley4.py", "fy = ", "fy = -"),
        ("cayley4.py", "hiy = ", "hiy = 2 * "),
        ("cayley4.py", "return o1, o2, o3\n", "return o2, o1, o3\n"),
        ("cayley4.py", "m.less(limit2, x", "m.less(x, limit2"),
        ("cayley4.py", "0.7071", "0.7072"),
        ("cayley1.py", "1 + x", "1 - x"),
        ("_geometry.py", "Q32 - Q23", "Q23 - Q32"),
        ("_geometry.py", "w1o * f", "w2o * f"),
    ],
)
def test_what_is_wrong_in_any_file_is_noticed_by_some_chart(texts, tmp_path: Path, file, old, new):
    assert old in texts[file]
    files.write(tmp_path, {**texts, file: texts[file].replace(old, new)})
    with pytest.raises(ValidationFailed):
        validate_all(tmp_path)


def test_that_a_chart_has_nothing_to_do_is_not_shown_by_another_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Of sin(α/2) every v is principal; of sin(α/4), were it said so, some would stand that should go back."""
    target, charts = TARGETS["numpy"], [family("orthographic"), family("lambert")]
    for returns in (None, lambda chart: ()):
        with monkeypatch.context() as patch:
            if returns:
                patch.setattr(type(charts[1]), "returns", returns)
            lowered._lowered.cache_clear()
            texts = shared_texts(target)
            for proved in map(prove, charts):
                texts |= module_texts(Facts(proved, lower(proved)), target)
            files.write(tmp_path, texts)
            seen = Seen()
            validate(tmp_path, charts[0], seen.new)
            with pytest.raises(ValidationFailed, match=r"lambert\.principal") if returns else nullcontext():
                validate(tmp_path, charts[1], seen.new)
    lowered._lowered.cache_clear()


def validate_all(folder: Path) -> None:
    seen = Seen()
    for n in ORDERS:
        validate(folder, Cayley(n), seen.new)
