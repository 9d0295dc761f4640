"""Generated C: no warnings in any supported dialect, correct results at any optimisation, a CMake package."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import pytest

from benchmarks import flight
from derive.codegen.rows import inside
from derive.codegen.signatures import POSES, ROTATIONS, lower_chart
from derive.codegen.targets.c import levels, programs
from derive.codegen.validation.c_text import prefix
from derive.maps import Cayley
from tests.support import packages
from tests.support.compilers import FOREIGN, FOREIGN_FUNCTIONS, WARNINGS

pytestmark = [pytest.mark.compiler, pytest.mark.thorough]

ROOT = Path(__file__).parents[2]
ORDERS = packages.ORDERS["c"]
TABLES = (POSES, ROTATIONS)
FAMILIES = [("gcc", "g++"), *([("clang", "clang++")] if shutil.which("clang++") else [])]
"""Pairs of a C and a C++ compiler, by vendor."""

# clang warns of a loop that it leaves as it is; a test below requires vector code of gcc
VECTOR = ("-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math", "-DDUALCAY_SIMD_MATH", "-Wno-pass-failed")
SANITIZED = ("-O0", "-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-DDUALCAY_CORE=static inline")
REALS = ("float", "double")


def includes(orders: Sequence[int]) -> str:
    """Return the #include lines for some orders."""
    return "".join(f'#include "{inside(table, f"cayley{n}.h")}"\n' for n in orders for table in TABLES)


INCLUDE_ALL = includes(ORDERS)
ROOTS = Path(__file__).parent / "roots.c"


@pytest.fixture(scope="module")
def package(folder) -> Path:
    """Return the folder of the C package."""
    return folder("c")


def tool(name: str) -> str:
    found = shutil.which(name)
    assert found, f"these tests need {name}"
    return found


def run(*command: object, cwd: Path | None = None) -> str:
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, cwd=cwd, check=False)
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout + done.stderr


def written(folder: Path, name: str, text: str) -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


# each language compiles every order and every real type
@pytest.mark.parametrize("compilers", FAMILIES, ids=lambda pair: pair[0])
@pytest.mark.parametrize(
    ("standard", "real", "orders"),
    [
        ("c99", "float", ORDERS[:2]), ("c17", "double", ORDERS[2:]), ("c17", "long double", ORDERS[:1]),
        ("c++11", "double", ORDERS[:2]), ("c++20", "float", ORDERS[2:]),
    ],
)  # fmt: skip
def test_headers_compile_without_a_warning(package, tmp_path, standard, real, orders, compilers):
    name = compilers["++" in standard]
    text = "#include <math.h>\n#include <stddef.h>\n" + "".join(f"#define {name} ?\n" for name in FOREIGN)
    text += "".join(f"#define {name}(x) ?\n" for name in FOREIGN_FUNCTIONS) + includes(orders)
    source = written(tmp_path, "some.cpp" if "++" in standard else "some.c", text)
    further = ("-Wold-style-cast",) if "++" in standard else ()
    flags = (f"-std={standard}", *WARNINGS, *further, "-O2", f"-DDUALCAY_REAL={real}", f"-I{package}")
    run(tool(name), *flags, "-c", source, "-o", tmp_path / "some.o")


def test_internal_macros_are_undefined_at_the_end_of_headers(package, tmp_path):
    source = written(tmp_path, "all.c", INCLUDE_ALL)
    left = re.findall(r"^#define (DUALCAY_\w+)", run(tool("gcc"), "-E", "-dM", f"-I{package}", source), re.MULTILINE)
    assert "DUALCAY_CAYLEY8_ORDER" in left
    for table in TABLES:
        text = (package / inside(table, "geometry.h")).read_text("utf-8")
        told = re.findall(r"\bDUALCAY_(?:NAME|CHART|BRANCHES|MATH_\w+)", text)
        assert len(set(told)) == 3 + len(programs(table))
        assert not set(left) & set(told)


def test_another_real_type_is_refused(package, tmp_path):
    source = written(tmp_path, "all.c", INCLUDE_ALL)
    done = subprocess.run(
        [tool("gcc"), "-DDUALCAY_REAL=int", f"-I{package}", "-c", str(source), "-o", str(tmp_path / "all.o")],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode
    assert "DUALCAY_REAL must be float, double or long double" in done.stderr


@pytest.mark.parametrize(("real", "suffix"), [("float", "f"), ("double", ""), ("long double", "l")])
def test_roots_without_a_library_are_off_by_a_unit_at_most(package, tmp_path, real, suffix):
    """Compare at random bit patterns, subnormal ones too, and at zero, infinity, NaN and a negative number."""
    source = written(tmp_path, "roots.c", ROOTS.read_text("utf-8").replace("TYPE", real).replace("SUFFIX", suffix))
    run(tool("gcc"), "-std=c99", "-O2", f"-I{package}", source, "-o", tmp_path / "roots", "-lm")
    assert run(tmp_path / "roots") == "0 inf 1 1\n"


def test_device_qualifiers_stand_before_every_function(package, tmp_path):
    """Preprocess for CUDA; expect host and device qualifiers on every function, and no loop pragma."""
    source = written(tmp_path, "device.cpp", INCLUDE_ALL)
    keywords = ("-D__CUDACC__", "-D__host__=HOST", "-D__device__=DEVICE", "-D__forceinline__=inline")
    text = run(tool("g++"), "-E", "-P", *keywords, f"-I{package}", source)
    functions = re.findall(r"^(.*) (?:void|int) (dualcay_\w+)\(", text, re.MULTILINE)
    assert len(functions) > 160
    assert {qualifiers for qualifiers, _ in functions} == {"static inline HOST DEVICE"}
    assert "GCC ivdep" not in text


# each order in one real type with one compiler; orders 3 and 8 as vector code with fused multiply-add
@pytest.mark.parametrize(
    ("compiler", "order", "real", "flags"),
    [
        (FAMILIES[-(n == 8)][0], n, REALS[i % 2], (*VECTOR, "-ffp-contract=fast") if n in (3, 8) else SANITIZED)
        for i, n in enumerate(ORDERS)
    ],
)
def test_results_agree_with_exact_ones(package, tmp_path, compiler, order, real, flags):
    program = tmp_path / "test"
    strict = ("-std=c99", *WARNINGS)
    source = package / f"test_cayley{order}.c"
    run(tool(compiler), *strict, *flags, f"-DDUALCAY_REAL={real}", source, "-o", program, "-lm")
    assert f"cayley{order}, {real}: " in run(program)


@pytest.mark.parametrize(("compilers", "real"), [(FAMILIES[0], REALS[0]), (FAMILIES[-1], REALS[1])])
def test_results_agree_with_exact_ones_in_cpp(package, tmp_path, real, compilers):
    """Compile without optimisation, which treats C++ as it treats C: overloads and conversions may differ."""
    program = tmp_path / "test"
    flags = ("-std=c++17", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O0", f"-DDUALCAY_REAL={real}")
    run(tool(compilers[1]), *flags, "-x", "c++", package / "test_cayley3.c", "-o", program)
    assert "calls agree" in run(program)


@pytest.mark.parametrize(
    ("order", "table", "turns", "math"),
    [(3, POSES, 3, ()), (3, ROTATIONS, 2, ()), (8, POSES, 3, ("-DDUALCAY_SIMD_MATH",))],
)
def test_loops_over_rows_become_vector_code(package, tmp_path, order, table, turns, math):
    """Expect vector code for loops without tan and atan2, and with libmvec for all loops, also over turns."""
    header = (package / inside(table, "geometry.h")).read_text(encoding="utf-8").splitlines()
    begin = prefix(Cayley(order), table)
    uses = "".join(f"void *use_{name} = (void *){begin}_{name}_rows;\n" for name in table.public)
    source = written(tmp_path, "rows.c", f'#include "{inside(table, f"cayley{order}.h")}"\n{uses}')
    # without -fno-ipa-icf, gcc merges identical loops and reports only one
    flags = ("-std=c99", "-O3", "-mavx2", "-fno-math-errno", "-fno-trapping-math", "-fno-ipa-icf", *math)
    command = (tool("gcc"), *flags, f"-I{package}")
    report = run(*command, "-fopt-info-vec-optimized", "-c", source, "-o", tmp_path / "rows.o")
    path = re.escape(str(package / inside(table, "geometry.h")))
    lines = {int(line) for line in re.findall(rf"{path}:(\d+):\d+: optimized: loop vectorized", report)}
    called = (core for line in lines for core in re.findall(r"DUALCAY_NAME\((\w+)_core\)", header[line]))
    cores = Counter("principal" if core == "returned" else core for core in called)  # v itself if it is the only one
    needed = levels(lower_chart(Cayley(order), table))
    most = 2 if "#define DUALCAY_SIMD " in run(*command, "-E", "-dM", source) else 1
    expected = Counter(row.kernel for row in table.public.values() if needed[row.kernel] <= most)
    assert expected + Counter(turn=turns) - cores == Counter()


@pytest.mark.parametrize(("minor", "asked"), [(34, False), (35, True)])
def test_vector_functions_are_asked_for_where_the_library_has_them(package, tmp_path, minor, asked):
    """Compare glibc 2.34 with 2.35, the first version with vector functions for tan and atan2 in libmvec."""
    text = f"#include <math.h>\n#undef __GLIBC_MINOR__\n#define __GLIBC_MINOR__ {minor}\n"
    source = written(tmp_path, "asked.c", text + '#include "dualcay.h"\n')
    command = (tool("gcc"), "-std=c99", "-DDUALCAY_SIMD_MATH", f"-I{package}", "-E", "-dM", source)
    assert ("#define DUALCAY_SIMD " in run(*command)) == asked


def test_the_package_installs_and_the_example_finds_it(folder, tmp_path):
    """Build the tests of one order, since those of others are compiled above."""
    cmake, place = tool("cmake"), tmp_path / "prefix"
    package = shutil.copytree(folder("c"), tmp_path / "kernels", ignore=shutil.ignore_patterns("test_*.c"))
    shutil.copy(folder("c") / "test_cayley3.c", package)
    run(cmake, "-S", package, "-B", tmp_path / "package")
    run(cmake, "--build", tmp_path / "package")
    assert "100% tests passed, 0 tests failed out of 2" in run(tool("ctest"), "--test-dir", tmp_path / "package")
    run(cmake, "--install", tmp_path / "package", "--prefix", place)
    installed = {path.relative_to(package) for path in package.rglob("*.h")} - {Path("differential.h")}
    include = place / "include" / "dualcay"
    assert {path.relative_to(include) for path in include.rglob("*.h")} == installed
    source = written(tmp_path, "installed.c", "#include <dualcay/rotation/cayley3.h>\n")
    config = next(place.rglob("dualcay.pc")).parent
    told = run("env", f"PKG_CONFIG_PATH={config}", tool("pkg-config"), "--cflags", "dualcay >= 0.1").split()
    run(tool("gcc"), "-fsyntax-only", *told, source)
    example = ROOT / "examples" / "c"
    run(cmake, "-S", example, "-B", tmp_path / "example", f"-DCMAKE_PREFIX_PATH={place}", "-DPython3_EXECUTABLE=/none")
    run(cmake, "--build", tmp_path / "example")
    assert "largest difference" in run(tmp_path / "example" / "screw_motion")


def test_projects_of_cpp_alone_add_two_folders_of_kernels(package, tmp_path):
    """Expect a program of C++ to find headers of both folders: cayley3 of one, its copy in the other."""
    second = tmp_path / "second"
    shutil.copytree(package, second)
    (second / "cayley3.h").rename(second / "again.h")
    text = "#include <dualcay/cayley3.h>\n#include <dualcay/again.h>\nint main() { return 0; }\n"
    written(tmp_path, "main.cpp", text)
    lines = [
        "cmake_minimum_required(VERSION 3.21)", "project(some LANGUAGES CXX)", f"add_subdirectory({package} first)",
        f"add_subdirectory({second} second)", "add_executable(some main.cpp)",
        "target_link_libraries(some PRIVATE dualcay::dualcay)",
    ]  # fmt: skip
    written(tmp_path, "CMakeLists.txt", "\n".join(lines) + "\n")
    said = run(tool("cmake"), "-S", tmp_path, "-B", tmp_path / "build")
    assert "Warning" not in said, said
    run(tool("cmake"), "--build", tmp_path / "build")


@pytest.mark.skipif(not shutil.which("cppcheck"), reason="cppcheck is not installed")
def test_deviations_from_misra_are_those_of_the_page(tmp_path):
    flight.headers(tmp_path)
    page = (ROOT / "docs" / "howto" / "flight.md").read_text(encoding="utf-8")
    assert set(flight.deviations(tmp_path)) == set(re.findall(r"^\| (\d+\.\d+) \|", page, re.MULTILINE))


@pytest.mark.skipif(not shutil.which("arm-none-eabi-gcc"), reason="no compiler for Arm is installed")
@pytest.mark.skipif(not shutil.which("qemu-system-arm"), reason="no emulator of Arm boards is installed")
def test_results_agree_on_an_emulated_processor_as_on_the_page(package, tmp_path):
    page = (ROOT / "docs" / "howto" / "flight.md").read_text(encoding="utf-8")
    [start] = re.findall(r"^```\{code-block\} c\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    written(tmp_path, "start.c", start)
    (tmp_path / "kernels").symlink_to(package)
    commands = page.split("-o kernels\n")[1].partition("```")[0].replace("cayley2", "cayley3")
    assert "calls agree" in run("sh", "-ec", commands, cwd=tmp_path)


def test_no_function_calls_itself_loops_or_returns_early(package):
    """Expect calls of functions above only, loops over rows only, and no static data, as docs/howto/flight.md says."""
    for table in TABLES:
        text = (package / inside(table, "geometry.h")).read_text(encoding="utf-8")
        bodies = re.findall(r"DUALCAY_NAME\((\w+)\)\([^;{]*\)\n\{\n(.*?)^\}", text, re.MULTILINE | re.DOTALL)
        seen: set[str] = set()
        for name, body in bodies:
            assert set(re.findall(r"DUALCAY_NAME\((\w+)\)", body)) <= seen, name
            assert not re.search(r"\b(while|goto|return|static|alloc)\b", body), name
            loops = re.findall(r"\bfor \(.*", body)
            assert not loops if not name.endswith("_rows") else set(loops) == {"for (size_t j = 0; j < n; ++j) {"}, name
            seen.add(name)
        assert len(seen) > 2 * len(table.public)


def test_example_generates_missing_headers(tmp_path):
    cmake = tool("cmake")
    options = (f"-DPython3_EXECUTABLE={sys.executable}", "-DDUALCAY_ORDERS=3")
    alone = "-DCMAKE_DISABLE_FIND_PACKAGE_dualcay=ON"
    run(cmake, "-S", ROOT / "examples" / "c", "-B", tmp_path, *options, alone)
    run(cmake, "--build", tmp_path)
    assert "largest difference" in run(tmp_path / "screw_motion")
