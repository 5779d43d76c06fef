/* Speech: the robot's words are written to standard output. */
#include <stdio.h>
#include <string.h>

#include <crs/robot.h>

/* Ndirect on a robot that is its own host writes to its synthesizer, which is not there. */
int tk(char *talk)
{
    struct __crs_message message;
    size_t length = strlen(talk);

    if (__crs_is_direct_without_sensors())
        return FALSE;
    message.size = length < sizeof message.data ? length : sizeof message.data;
    memcpy(message.data, talk, message.size);
    if (!__crs_tell(CRS_TK, &message, NULL))
        return FALSE;
    printf("%s\n", talk);
    return __crs_is_direct() ? __crs_command(CRS_GS, 0, 0, 0, 0) : TRUE; /* it replies with State */
}
