/* Moving: the commands of the motors. On the Scout axis 1 is the right wheel, axis 2 the left. */
#include <crs/robot.h>

static int magnitude(int value)
{
    return value < 0 ? -value : value;
}

/* Sends three numbers with their signs. */
static int axes(int code, int trans, int steer, int turret)
{
    return __crs_command(code, __crs_wired(trans), __crs_wired(steer), __crs_wired(turret), 0);
}

/* Sends three numbers without their signs. */
static int magnitudes(int code, int trans, int steer, int turret)
{
    return __crs_command(code, magnitude(trans), magnitude(steer), magnitude(turret), 0);
}

int ac(int trans, int steer, int turret)
{
    return magnitudes(CRS_AC, trans, steer, turret);
}

int sp(int trans, int steer, int turret)
{
    return magnitudes(CRS_SP, trans, steer, turret);
}

int pr(int trans, int steer, int turret)
{
    return axes(CRS_PR, trans, steer, turret);
}

/* The way to an angle in tenths of degrees, the shorter one. */
static int way_to(int angle, long from)
{
    int way = (angle - (int)from) % 3600;

    return way > 1800 ? way - 3600 : way < -1800 ? way + 3600 : way;
}

static int is_known(int mode)
{
    return mode >= MV_IGNORE && mode <= MV_SP;
}

/* Ndirect sends every mode; the robot ignores those that it does not know. */
static int is_sent(int mode)
{
    return is_known(mode) || __crs_is_direct();
}

static int moved(int t_mode, int t_mv, int s_mode, int s_mv, int r_mode, int r_mv)
{
    struct __crs_message message;

    if (!is_sent(t_mode) || !is_sent(s_mode) || !is_sent(r_mode))
        return FALSE;
    message.i[0] = is_known(t_mode) ? t_mode : MV_IGNORE;
    message.i[1] = __crs_wired(t_mv);
    message.i[2] = is_known(s_mode) ? s_mode : MV_IGNORE;
    message.i[3] = __crs_wired(s_mv);
    message.i[4] = is_known(r_mode) ? r_mode : MV_IGNORE;
    message.i[5] = __crs_wired(r_mv);
    message.size = 0;
    return __crs_post_state(CRS_MV, &message);
}

/* The vendor's Nclient sends nothing, and his Ndirect only to a Nomad 200. The distance since its
   start is not known, so only steering and turret move. */
int pa(int trans, int steer, int turret)
{
    if (!__crs_is_direct() || __crs_is_direct_without_sensors())
        return FALSE;
    return moved(MV_IGNORE, 0, MV_PR, way_to(steer, State[STATE_CONF_STEER]), MV_PR,
                 way_to(turret, State[STATE_CONF_TURRET]));
}

int vm(int trans, int steer, int turret)
{
    return axes(CRS_VM, trans, steer, turret);
}

int mv(int t_mode, int t_mv, int s_mode, int s_mv, int r_mode, int r_mv)
{
    return moved(t_mode, t_mv, s_mode, s_mv, r_mode, r_mv);
}

int st(void)
{
    return __crs_command(CRS_ST, 0, 0, 0, 0);
}

int lp(void)
{
    return __crs_command(CRS_LP, 0, 0, 0, 0);
}

int ws(unsigned char trans, unsigned char steer, unsigned char turret, unsigned char timeout)
{
    return __crs_command(CRS_WS, trans != 0, steer != 0, turret != 0, timeout);
}

int dp(int x, int y)
{
    return __crs_command(CRS_DP, __crs_wired(x), __crs_wired(y), 0, 0);
}

int da(int th, int tu)
{
    return __crs_command(CRS_DA, __crs_wired(th), __crs_wired(tu), 0, 0);
}

int zr(void)
{
    return __crs_command(CRS_ZR, 0, 0, 0, 0);
}
