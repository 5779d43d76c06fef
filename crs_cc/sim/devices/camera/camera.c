/* The camera's columns and blobs, transferred as numbers, page by page. */
#include <crs/device.h>

static int look(int blobs, int *numbers, int most)
{
    struct __crs_message message;

    if (!__crs_ask_device(CRS_CAMERA, &message, blobs, 0, 0, 0))
        return 0;
    return __crs_take_readings(CRS_SENSOR_CAMERA, message.i[0], numbers, most);
}

int crs_camera(struct crs_pixel *row, int most)
{
    return look(0, (int *)row, most);
}

int crs_blobs(struct crs_blob *blobs, int most)
{
    return look(1, (int *)blobs, most);
}
