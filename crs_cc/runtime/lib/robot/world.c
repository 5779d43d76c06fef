/* The simulator's world: obstacles, robot poses, predictions. Under Ndirect there is
   none, and these functions do nothing. */
#include <string.h>

#include <crs/robot.h>

static int is_polygon(const long *obs)
{
    return obs[0] >= 0 && obs[0] <= MAX_VERTICES;
}

static void put_polygon(struct __crs_message *message, const long *obs)
{
    message->i[0] = obs[0];
    message->size = 8 * obs[0];
    memcpy(message->data, obs + 1, message->size);
}

static int post_polygon(int code, const long *obs)
{
    struct __crs_message message;

    if (__crs_is_direct())
        return TRUE;
    if (!is_polygon(obs))
        return __crs_tell(code, NULL, NULL);
    put_polygon(&message, obs);
    return __crs_tell(code, &message, NULL);
}

static int move_polygon(long *obs, long dx, long dy)
{
    struct __crs_message message;
    int done = 0;

    if (__crs_is_direct())
        return TRUE;
    if (!is_polygon(obs))
        return __crs_tell(CRS_MOVE_OBSTACLE, NULL, NULL);
    put_polygon(&message, obs);
    message.i[1] = dx;
    message.i[2] = dy;
    if (!__crs_tell(CRS_MOVE_OBSTACLE, &message, &done))
        return FALSE;
    if (done)
        memcpy(obs + 1, message.data, 8 * obs[0]);
    return TRUE;
}

int add_obstacle(long obs[2 * MAX_VERTICES + 1])
{
    return post_polygon(CRS_ADD_OBSTACLE, obs);
}

int add_Obs(long obs[2 * MAX_VERTICES + 1])
{
    return post_polygon(CRS_ADD_OBSTACLE, obs);
}

int delete_obstacle(long obs[2 * MAX_VERTICES + 1])
{
    return post_polygon(CRS_DELETE_OBSTACLE, obs);
}

int delete_Obs(long obs[2 * MAX_VERTICES + 1])
{
    return post_polygon(CRS_DELETE_OBSTACLE, obs);
}

int move_obstacle(long obs[2 * MAX_VERTICES + 1], long dx, long dy)
{
    return move_polygon(obs, dx, dy);
}

int move_Obs(long obs[2 * MAX_VERTICES + 1], long dx, long dy)
{
    return move_polygon(obs, dx, dy);
}

int new_world(void)
{
    struct __crs_message message;

    if (__crs_is_direct())
        return TRUE;
    message.size = 0;
    return __crs_tell(CRS_NEW_WORLD, &message, NULL);
}

/* State stays as it is; Ndirect has dp and da do it. */
int place_robot(int x, int y, int th, int tu)
{
    struct __crs_message message;

    if (__crs_is_direct())
        return __crs_command(CRS_DP, __crs_wired(x), __crs_wired(y), 0, 0)
            && __crs_command(CRS_DA, __crs_wired(th), __crs_wired(tu), 0, 0);
    message.i[0] = x;
    message.i[1] = y;
    message.i[2] = th;
    message.i[3] = tu;
    message.size = 0;
    return __crs_tell(CRS_PLACE_ROBOT, &message, NULL);
}

/* Twenty robots fit into a reply. */
int get_rpx(long *robot_pos)
{
    struct __crs_message message;
    int robots, taken = 0;

    if (__crs_is_direct()) {
        *robot_pos = -1;
        return FALSE;
    }
    do {
        message.i[0] = taken / 3;
        message.size = 0;
        robots = __crs_post(CRS_GET_RPX, &message);
        if (robots <= 0)
            return FALSE;
        memcpy(robot_pos + 1 + taken, message.data, message.size);
        taken += message.size / 4;
    } while (message.size > 0 && taken < 3 * robots);
    robot_pos[0] = robots;
    return TRUE;
}

int predict_sensors(int x, int y, int th, int tu, long *state, int *laser)
{
    struct __crs_message message;
    const int *numbers = (const int *)message.data;
    int i, done;

    if (__crs_is_direct())
        return TRUE;
    message.i[0] = x;
    message.i[1] = y;
    message.i[2] = th;
    message.i[3] = tu;
    message.size = 0;
    if (!__crs_tell(CRS_PREDICT, &message, &done))
        return FALSE;
    if (!done)
        return TRUE;
    for (i = STATE_IR_0; i <= STATE_SONAR_15; i++)
        state[i] = numbers[i];
    for (; i < NUM_STATE; i++)
        state[i] = 0;
    if (laser != NULL)
        __crs_read_laser(laser, message.i[0], 1);
    return TRUE;
}

/* A number as the vendor's client sends it: cut off after some digits, 32 bits wide. */
static double cut(double value, double steps)
{
    double whole = value * steps;

    if (!(whole > -2147483648.0 && whole < 2147483648.0))
        return 0;
    return (long)whole / steps;
}

int motion_check(long type, double a1, double a2, double a3, double a4, double a5, double a6,
                 double a7, double collide[3])
{
    struct __crs_message message;
    double *path = (double *)message.data, angular = type == 0 ? 100 : 1000000;

    if (__crs_is_direct())
        return FALSE;
    message.i[0] = type;
    path[0] = cut(a1, 100);
    path[1] = cut(a2, 100);
    path[2] = cut(a3, angular);
    path[3] = cut(a4, angular);
    path[4] = type == 0 ? 0 : cut(a5, 100);
    path[5] = type == 0 ? 0 : cut(a6, 100);
    path[6] = type == 0 ? 0 : cut(a7, 100);
    message.size = 7 * sizeof *path;
    if (!__crs_post(CRS_MOTION_CHECK, &message))
        return FALSE;
    collide[0] = cut(message.f[0], 100);
    collide[1] = cut(message.f[1], 100);
    collide[2] = cut(message.f[2], 1000000);
    return TRUE;
}

int get_robot_conf(long *conf)
{
    struct __crs_message message;
    int i;

    if (__crs_is_direct())
        return TRUE;
    if (!__crs_is_reached())
        return FALSE;   /* State[STATE_ERROR] stays */
    message.size = 0;
    if (!__crs_post(CRS_GET_CONF, &message))
        return FALSE;
    for (i = 0; i < 4; i++)
        conf[i] = message.i[i];
    return TRUE;
}
