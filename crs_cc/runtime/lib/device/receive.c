/* Receiving messages, immediately or by waiting, and group membership. */
#include <crs/device.h>
#include <string.h>

int crs_receive(struct crs_message *message, int milliseconds)
{
    struct __crs_message reply;

    if (!__crs_ask_device(CRS_RECEIVE, &reply, milliseconds, 0, 0, 0))
        return 0;
    message->from = reply.i[0];
    message->to = reply.i[1];
    message->group = reply.i[2];
    message->type = reply.i[3];
    message->channel = reply.i[4];
    message->sent = (int)(reply.f[0] * 1000.0 + 0.5);
    message->arrived = (int)(reply.f[1] * 1000.0 + 0.5);
    message->size = reply.size;
    memcpy(message->data, reply.data, reply.size);
    message->data[reply.size] = '\0';
    return 1;
}

int crs_message_count(void)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_MESSAGE_COUNT, &message, 0, 0, 0, 0) ? message.i[0] : 0;
}

int crs_join_group(int group)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_GROUP, &message, group, 1, 0, 0);
}

int crs_leave_group(int group)
{
    struct __crs_message message;

    return __crs_ask_device(CRS_GROUP, &message, group, 0, 0, 0);
}
