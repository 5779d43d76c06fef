/* Packets of the user's own to the robot, and the arm, which is driven by such packets. */
#include <stdio.h>
#include <string.h>

#include <crs/robot.h>

#define PROTOCOL 5   /* bytes around a packet that its length does not count */

static int exchange(const unsigned char *sent, unsigned char *received)
{
    struct __crs_message message;
    int length = sent[0] + 256 * sent[1];

    if (length > USER_BUFFER_LENGTH - PROTOCOL) {
        printf("Data + protocol bytes exceeding %d, truncating\n", USER_BUFFER_LENGTH);
        length = USER_BUFFER_LENGTH - PROTOCOL;
    }
    message.i[0] = length;
    message.size = length < CRS_DATA_SIZE ? length : CRS_DATA_SIZE;
    memcpy(message.data, sent, message.size);
    if (!__crs_post(CRS_SPECIAL, &message))
        return __crs_was_refused();
    memcpy(received, message.data, message.size);
    return TRUE;
}

int special_request(unsigned char *user_send_buffer, unsigned char *user_receive_buffer)
{
    return exchange(user_send_buffer, user_receive_buffer);
}

/* Sends numbers of two or four bytes to the arm; returns the number that it answers with, and a
   second one. */
static long ask_arm(int type, int count, const unsigned long *numbers, const int *sizes,
                    long *second)
{
    unsigned char sent[32] = {0}, received[CRS_DATA_SIZE] = {0};
    int length = 4, answer, i, byte;

    for (i = 0; i < count; i++)
        for (byte = 0; byte < sizes[i]; byte++)
            sent[length++] = numbers[i] >> 8 * byte;
    sent[0] = length;
    sent[3] = type;
    exchange(sent, received);
    if (second != NULL)
        memcpy(second, received + 8, 4);
    memcpy(&answer, received + 4, 4);
    return answer;
}

long arm_zr(short mode)
{
    const unsigned long numbers[] = {(unsigned short)mode};
    const int sizes[] = {2};

    return ask_arm(ARM_ZR, 1, numbers, sizes, NULL);
}

long arm_ws(short lift, short grip, long timeout, long *time_remain)
{
    const unsigned long numbers[] = {(unsigned short)lift, (unsigned short)grip, timeout};
    const int sizes[] = {2, 2, 4};

    return ask_arm(ARM_WS, 3, numbers, sizes, time_remain);
}

long arm_mv(long l_mode, long l_v, long g_mode, long g_v)
{
    const unsigned long numbers[] = {l_mode, l_v, g_mode, g_v};
    const int sizes[] = {4, 4, 4, 4};

    return ask_arm(ARM_MV, 4, numbers, sizes, NULL);
}
