/* The simulator's window: drawing into it, and erasing. Under Ndirect there is none; the vendor's
   Ndirect lacks the refresh functions, with ours they do nothing. */
#include <crs/robot.h>

enum { ROBOT, LINE, ARC };

static int post(int code, struct __crs_message *message)
{
    if (__crs_is_direct())
        return TRUE;
    message->size = 0;
    return __crs_tell(code, message, NULL);
}

int draw_robot(long x, long y, int th, int tu, int mode)
{
    struct __crs_message message = {{ROBOT, x, y, th, tu, 0, 0, mode}};

    return post(CRS_DRAW, &message);
}

int draw_line(long x_1, long y_1, long x_2, long y_2, int mode)
{
    struct __crs_message message = {{LINE, x_1, y_1, x_2, y_2, 0, 0, mode}};

    return post(CRS_DRAW, &message);
}

int draw_arc(long x_0, long y_0, long w, long h, int th1, int th2, int mode)
{
    struct __crs_message message = {{ARC, x_0, y_0, w, h, th1, th2, mode}};

    return post(CRS_DRAW, &message);
}

static int refresh(int what)
{
    struct __crs_message message = {{what}};

    return post(CRS_REFRESH, &message);
}

int refresh_all(void)
{
    return refresh(0);
}

int refresh_all_traces(void)
{
    return refresh(1);
}

int refresh_actual_trace(void)
{
    return refresh(2);
}

int refresh_encoder_trace(void)
{
    return refresh(3);
}

int refresh_all_sensors(void)
{
    return refresh(4);
}

int refresh_bumper_sensor(void)
{
    return refresh(5);
}

int refresh_infrared_sensor(void)
{
    return refresh(6);
}

int refresh_sonar_sensor(void)
{
    return refresh(7);
}

int refresh_laser_sensor(void)
{
    return refresh(8);
}

int refresh_client_graphics(void)
{
    return refresh(9);
}
