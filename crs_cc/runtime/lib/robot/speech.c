/* Speaking: what the robot says stands on standard output. */
#include <fcntl.h>
#include <stdio.h>
#include <string.h>

#include <crs/descriptor.h>
#include <crs/robot.h>

#define SYNTHESIZER "/dev/dbtk"

/* Ndirect writes to the synthesizer's device itself on a robot that is its own host. */
static int write_to_device(const char *text)
{
    int device = __crs_open(SYNTHESIZER, O_WRONLY | O_APPEND);

    if (device < 0)
        return FALSE;
    __crs_put(device, text, strlen(text));
    __crs_put(device, "\n", 1);
    __crs_close(device);
    return TRUE;
}

int tk(char *talk)
{
    struct __crs_message message;
    size_t length = strlen(talk);

    if (__crs_is_direct_without_sensors())
        return write_to_device(talk);
    message.size = length < sizeof message.data ? length : sizeof message.data;
    memcpy(message.data, talk, message.size);
    if (!__crs_post(CRS_TK, &message))
        return __crs_was_refused();
    printf("%s\n", talk);
    return TRUE;
}
