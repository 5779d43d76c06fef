/* Reading: the whole State, or one group of it. */
#include <crs/robot.h>

int gs(void)
{
    return __crs_command(CRS_GS, 0, 0, 0, 0);
}

int get_ir(void)
{
    if (__crs_is_direct_without_sensors())
        return FALSE;
    return __crs_read_sensors(CRS_GET_IR, STATE_IR_0, STATE_IR_15);
}

int get_sn(void)
{
    return __crs_read_sensors(CRS_GET_SN, STATE_SONAR_0, STATE_SONAR_15);
}

int get_bp(void)
{
    return __crs_read_sensors(CRS_GET_BP, STATE_BUMPER, STATE_BUMPER);
}

int get_cp(void)
{
    if (__crs_is_direct_without_sensors())
        return FALSE;
    return __crs_read_sensors(CRS_GET_CP, STATE_COMPASS, STATE_COMPASS);
}

int get_rc(void)
{
    return __crs_read_group(CRS_GET_RC, STATE_CONF_X, STATE_CONF_TURRET);
}

int get_rv(void)
{
    return __crs_read_group(CRS_GET_RV, STATE_VEL_TRANS, STATE_VEL_TURRET);
}

/* The accelerations have no place in State; Nclient writes them over the speeds. */
int get_ra(void)
{
    struct __crs_message message;
    int i;

    message.size = 0;
    if (!__crs_post(CRS_GET_RA, &message))
        return __crs_was_refused();
    for (i = 0; i < 3 && !__crs_is_direct(); i++)
        State[STATE_VEL_TRANS + i] = message.i[3 + i];
    return TRUE;
}

int get_state(long state[NUM_STATE])
{
    int i;

    for (i = 0; i < NUM_STATE; i++)
        state[i] = State[i];
    return TRUE;
}
