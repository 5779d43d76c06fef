"""Programs as they were written: with their own names, without headers, in old C."""

from __future__ import annotations

import pytest

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.unit import compile_text
from crs_cc.session.library import library_options
from tests.nclient.drive import drive

OWN_MACROS = """
#define ROTATION_CONSTANT    0.118597  /* inches/degree */
#define RIGHT(trans, steer)  (trans + (int)((float)steer*ROTATION_CONSTANT))
#define LEFT(trans, steer)   (trans - (int)((float)steer*ROTATION_CONSTANT))
#define scout_vm(trans, steer)   vm(RIGHT(trans, steer), LEFT(trans, steer), 0)
#define scout_pr(trans, steer)   pr(RIGHT(trans, steer), LEFT(trans, steer), 0)
#define scout_ws(secs)           ws((unsigned char)1, (unsigned char)1, \\
                                    (unsigned char)0, (unsigned char)secs)
"""
QUARTER_TURN = """
int main(void)
{
    connect_robot(1);
    scout_pr(100, 0);
    scout_ws(60);
    scout_pr(0, 900);
    scout_ws(60);
    return 0;
}
"""


def warnings_of(text):
    diagnostics = Diagnostics()
    compile_text(text, "program.c", library_options(), diagnostics)
    return [each.text for each in diagnostics.messages if each.severity == "warning"]


@pytest.mark.function("pr", "ws", "vm")
@pytest.mark.parametrize(
    "head",
    [
        '#include "Nclient.h"\n' + OWN_MACROS,
        OWN_MACROS + "#include <Nclient.h>\n",
        "#include <Nclient.h>\n",
        OWN_MACROS,
        "",
    ],
    ids=["own behind", "own before", "ours", "own without header", "nothing"],
)
def test_the_scouts_macros(head):
    done = drive(head + QUARTER_TURN)
    assert done.x_in[-1] == pytest.approx(10, abs=0.05)
    assert done.heading_deg[-1] == pytest.approx(90, abs=1)


def test_macro_redefinition_warns_only_if_different():
    include = '#include "Nclient.h"\n'
    assert warnings_of(include + OWN_MACROS + "int unit;\n") == []
    assert warnings_of(OWN_MACROS + include + "int unit;\n") == []
    told = warnings_of(include + "#define LEFT(a, b) (b)\nint x = LEFT(1, 2);\n")
    assert len(told) == 1
    assert "LEFT" in told[0]


def test_macro_of_program_takes_precedence():
    done = drive("""
        #include <stdio.h>
        #include <Nclient.h>
        #undef LEFT
        #define LEFT(a, b) 42
        #define ROTATION 1
        int RIGHT = 7;
        int main(void) { printf("%d %d", LEFT(1, 2), RIGHT); return 0; }
    """)
    assert done.numbers == [42, 7]


@pytest.mark.function("connect_robot", "dp", "gs")
def test_program_may_define_client_variables():
    done = drive("""
        #include <stdio.h>
        #include "Nclient.h"
        long State[NUM_STATE];
        int Smask[NUM_MASK], Laser[2 * NUM_LASER + 1];
        char SERVER_MACHINE_NAME[80];
        int SERV_TCP_PORT = 7023;
        int main(void)
        {
            printf("%d ", connect_robot(1));
            dp(12, 34);
            printf("%ld %ld %d", State[STATE_CONF_X], State[STATE_CONF_Y], Smask[3]);
            return 0;
        }
    """)
    assert done.numbers == [7023, 12, 34, 1]


@pytest.mark.function("vm", "conf_tm", "conf_ser", "pa", "ac", "get_sn", "tk")
def test_program_without_header_runs():
    done = drive("""
        long State[45];
        main()
        {
            if (!connect_robot(1))
                return 1;
            conf_tm(5); ac(300, 300, 0); conf_ser(0, 9600);
            vm(100, 100, 0);
            sleep(2);
            st(), ws(1, 1, 0, 10);
            get_sn();
            tk("done");
            printf("%d %d\\n", pa(1, 2, 3), State[17]);
            return 0;
        }
    """)
    assert done.output[0] == "done\n0 255\n"
    assert done.x_in[-1] > 15


@pytest.mark.function("mv")
def test_mv_sends_only_known_modes():
    done = drive("""
        connect_robot(1);
        printf("%d %d ", mv(MV_PA, 1, MV_IGNORE, 0, MV_IGNORE, 0), mv(0, 0, 0, 0, -1, 0));
        printf("%d", mv(MV_PR, 100, MV_PR, 100, MV_IGNORE, 0));
        ws(1, 1, 0, 60);
    """)
    assert done.numbers == [0, 0, 1]
    assert done.x_in[-1] == pytest.approx(10, abs=0.01)


@pytest.mark.function("tk")
def test_speaking():
    assert drive('connect_robot(1); printf("%d", tk("hello world"));').output[0] == "hello world\n1"
    connect = 'connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);'
    silent = drive(f'{connect} return tk("hello");', client="ndirect")
    assert (silent.status, "hello" in silent.output[0]) == (0, False)


def test_writing_past_end_of_mask_is_reported():
    done = drive("int i; connect_robot(1); for (i = 0; i <= NUM_MASK; i++) Smask[i] = 1;")
    error = done.session.result().robots[0].error
    assert error is not None
    assert "past the end of 'Smask'" in error.text


@pytest.mark.parametrize(
    ("call", "meant"),
    [
        ("conect_robot(1)", "connect_robot"),
        ("get_sonar()", "get_sn"),
        ("State[STATE_SONAR_16]", "STATE_SONAR_1"),
        ("posSonarRingget(0)", "posSonarRingGet"),
    ],
)
def test_misspelt_name_is_reported_with_suggestion(call, meant):
    with pytest.raises(CompileError) as caught:
        drive(f"connect_robot(1); {call};")
    assert meant in "".join(each.render() for each in caught.value.diagnostics)


@pytest.mark.parametrize("use", ["State[0]", "SERV_TCP_PORT", "STATE_SONAR_0"])
def test_missing_header_is_suggested(use):
    with pytest.raises(CompileError) as caught:
        drive(f"int main(void) {{ return {use}; }}")
    assert "include <Nclient.h>" in "".join(each.render() for each in caught.value.diagnostics)


VENDORS_WAY = """
#ifndef _HOST_CLIENT_NCLIENT_H_
#define _HOST_CLIENT_NCLIENT_H_
#define NUM_STATE 45
#define STATE_CONF_X 34
extern long State[NUM_STATE];
int connect_robot(long robot_id, ...);
int vm(int t_vm, int s_vm, int r_vm);
int dp(int x, int y);
#endif
"""


@pytest.mark.function("connect_robot", "dp")
def test_program_may_bring_its_own_header():
    done = drive(VENDORS_WAY + """
        #include <stdio.h>
        #include "Nclient.h"
        int main(void) { connect_robot(1); dp(5, 6); printf("%ld", State[STATE_CONF_X]); return 0; }
    """)  # fmt: skip
    assert done.numbers == [5]


@pytest.mark.function("predict_sensors", "posSonarRingGet", "get_rpx")
def test_invalid_pointers_stop_only_their_program():
    for call in ("get_rpx(NULL)", "posSonarRingGet(NULL)", "get_state(NULL)", "tk(NULL)"):
        done = drive(f"connect_robot(1); posDataRequest(POS_SONAR); {call};")
        error = done.session.result().robots[0].error
        assert error is not None, call
        assert error.kind == "null pointer", call
