/* Configuring: sensors, masks, the motors' timeout, the serial line. */
#include <stdio.h>

#include <crs/order.h>
#include <crs/robot.h>

int conf_sn(int rate, int order[16])
{
    struct __crs_message message;

    __crs_put_order(&message, order);
    message.i[0] = rate & 255;
    return __crs_post_state(CRS_CONF_SN, &message);
}

int conf_ir(int history, int order[16])
{
    struct __crs_message message;

    if (__crs_is_direct_without_sensors())
        return FALSE;
    __crs_put_order(&message, order);
    message.i[0] = history > 10 ? 10 : history & 255;
    return __crs_post_state(CRS_CONF_IR, &message);
}

int conf_cp(int mode)
{
    struct __crs_message message;

    if (__crs_is_direct_without_sensors())
        return FALSE;
    if (!__crs_is_direct())
        return __crs_command(CRS_CONF_CP, mode & 255, 0, 0, 0);
    message.i[0] = mode & 255;
    message.size = 0;
    if (!__crs_post(CRS_CONF_CP, &message))
        return __crs_was_refused();
    printf("compass calibration score x: 0 y: 0 z: 0\n");   /* a perfect one; State stays */
    return TRUE;
}

int conf_ls(unsigned int mode, unsigned int threshold, unsigned int width, unsigned int num_data,
            unsigned int processing)
{
    struct __crs_message message;

    if (__crs_is_direct_without_sensors())
        return FALSE;
    message.i[0] = mode & 255;
    message.i[1] = threshold & 255;
    message.i[2] = width & 255;
    message.i[3] = num_data & 0xFFFF;
    message.i[4] = processing & 255;
    message.size = 0;
    return __crs_post_state(CRS_CONF_LS, &message);
}

int conf_sg(unsigned int threshold, unsigned int min_points, unsigned int gap)
{
    if (__crs_is_direct_without_sensors())
        return FALSE;
    return __crs_command(CRS_CONF_SG, threshold & 255, min_points & 255, gap & 255, 0);
}

int conf_tm(unsigned char timeout)
{
    return __crs_command(CRS_CONF_TM, timeout, 0, 0, 0);
}

/* The vendor has it in Ndirect alone. */
int conf_ser(unsigned char port, unsigned short baud)
{
    if (__crs_client.model == MODEL_N200)
        return FALSE;
    return __crs_command(CRS_CONF_SER, port, baud, 0, 0);
}

/* Sends a mask, which is in use from now on. */
static int use_mask(const int *mask)
{
    struct __crs_message message;
    int i;

    for (i = 0; i < NUM_MASK; i++) {
        __crs_client.mask[i] = mask[i];
        message.data[i] = (signed char)mask[i] > 0;
    }
    message.data[SMASK_POS_DATA] = mask[SMASK_POS_DATA];
    message.size = NUM_MASK;
    return __crs_post_state(CRS_CT, &message);
}

static void fill_mask(void)
{
    int i;

    Smask[SMASK_POS_DATA] = 0;
    for (i = 1; i < NUM_MASK; i++)
        Smask[i] = 1;
}

int __crs_use_mask(void)
{
    if (__crs_is_direct_without_sensors())
        return FALSE;
    return use_mask(Smask);
}

int __crs_use_initial_mask(void)
{
    fill_mask();
    return __crs_use_mask();
}

int ct(void)
{
    return __crs_use_mask();
}

void init_mask(void)
{
    fill_mask();
}

int init_sensors(void)
{
    return __crs_use_initial_mask();
}

int get_mask(int mask[NUM_MASK])
{
    int i;

    for (i = 0; i < NUM_MASK; i++)
        mask[i] = __crs_client.mask[i];
    return TRUE;
}

int set_mask(int mask[NUM_MASK])
{
    int i;

    for (i = 0; i < NUM_MASK; i++)
        Smask[i] = mask[i];
    return TRUE;
}
