/* The laser's readings: points or segments, which the robot hands over in pages. */
#include <crs/robot.h>

#define ROOM (2 * NUM_LASER)

void __crs_read_laser(int *laser, int count, int predicted)
{
    struct __crs_message message;
    const int *page = (const int *)message.data;
    int size, reading = 0, taken = 0, i;

    laser[0] = count;
    while (reading < count) {
        message.i[0] = reading;
        message.i[1] = predicted;
        message.size = 0;
        size = __crs_request(CRS_LASER_PAGE, &message);
        if (size <= 0)
            return;
        reading += size;
        for (i = 0; i < size * message.i[0] && taken < ROOM; i++)
            laser[++taken] = page[i];
    }
}

static int read_readings(int code)
{
    struct __crs_message message;

    if (__crs_is_direct_without_sensors())
        return FALSE;
    message.size = 0;
    if (!__crs_post(code, &message))
        return __crs_was_refused();
    __crs_take_board_time(&message);
    __crs_read_laser(Laser, message.i[0], 0);
    return TRUE;
}

int get_ls(void)
{
    return read_readings(CRS_GET_LS);
}

int get_sg(void)
{
    return read_readings(CRS_GET_SG);
}

/* Like the vendor's it copies one number for each reading in Laser, though a point has two. */
int get_laser(int laser[2 * NUM_LASER + 1])
{
    int i;

    for (i = 0; i <= Laser[0] && i <= ROOM; i++)
        laser[i] = Laser[i];
    return TRUE;
}
