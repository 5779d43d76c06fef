/* One command is one exchange: a request is sent to the robot, and its reply fills State, as the
   vendor's client fills it from reply packets. */
#include <stdio.h>

#include <crs/clock.h>
#include <crs/robot.h>

struct __crs_client __crs_client;

int __crs_is_direct(void)
{
    static int known, direct;
    struct __crs_message message;

    if (!known) {
        message.size = 0;
        direct = __crs_request(CRS_CLIENT, &message);
        known = 1;
    }
    return direct;
}

int __crs_is_direct_without_sensors(void)
{
    return __crs_is_direct() && __crs_client.model != MODEL_N200;
}

/* The vendor's messages do not name the call. */
static void complain_of_no_connection(void)
{
    static int told;
    struct __crs_message message;

    printf("Not connected to any robot\n");
    message.size = 0;
    if (!told)
        __crs_request(CRS_UNCONNECTED, &message);
    told = 1;
}

/* A robot answers unknown requests with a packet of its own, which Ndirect does not take
   for an error. */
static void note_refusal(void)
{
    if (__crs_is_direct())
        printf("Nak\n");
    else
        State[STATE_ERROR] = CRS_REFUSED;
}

int __crs_was_refused(void)
{
    return __crs_is_direct() && __crs_client.connected;
}

int __crs_is_reached(void)
{
    if (!__crs_client.connected)
        complain_of_no_connection();
    return __crs_client.connected && !__crs_client.left;
}

static int is_answered(void)
{
    if (__crs_is_reached())
        return TRUE;
    if (!__crs_is_direct())
        State[STATE_ERROR] = CRS_IPC_ERROR;
    return FALSE;
}

static int request(int code, struct __crs_message *message)
{
    int result = __crs_request(code, message);

    if (__crs_after_request != NULL)
        __crs_after_request();
    return result;
}

int __crs_post(int code, struct __crs_message *message)
{
    int result;

    if (!is_answered())
        return FALSE;
    result = request(code, message);
    if (result == 0 && code != CRS_MOTION_CHECK)
        note_refusal();
    return result;
}

int __crs_tell(int code, struct __crs_message *message, int *result)
{
    int done;

    if (!is_answered())
        return FALSE;
    done = message == NULL ? 0 : request(code, message);
    if (result != NULL)
        *result = done;
    return TRUE;
}

/* What the robot replies to: the motor status, and what the mask selects. Ndirect's packets lack
   the speed of the simulation and the laser's mode. */
static int is_sent(int index)
{
    if (index == STATE_SIM_SPEED || (index == STATE_LASER && __crs_is_direct()))
        return !__crs_is_direct();
    return index == STATE_MOTOR_STATUS || (signed char)__crs_client.mask[index] > 0;
}

/* Nclient copies all that the server has, and the server keeps the elements that are masked as
   they were; so these lose what the program itself has written there. */
static void copy_state(const int *numbers)
{
    static int board[NUM_MASK];
    int i;

    for (i = 0; i < NUM_MASK; i++)
        if (is_sent(i))
            State[i] = board[i] = numbers[i];
        else if (!__crs_is_direct())
            State[i] = board[i];
}

void __crs_take_board_time(const struct __crs_message *message)
{
    __crs_client.board_ms = (unsigned long)(long long)message->f[0];
}

int __crs_post_state(int code, struct __crs_message *message)
{
    const int *numbers = (const int *)message->data;
    int points;

    if (!__crs_post(code, message))
        return __crs_was_refused();
    copy_state(numbers);
    if (!__crs_is_direct())
        State[STATE_ERROR] = 0;
    __crs_take_board_time(message);
    __crs_client.cpu_battery = message->i[1];
    __crs_client.motor_battery = message->i[2];
    points = message->i[0];
    if ((signed char)__crs_client.mask[SMASK_LASER] > 0)
        __crs_read_laser(Laser, points, 0);
    return TRUE;
}

int __crs_command(int code, int a, int b, int c, int d)
{
    struct __crs_message message;

    message.i[0] = a;
    message.i[1] = b;
    message.i[2] = c;
    message.i[3] = d;
    message.size = 0;
    return __crs_post_state(code, &message);
}

static int read_group(int code, int first, int last, int tells_time)
{
    struct __crs_message message;
    const int *numbers = (const int *)message.data;
    int i;

    message.size = 0;
    if (!__crs_post(code, &message))
        return __crs_was_refused();
    for (i = first; i <= last; i++)
        State[i] = numbers[i];
    if (tells_time)
        __crs_take_board_time(&message);
    return TRUE;
}

int __crs_read_group(int code, int first, int last)
{
    return read_group(code, first, last, 0);
}

int __crs_read_sensors(int code, int first, int last)
{
    return read_group(code, first, last, 1);
}

int __crs_wired(int value)
{
    unsigned int magnitude, high;

    if (!__crs_is_direct())
        return value;
    magnitude = value < 0 ? 0u - (unsigned int)value : (unsigned int)value;
    high = ((value < 0 ? 128 : 0) + magnitude / 256) & 255;
    value = (int)(high % 128 * 256 + magnitude % 256);
    return high > 127 ? -value : value;
}
