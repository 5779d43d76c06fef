/* The Nomadic client: each command is one request, whose reply carries all of State, as the
   vendor's client fills State from reply packets. */
#include <Nclient.h>
#include <crs_request.h>
#include <stdio.h>

#include <crs/clock.h>

/* No initialiser: a program may define State itself, as some do (C17 6.9.2). */
long State[NUM_STATE];
int Smask[NUM_MASK] = {
    0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
};
char SERVER_MACHINE_NAME[80];
int SERV_TCP_PORT = 7019;

static int connected, greeted;

/* Posts a request and takes State[first] to State[last] from the reply. */
static int exchange(int code, struct __crs_message *message, int first, int last)
{
    const int *numbers = (const int *)message->data;
    int result, i;

    if (!connected) {
        printf("Not connected to any robot\n");
        return FALSE;
    }
    result = __crs_request(code, message);
    for (i = first; i <= last; i++)
        State[i] = numbers[i];
    if (__crs_after_request != NULL)
        __crs_after_request();
    return result != 0;
}

static int command(int code, int a, int b, int c, int d)
{
    struct __crs_message message;

    message.i[0] = a;
    message.i[1] = b;
    message.i[2] = c;
    message.i[3] = d;
    message.size = 0;
    return exchange(code, &message, 0, NUM_STATE - 1);
}

static int read_group(int code, int first, int last)
{
    struct __crs_message message;

    message.size = 0;
    return exchange(code, &message, first, last);
}

static int magnitude(int value)
{
    return value < 0 ? -value : value;
}

/* On success the vendor's client gives the port that the server told it, which is never 1. */
int connect_robot(long id, ...)
{
    if (!greeted)
        fprintf(stderr, "Nclient version 2.7\n"
                        "Copyright 1991-1998, Nomadic Technologies, Inc.\n");
    greeted = connected = 1;
    if (command(CRS_CONNECT, id, 0, 0, 0))
        return SERV_TCP_PORT > 1 ? SERV_TCP_PORT : 7019;
    connected = 0;
    State[STATE_ERROR] = 111;
    printf("failed to connect to server on machine %s via tcp port #%d\n", SERVER_MACHINE_NAME,
           SERV_TCP_PORT);
    return FALSE;
}

int disconnect_robot(long id)
{
    int result = command(CRS_DISCONNECT, id, 0, 0, 0);

    connected = 0;
    return result;
}

/* The order ends with 255 or after sixteen sonars; without one no sonar fires. */
int conf_sn(int rate, int order[16])
{
    struct __crs_message message;
    int size = 0;

    while (order != NULL && size < 16 && (order[size] & 255) != 255) {
        message.data[size] = order[size];
        size++;
    }
    message.size = size;
    message.i[0] = rate & 255;
    return exchange(CRS_CONF_SN, &message, 0, NUM_STATE - 1);
}

int conf_tm(unsigned char timeout)
{
    return command(CRS_CONF_TM, timeout, 0, 0, 0);
}

int ac(int trans, int steer, int turret)
{
    return command(CRS_AC, magnitude(trans), magnitude(steer), magnitude(turret), 0);
}

int sp(int trans, int steer, int turret)
{
    return command(CRS_SP, magnitude(trans), magnitude(steer), magnitude(turret), 0);
}

int pr(int trans, int steer, int turret)
{
    return command(CRS_PR, trans, steer, turret, 0);
}

int vm(int trans, int steer, int turret)
{
    return command(CRS_VM, trans, steer, turret, 0);
}

/* The vendor's client sends no other modes than these. */
static int is_sent(int mode)
{
    return mode >= MV_IGNORE && mode <= MV_SP;
}

int mv(int t_mode, int t_mv, int s_mode, int s_mv, int r_mode, int r_mv)
{
    struct __crs_message message;

    if (!is_sent(t_mode) || !is_sent(s_mode) || !is_sent(r_mode))
        return FALSE;
    message.i[0] = t_mode;
    message.i[1] = t_mv;
    message.i[2] = s_mode;
    message.i[3] = s_mv;
    message.i[4] = r_mode;
    message.i[5] = r_mv;
    message.size = 0;
    return exchange(CRS_MV, &message, 0, NUM_STATE - 1);
}

int st(void)
{
    return command(CRS_ST, 0, 0, 0, 0);
}

int lp(void)
{
    return command(CRS_LP, 0, 0, 0, 0);
}

int ws(unsigned char trans, unsigned char steer, unsigned char turret, unsigned char timeout)
{
    return command(CRS_WS, trans != 0, steer != 0, turret != 0, timeout);
}

int dp(int x, int y)
{
    return command(CRS_DP, x, y, 0, 0);
}

int da(int th, int tu)
{
    return command(CRS_DA, th, tu, 0, 0);
}

int zr(void)
{
    return command(CRS_ZR, 0, 0, 0, 0);
}

int gs(void)
{
    return command(CRS_GS, 0, 0, 0, 0);
}

int get_sn(void)
{
    return read_group(CRS_GET_SN, STATE_SONAR_0, STATE_SONAR_15);
}

int sonarSensorCheck(void)
{
    return read_group(CRS_GET_SN, STATE_SONAR_0, STATE_SONAR_15);
}

int get_bp(void)
{
    return read_group(CRS_GET_BP, STATE_BUMPER, STATE_BUMPER);
}

int get_rc(void)
{
    return read_group(CRS_GET_RC, STATE_CONF_X, STATE_CONF_TURRET);
}

int get_rv(void)
{
    return read_group(CRS_GET_RV, STATE_VEL_TRANS, STATE_VEL_TURRET);
}

#undef scout_vm

int scout_vm(int trans, int steer)
{
    return command(CRS_VM, RIGHT(trans, steer), LEFT(trans, steer), 0, 0);
}

int scout_pr(int trans, int steer)
{
    return command(CRS_PR, RIGHT(trans, steer), LEFT(trans, steer), 0, 0);
}

/* Waits for both wheels, `seconds` at most. */
int scout_ws(int seconds)
{
    return command(CRS_WS, 1, 1, 0, seconds & 255);
}
