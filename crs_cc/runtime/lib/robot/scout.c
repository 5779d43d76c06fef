/* Functions that programs for the Scout commonly define for themselves; a program's own macros
   or functions of these names replace them. */
#include <crs/robot.h>

#undef scout_vm

static int wheels(int code, int trans, int steer)
{
    return __crs_command(code, __crs_wired(RIGHT(trans, steer)), __crs_wired(LEFT(trans, steer)),
                         0, 0);
}

int scout_vm(int trans, int steer)
{
    return wheels(CRS_VM, trans, steer);
}

int scout_pr(int trans, int steer)
{
    return wheels(CRS_PR, trans, steer);
}

/* Waits for both wheels, `seconds` at most. */
int scout_ws(int seconds)
{
    return __crs_command(CRS_WS, 1, 1, 0, seconds & 255);
}

int sonarSensorCheck(void)
{
    return __crs_read_sensors(CRS_GET_SN, STATE_SONAR_0, STATE_SONAR_15);
}
