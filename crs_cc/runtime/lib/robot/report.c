/* The commands of the CRS report, in its units, over the same requests as the vendor's client.

   A sensor's reading is stored in State when it is read, the rest of State with every command. A
   program need not connect: in the report, starting it connects the robot. */
#include <crs/clock.h>
#include <crs/order.h>
#include <crs/report.h>
#include <crs_request.h>
#include <stddef.h>

#undef vm

#define INCHES_PER_DEGREE 0.118597      /* that a wheel runs: the vendor's ROTATION_CONSTANT */
#define BOTH_MOTORS 3
#define LOOKS_AFTER_S 1
#define FARTHEST 1e9

static int is_connected = 1, has_greeted;

/* Nothing is seen before somebody looks. */
long State[NUM_STATE] = {
    [STATE_SONAR_0] = -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1,
};

/* Posts a request; a robot that was never connected is connected before the first one. */
static int post(int code, struct __crs_message *message)
{
    struct __crs_message greeting = {0};
    int result;

    if (!is_connected) {
        printf("Not connected to any robot\n");
        return FALSE;
    }
    if (!has_greeted)
        has_greeted = __crs_request(CRS_CONNECT, &greeting);
    result = __crs_request(code, message);
    if (__crs_after_request != NULL)
        __crs_after_request();
    return result != 0;
}

/* Posts a command whose reply is the vendor's State, and copies what no sensor of the
   report measures. */
static int exchange(int code, struct __crs_message *message)
{
    const int *numbers = (const int *)message->data;
    int i;

    if (!post(code, message))
        return FALSE;
    for (i = STATE_CONF_X; i < STATE_HEAT; i++)
        State[i] = numbers[i];
    return TRUE;
}

static int command(int code, int a, int b, int c, int d)
{
    struct __crs_message message;

    message.i[0] = a;
    message.i[1] = b;
    message.i[2] = c;
    message.i[3] = d;
    message.size = 0;
    return exchange(code, &message);
}

/* Posts a request that is answered in a form of its own. */
static int ask(int code, int argument, struct __crs_message *message)
{
    message->i[0] = argument;
    message->size = 0;
    return post(code, message);
}

/* Which robot it is, and how to reach it, is settled before the program starts. */
int connect_robot(int id, ...)
{
    struct __crs_message message;

    is_connected = has_greeted = 1;
    message.i[1] = 0;
    return ask(CRS_CONNECT, id, &message);
}

int disconnect_robot(int id)
{
    struct __crs_message message;
    int result = ask(CRS_DISCONNECT, id, &message);

    is_connected = 0;
    return result;
}

int conf_tm(int timeout)
{
    return command(CRS_CONF_TM, timeout & 255, 0, 0, 0);
}

int real_robot(void)
{
    struct __crs_message message;

    return ask(CRS_REAL_ROBOT, 0, &message);
}

int simulated_robot(void)
{
    struct __crs_message message;

    return ask(CRS_SIMULATED_ROBOT, 0, &message);
}

/* "The current implementation considers only the first parameter" (appendix A). */
int pr(int r_wheel, int l_wheel, int dummy)
{
    return command(CRS_PR, r_wheel, r_wheel, 0, 0);
}

static int nearest(double value)
{
    if (value > FARTHEST || value < -FARTHEST)
        value = value > 0 ? FARTHEST : -FARTHEST;
    return value == value ? (int)(value < 0 ? value - 0.5 : value + 0.5) : 0;
}

/* Both wheels at one speed, to the nearest 0.1 inch a second. */
int vm(double speed)
{
    return command(CRS_VM, nearest(speed), nearest(speed), 0, 0);
}

int vm_of_wheels(int r_wheel, int l_wheel, int dummy)
{
    return command(CRS_VM, r_wheel, l_wheel, 0, 0);
}

int mv(int r_mode, int r_value, int l_mode, int l_value, int dummy_mode, int dummy_value)
{
    struct __crs_message message;

    message.i[0] = r_mode;
    message.i[1] = r_value;
    message.i[2] = l_mode;
    message.i[3] = l_value;
    message.i[4] = message.i[5] = 0;
    message.size = 0;
    return exchange(CRS_MV, &message);
}

int st(void)
{
    return command(CRS_ST, 0, 0, 0, 0);
}

static int is_still(void)
{
    int has_arrived = (State[STATE_MOTOR_STATUS] & BOTH_MOTORS) == 0;

    return has_arrived || (State[STATE_VEL_RIGHT] == 0 && State[STATE_VEL_LEFT] == 0);
}

/* "Until the robot comes to a stand still" (appendix A), without a limit; a robot that
   is blocked stands still, too, though its motors do not rest. */
int ws(int x, int y, int z, int dummy)
{
    int result;

    do
        result = command(CRS_WS, 1, 1, 0, LOOKS_AFTER_S);
    while (result && !is_still());
    return result;
}

/* Travel of the left wheel for a rotation to the right, to the nearest 0.1 inch. The report's
   example "turns the robot to its right" (2.2.3), where the vendor's macro turns left. */
static int turning(int steer)
{
    return nearest(steer * INCHES_PER_DEGREE);
}

int scout_pr(int trans, int steer)
{
    return command(CRS_PR, trans - turning(steer), trans + turning(steer), 0, 0);
}

int scout_vm(int trans, int steer)
{
    return command(CRS_VM, trans - turning(steer), trans + turning(steer), 0, 0);
}

int dp(int x, int y)
{
    return command(CRS_DP, x, y, 0, 0);
}

static int magnitude(int value)
{
    return value < 0 ? -value : value;
}

int ac(int r_wheel, int l_wheel, int dummy)
{
    return command(CRS_AC, magnitude(r_wheel), magnitude(l_wheel), 0, 0);
}

int sp(int r_wheel, int l_wheel, int dummy)
{
    return command(CRS_SP, magnitude(r_wheel), magnitude(l_wheel), 0, 0);
}

int conf_sn(int rate, int order[])
{
    struct __crs_message message;

    __crs_put_order(&message, order);
    message.i[0] = rate & 255;
    return exchange(CRS_CONF_SN, &message);
}

static int read_sonars(int fires)
{
    struct __crs_message message;
    const int *tenths = (const int *)message.data;
    int i;

    if (!ask(CRS_SONAR, fires, &message))
        return FALSE;
    for (i = 0; i < 16; i++)
        State[STATE_SONAR_0 + i] = tenths[i];
    return TRUE;
}

/* The last readings of the sonars in the firing order. */
int get_sn(void)
{
    return read_sonars(0);
}

/* The readings of all sonars now. */
int sonarSensorCheck(void)
{
    return read_sonars(1);
}

int get_bp(void)
{
    struct __crs_message message;

    if (!ask(CRS_GET_BP, 0, &message))
        return FALSE;
    State[STATE_BUMPER] = ((const int *)message.data)[STATE_BUMPER] != 0;
    return TRUE;
}

int heatSensorCheck(void)
{
    struct __crs_message message;

    if (!ask(CRS_HEAT, 0, &message))
        return FALSE;
    State[STATE_HEAT] = message.i[0];
    return TRUE;
}

int tagTarget(void)
{
    struct __crs_message message;

    return ask(CRS_TAG, 0, &message);
}
